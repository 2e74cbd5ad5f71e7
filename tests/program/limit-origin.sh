# A limit says what was commanded, by how much the axis goes past it, and which offsets led there.
box head -5 -5 -5 5 5 5
machine m.xml <<'XML'
  <axis name="X" type="linear" direction="1 0 0" limit_min="-50" limit_max="50" rate_max="6000">
    <axis name="Y" type="linear" direction="0 1 0" limit_min="-50" limit_max="50" rate_max="6000">
      <axis name="Z" type="linear" direction="0 0 1" limit_min="-50" limit_max="150" rate_max="6000">
        <body name="head" mesh="head.stl"/>
        <spindle location="0 0 -5" direction="0 0 -1"/>
      </axis>
    </axis>
  </axis>
XML
setup s.xml <<'XML'
  <work_offset name="G54" X="0" Y="0" Z="0"/>
  <work_offset name="G55" X="20" Y="-5" Z="-30"/>
  <tool number="1" length="60"><holder mesh="head.stl"/></tool>
XML
cat >p.nc <<'NC'
G21 G90 G94 T1 M6
G55
G0 X40
X0
G52 X2
X35
G52 X0
X0
G43 H1 Z125
G49 Z0
Z-25
G53 Z160
G28 Z160
G1 X20 Y5 F1000
G3 Y45 J20
M2
NC
fivecheck -a -q --parse-only -s s.xml m.xml p.nc | grep -E 'limit:|target|offset'
echo '== the same as data'
fivecheck -q -a --format=ndjson --parse-only -s s.xml m.xml p.nc | grep '"kind":"limit"' |
	python3 -c '
import json, sys
for line in sys.stdin:
    f = json.loads(line)
    print(f["line"], *[f[k] for k in ("axis", "bound", "target", "excess", "work_offset", "work", "shift", "tool_length")])'
echo '== where a report has one line for it'
head -n 3 p.nc >short.nc
fivecheck -q --format=github --parse-only -s s.xml m.xml short.nc | grep limit
fivecheck -q --format=sarif --parse-only -s s.xml m.xml short.nc |
	python3 -c '
import json, sys
for result in json.load(sys.stdin)["runs"][0]["results"]:
    if result["ruleId"] == "limit":
        print(result["message"]["text"])
        print({k: result["properties"][k] for k in ("target", "excess", "work_offset", "work")})'
fivecheck -q --format=junit --parse-only -s s.xml m.xml short.nc | grep -E 'target|offset'
