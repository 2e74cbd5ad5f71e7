# Tool libraries: outlines with arcs and overlapping pieces (VERICUT), and the dimensions of Fusion. The result is a
# setup that a check accepts.
need python3
small_machine
cat >mills.tls <<'EOF'
<?xml version="1.0"?>
<CGTechToolLibrary Version="6.2">
  <Tools>
    <Tool ID="==== Mills ====" Units="Millimeter"><Type>Milling</Type></Tool>
    <Tool ID="7" Units="Millimeter">
      <Description>barrel &lt;12&gt;</Description>
      <Cutter><SOR ID="C">
        <Pt><X>0</X><Z>0</Z></Pt><Pt><X>3</X><Z>0</Z></Pt>
        <Arc><X>3</X><Z>3</Z><Radius>3</Radius><Direction>CCW</Direction></Arc>
        <Pt><X>3</X><Z>6</Z></Pt><Pt><X>0</X><Z>6</Z></Pt>
      </SOR></Cutter>
      <Holder>
        <SOR ID="H"><Pt><X>0</X><Z>0</Z></Pt><Pt><X>4</X><Z>0</Z></Pt><Pt><X>4</X><Z>20</Z></Pt>
          <Arc><X>14</X><Z>20</Z><Radius>10</Radius><Direction>CW</Direction></Arc>
          <Pt><X>14</X><Z>30</Z></Pt><Pt><X>20</X><Z>41</Z></Pt><Pt><X>0</X><Z>41</Z></Pt>
          <Origin><X>0</X><Y>0</Y><Z>-1</Z></Origin></SOR>
        <Origin><X>0</X><Y>0</Y><Z>6</Z></Origin>
      </Holder>
      <GagePoint><X>0</X><Y>0</Y><Z>46</Z></GagePoint>
    </Tool>
    <Tool ID="8" Units="Inch">
      <Cutter><Apt ID="C" Type="BALL END"><D>0.5</D><R>0.25</R><H>2</H></Apt></Cutter>
      <GagePoint><X>0</X><Y>0</Y><Z>2</Z></GagePoint>
    </Tool>
    <Tool ID="9" Units="Millimeter">
      <Cutter><Apt ID="C" Type="DRILL"><D>8.5</D><A>31</A><H>80</H><FluteLength>50</FluteLength>
        <ShankDiameter>10</ShankDiameter></Apt></Cutter>
      <Holder><SOR ID="H"><Pt><X>0</X><Z>60</Z></Pt><Pt><X>20</X><Z>60</Z></Pt><Pt><X>20</X><Z>110</Z></Pt></SOR></Holder>
      <GagePoint><X>0</X><Y>0</Y><Z>110</Z></GagePoint>
    </Tool>
    <Tool ID="D10R1" Units="Millimeter">
      <Cutter><Apt ID="C" Type="BULL NOSE"><D>10</D><R>1</R><H>70</H></Apt></Cutter>
    </Tool>
    <Tool ID="10" Units="Millimeter"><Cutter><Apt ID="C" Type="APT 7"><D>3</D><H>10</H></Apt></Cutter></Tool>
    <Tool ID="11" Units="Millimeter"><Cutter><Insert Type="GENERAL INSERT C"/></Cutter></Tool>
  </Tools>
</CGTechToolLibrary>
EOF
fivecheck import --output v --number-tools mills.tls
python3 "$(dirname "$LIB")/../import/tools_truth.py" mills.tls v/setup.xml
"$FIVECHECK" --list-pairs -s v/setup.xml m.xml | grep -c '^[^	]*	T[0-9]* cutter'
sed -n '/number="9"/,/<\/tool>/p' v/setup.xml
fivecheck import --output w mills.tls 2>&1 | grep -v note
cat >fusion.json <<'EOF'
{"version": 2, "data": [
 {"type": "flat end mill", "unit": "millimeters", "description": "6 mm \"flat\" <a&b>\u0007",
  "geometry": {"DC": 6, "LB": 25, "LCF": 15, "OAL": 50, "SFDM": 6, "RE": 0, "shoulder-length": 18},
  "post-process": {"number": 1},
  "holder": {"unit": "millimeters", "gaugeLength": 45, "segments": [
    {"height": 15, "lower-diameter": 20, "upper-diameter": 30},
    {"height": 30, "lower-diameter": 40, "upper-diameter": 40},
    {"height": 60, "lower-diameter": 44, "upper-diameter": 20}]}},
 {"type": "drill", "unit": "inches", "geometry": {"DC": 0.25, "LB": 3, "LCF": 2, "SFDM": 0.25, "SIG": 118},
  "post-process": {"number": 2}},
 {"type": "chamfer mill", "unit": "millimeters", "geometry": {"DC": 10, "LB": 30, "LCF": 6, "SFDM": 8, "TA": 45,
  "tip-diameter": 2}, "post-process": {"number": 3}},
 {"type": "probe", "unit": "millimeters", "geometry": {"DC": 4, "LB": 50, "LCF": 4, "SFDM": 2},
  "post-process": {"number": 4}, "shaft": {"segments": [{"height": 20, "lower-diameter": 2, "upper-diameter": 2},
  {"height": 26, "lower-diameter": 2, "upper-diameter": 12}]}},
 {"type": "bull nose end mill", "unit": "millimeters", "geometry": {"DC": 10, "LB": 40, "LCF": 20, "SFDM": 12,
  "RE": 2, "assemblyGaugeLength": 100}, "post-process": {"number": 5}},
 {"type": "chamfer mill", "unit": "inches", "description": "V-bit, cut off within its cone", "geometry": {"DC": 0.125,
  "LB": 0.77, "LCF": 0.36, "SFDM": 0.125, "TA": 5, "tip-diameter": 0.004, "shoulder-length": 0.5}, "post-process": {"number": 8}},
 {"type": "dovetail mill", "geometry": {}, "post-process": {"number": 6}},
 {"type": "dovetail mill", "unit": "millimeters", "geometry": {"DC": 20, "LB": 40, "LCF": 10, "SFDM": 10, "TA": 30,
  "shoulder-diameter": 8.45, "shoulder-length": 20}, "post-process": {"number": 9}},
 {"type": "tapered mill", "unit": "inches", "geometry": {"DC": 0.0568, "RE": 0.03125, "LB": 1.5, "LCF": 1, "SFDM": 0.25, "TA": 5.5},
  "post-process": {"number": 10}},
 {"type": "tapered mill", "unit": "millimeters", "geometry": {"DC": 12, "RE": 2.5, "LB": 72, "LCF": 24, "SFDM": 20.46, "TA": 10},
  "post-process": {"number": 11}},
 {"type": "counter sink", "unit": "millimeters", "geometry": {"DC": 12, "LB": 24, "LCF": 5.4, "SFDM": 7.2, "SIG": 90,
  "tip-diameter": 1.2, "shoulder-length": 8.1}, "post-process": {"number": 12}},
 {"type": "lollipop mill", "unit": "millimeters", "geometry": {"DC": 12, "RE": 6, "LB": 36, "LCF": 10.8, "SFDM": 8,
  "shoulder-diameter": 6, "shoulder-length": 20}, "post-process": {"number": 13}},
 {"type": "lollipop mill", "unit": "millimeters", "geometry": {"DC": 6, "LB": 36, "LCF": 5, "SFDM": 4}, "post-process": {"number": 14}},
 {"type": "tapered mill", "geometry": {"DC": 1, "RE": 3, "LB": 72, "LCF": 24, "SFDM": 20, "TA": 10}, "post-process": {"number": 15}},
 {"type": "tapered mill", "geometry": {"DC": 1, "LB": 72, "LCF": 24, "TA": 0.096}, "post-process": {"number": 16}},
 {"type": "dovetail mill", "geometry": {"DC": 10, "LB": 40, "LCF": 10, "TA": 30, "RE": 1}, "post-process": {"number": 17}},
 {"type": "face mill", "geometry": {"DC": 40, "DCX": 50, "LB": 40, "LCF": 10}, "post-process": {"number": 18}},
 {"type": "face mill", "geometry": {"DC": 40, "DCX": 50, "LB": 40, "LCF": 10, "TA": 45}, "post-process": {"number": 19}},
 {"type": "face mill", "unit": "millimeters", "geometry": {"DC": 40, "DCX": 50, "LB": 40, "LCF": 5, "TA": 45, "SFDM": 22, "RE": 0.8},
  "post-process": {"number": 20}},
 {"type": "flat end mill", "unit": "millimeters", "geometry": {"DC": 2, "LB": 50, "LCF": 6, "SFDM": 6, "shoulder-length": 16,
  "shoulder-diameter": 1.9}, "post-process": {"number": 21, "length-offset": 71}, "shaft": {"segments": [
   {"height": 10, "lower-diameter": 1.9, "upper-diameter": 4}, {"height": 4, "lower-diameter": 4, "upper-diameter": 5}]},
  "holder": {"unit": "millimeters", "segments": [{"height": 20, "lower-diameter": 20, "upper-diameter": 30}]}},
 {"type": "ball end mill", "unit": "millimeters", "geometry": {"DC": 6, "LB": 25}, "post-process": {}},
 {"type": "ball end mill", "unit": "millimeters", "geometry": {"DC": 6}, "post-process": {"number": 7}}
]}
EOF
fivecheck import --output f fusion.json
cat f/setup.xml
python3 "$(dirname "$LIB")/../import/fusion_truth.py" fusion.json f/setup.xml
"$FIVECHECK" --list-pairs -s f/setup.xml m.xml | grep -c '^[^	]*	T[0-9]* cutter'
echo "the setup of the manual's first hour:"
mkdir hour
sed -n '/cat > setup.xml/,/<.setup>/p' "$(dirname "$LIB")/../../man/fivecheck.7" | sed '1d; s/Y="0" //' >hour/setup.xml
sed '/"number": 6/d; /"post-process": {}/d; s/, *$/,/' fusion.json >hour/tools.json
box part 0 0 0 10 10 10
mv part.stl hour
"$FIVECHECK" --list-pairs -s hour/setup.xml m.xml 2>/dev/null | grep -c bracket
echo "faults:"
fault() { # SED-SCRIPT FILE
	sed "$1" "$2" >bad.x
	"$FIVECHECK" import --output bad bad.x 2>&1 | grep -v warning
	[ ! -e bad ] || { echo "a folder was written"; rm -r bad; }
}
fault 's/"DC": 6/"DC": "6"/' fusion.json
fault 's/inches/feet/' fusion.json
fault 's/"number": 2/"number": 1/' fusion.json
fault 's/"height": 15/"height": -15/' fusion.json
fault 's/"data"/"tools"/' fusion.json
fault 's/"version": 2,/"version": 2/' fusion.json
fault 's/ID="8" Units="Inch"/ID="8" Units="Ell"/' mills.tls
fault 's/ID="8"/ID="7"/' mills.tls
fault 's/<Z>46</<Z>far</' mills.tls
fault 's/Tools>/Things>/' mills.tls
fault 's/<Apt ID="C" Type=/<Apt ID="C" Tqpe=/' mills.tls
printf 'G0 X1\n' >bad.nc
fault '' bad.nc
: >empty
fault '' empty
