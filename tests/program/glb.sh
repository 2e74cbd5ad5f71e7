# The motion before a finding as glTF: an independent reader finds the same end position as --pose.
need python3
small_machine
setup s.xml <<'XML'
  <tool number="2" name="mill" length="60"><cutter><section length="60" diameter="10"/></cutter></tool>
  <tool number="3" name="other" length="50"><cutter><section length="50" diameter="10"/></cutter></tool>
XML
program a.nc <<'NC'
T2 M6
G0 X-60 C720
G1 X10 C45 F6000
G4 P1
G1 Z-70
NC
fivecheck -q --glb=a.glb --pose=a.stl -s s.xml m.xml a.nc
python3 "$(dirname "$LIB")/glb_data.py" a.glb a.stl X Z C head table base 'T2 cutter'
# Clear: the whole program; nothing moves: no animation.
program b.nc <<'NC'
G0 X10 C45
NC
program c.nc <<'NC'
M2
NC
status fivecheck -q --glb=out.glb -s s.xml m.xml b.nc c.nc 2>/dev/null | grep status
for name in b c; do
	python3 -c 'import sys
sys.path.insert(0, sys.argv[1])
import glb_data
document, binary = glb_data.read(sys.argv[2])
print(len(document.get("animations", [])), sum("mesh" in node for node in document["nodes"]))' "$(dirname "$LIB")" out-$name.glb
done
status fivecheck -q --glb=nowhere/a.glb m.xml b.nc
