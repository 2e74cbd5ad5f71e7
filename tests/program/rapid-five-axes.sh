# A rapid of five axes whose path is not known, between two bodies that are near each other for most of it: its box is
# halved as often as five axes need, and the answer is a finding, not that the bodies cannot be decided.
box table -61 -76 -27 61 76 -3
box quill -5.5 -4.7 280 5.5 4.7 340
machine m.xml <<'XML'
  <axis name="Z" type="linear" direction="0 0 -1" rate_max="6000">
    <body name="table" mesh="table.stl"/>
  </axis>
  <axis name="Y" type="linear" direction="0 1 0" rate_max="6000">
    <axis name="X" type="linear" direction="1 0 0" rate_max="6000">
      <axis name="C" type="rotary" direction="0 0 1" location="7 0 450" rate_max="7200">
        <axis name="A" type="rotary" direction="1 0 0" location="3 7.5 466.6" rate_max="7200">
          <body name="quill" mesh="quill.stl"/>
        </axis>
      </axis>
    </axis>
  </axis>
XML
sed -i 's,<base>,<controller rapid="any"/><base>,' m.xml
cat >p.nc <<'NC'
G21 G90 G94 G1 F3000 Z-46.96
G1 A-30 C74.706
G1 X-196.466 Y91.85
G1 X-49.134 Y3.51 Z-285.85
G0 X-196.466 Y91.85 Z-46.96 A-1.25 C74.746
M2
NC
findings -a m.xml p.nc | cut -d ' ' -f 1-4
