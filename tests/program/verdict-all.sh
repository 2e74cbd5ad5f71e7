# --all: the first finding of each pair in each block; a pair that still violates when a block starts is reported
# at its fraction 0; two pairs in one block come in the order of time, at the same instant in the order of the XML.
box cube -5 -5 -5 5 5 5
box near 20 -50 -50 30 50 50
box far 50 -50 -50 60 50 50
box twin 50 -70 -50 60 -50 50
box wide -5 -60 -5 5 60 5
machine m.xml <<'XML'
  <body name="far" mesh="far.stl"/>
  <body name="near" mesh="near.stl"/>
  <body name="twin" mesh="twin.stl"/>
  <axis name="X" type="linear" direction="1 0 0" limit_min="-10" limit_max="300" rate_max="6000">
    <body name="wide" mesh="wide.stl"/>
    <body name="cube" mesh="cube.stl"/>
  </axis>
--
  <pairs>
    <pair a="base" b="X" check="always"/>
  </pairs>
XML
program through.nc <<'NC'
G1 X100 F600
G1 X55
G1 X0
NC
findings m.xml through.nc
findings -a m.xml through.nc
