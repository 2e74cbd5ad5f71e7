# An arm of 100 mm along X, 2 mm wide, turns by 90 degrees; a post is in its path: both ends of the block are free. The
# arm's edge y=1 meets the post's corner P = (70, 63.5) at the angle of P less asin(1/|P|).
box arm 0 -1 -1 100 1 1
box post 63 63.5 -10 70 70 10
machine m.xml <<'XML'
  <body name="post" mesh="post.stl"/>
  <axis name="C" type="rotary" direction="0 0 1" location="0 0 0" limit_min="-180" limit_max="180" rate_max="3600">
    <body name="arm" mesh="arm.stl"/>
  </axis>
--
  <pairs><pair a="post" b="arm" check="always"/></pairs>
XML
program turn.nc <<'NC'
G1 C90 F1000
NC
program back.nc <<'NC'
G1 C10 F1000
G1 C41.5
G1 C-30
G1 C41.59
NC
findings m.xml turn.nc | awk '{ printf "%s %s %.4f\n", $1, $3, $4 }'
awk 'BEGIN {
	x = 70; y = 63.5; s = 1 / sqrt(x * x + y * y)
	printf "%.4f\n", (atan2(y, x) - atan2(s, sqrt(1 - s * s))) / (2 * atan2(1, 1))
}'
# Before that angle everything is clear.
status fivecheck -q m.xml back.nc
