# Machines of FreeCAD's CAM workbench, of its first version and of later ones: an independent script says where everything must be.
need python3
truth=$(dirname "$LIB")/../import/kinematics_truth.py
same() { # FILE TABLE HEAD FOLDER
	python3 "$truth" freecad "$1/$2/$3" "$4/machine.xml"
}
first() { # as FreeCAD 1.2 wrote them first: no role, the direction of a linear axis before its origin
	cat <<-JSON
	{"freecad_version": "1.2.0", "postprocessor": {"file_name": "haas"}, "machine": {"axes": {
	 "X": {"joint": [[1.0, 0, 0], [0, 0, 0]], "max": 500, "min": -10.5, "max_velocity": 10000, "sequence": 0, "type": "linear"},
	 "Z": {"joint": [[0, 0, 1], [0, 0, 0]], "max": 0, "min": -300, "max_velocity": 8000, "sequence": 0, "type": "linear"},
	 "Y": {"joint": [[0, 2, 0], [0, 0, 0]], "max": 300, "min": 0, "max_velocity": 10000, "sequence": 0, "type": "linear"},
	 "A": {"joint": [[0, 0, 0], [1, 0, 0]], "max": 90, "min": -90, "max_velocity": 3600, "sequence": 0, "type": "angular"}},
	 "name": "old <&> mill", "units": "metric",
	 "spindles": [{"name": "S", "tool_axis": [0.0, 0.0, -1.0]}]}, "version": 1}
	JSON
}
axis() { # NAME TYPE ROLE PARENT ORIGIN AXIS MIN MAX
	printf '"%s": {"type": "%s", "role": "%s", "parent": %s, "sequence": 0, "joint": {"origin": %s, "axis": %s}, ' \
		"$1" "$2" "$3" "$4" "$5" "$6"
	printf '"limits": {"min": %s, "max": %s}, "max_velocity": 12000}' "$7" "$8"
}
later() { # UNITS, axes on standard input
	printf '{"freecad_version": "1.2.0", "machine": {"name": "later", "units": "%s", "axes": {\n' "$1"
	paste -sd, -
	echo '}, "toolheads": [{"name": "Spindle", "toolhead_type": "rotary"}]}, "version": 1}'
}
linear() {
	axis X linear table_linear null '[0, 0, 0]' '[1, 0, 0]' -300 300 && echo
	axis Y linear "${1:-table_linear}" null '[0, 0, 0]' '[0, 1, 0]' -200 200 && echo
	axis Z linear head_linear null '[0, 0, 0]' '[0, 0, 1]' -400 10 && echo
}
tilt() { # PARENT
	axis A rotary table_rotary "$1" '[0, 40, -55.5]' '[-1, 0, 0]' -120 30 && echo
}
turn() { # PARENT
	axis C rotary table_rotary "$1" '[12, 40, 0]' '[0, 0, -1]' -360 360 && echo
}

echo "the first version does not say which axes carry the work:"
first >old.fcm
fivecheck import -o old old.fcm
fivecheck import -o old --table=YXA old.fcm
same old.fcm YXA Z old
cat old/machine.xml
fivecheck import -o old2 --table= --head=XYZA old.fcm 2>/dev/null
same old.fcm '' XYZA old2
echo "later versions do:"
{ linear; turn '"A"'; tilt '"Y"'; } | later metric >trunnion.fcm
fivecheck import -o trunnion trunnion.fcm
same trunnion.fcm XYAC Z trunnion
{ linear head_linear; tilt null; turn null; } | later imperial >free.json
fivecheck import -o free free.json
same free.json XAC YZ free
echo "FreeCAD's own A/C table has A upon C, and computes with C upon A:"
{ linear; turn null; tilt '"C"'; } | later metric >own.fcm
fivecheck import -o own own.fcm
fivecheck import -o own --table=YXAC own.fcm
same own.fcm YXAC Z own
echo "two rotary axes of a head:"
{
	linear
	axis B rotary head_rotary null '[0, 0, 250]' '[0, 1, 0]' -110 110 && echo
	axis C rotary head_rotary '"B"' '[0, 0, 0]' '[0, 0, 1]' -360 360 && echo
} | later metric >head.fcm
fivecheck import -o head head.fcm
fivecheck import -o head --head=ZCB head.fcm
same head.fcm XY ZCB head
fivecheck import -o head2 --head=CB head.fcm
fivecheck import -o head2 --head=ZCBX head.fcm

echo "faults:"
fault() { # SED-SCRIPT
	sed "$1" trunnion.fcm >bad.fcm
	"$FIVECHECK" import -o bad bad.fcm 2>&1 | grep error: || echo "no error: $1"
	[ ! -e bad ] || { echo "a folder was written"; rm -r bad; }
}
fault 's/"X": {/"X1": {/'
fault 's/"X": {/"C": {/'
fault 's/"X": {/"B": {/'
fault 's/"rotary"/"spiral"/'
fault 's/\[1, 0, 0\]/[-1, 0, 0]/'
fault 's/\[0, 0, -1\]/[0, 0, 0]/'
fault 's/\[0, 0, -1\]/[0, 0]/'
fault 's/{"origin": \[0, 0, 0\], "axis": \[1, 0, 0\]}/[[10, 0, 0], [1, 0, 0]]/'
fault 's/"joint": {"origin": \[0, 40/"link": {"origin": [0, 40/'
fault 's/-120/30/'
fault 's/-120/"low"/'
fault 's/table_linear/head_rotary/'
fault 's/"Y", "sequence"/"C", "sequence"/'
fault 's/"Y", "sequence"/"Q", "sequence"/'
fault 's/"Y", "sequence"/"Z", "sequence"/'
fault 's/"metric"/"cubits"/'
fault 's/"toolheads": \[/"kinematics": {"base_frame": {"orientation_quaternion": [0, 0.7, 0, 0.7]}}, &/'
fault 's/"toolheads": \[.*\]}/"toolheads": 7}/'
fault 's/"axes"/"axles"/'
fault 's/"version": 1/"version": 1,/'
echo "what is doubtful is said:"
sed 's/"limits": {"min": -400, "max": 10}, //; s/"toolhead_type": "rotary"}/"toolhead_type": "laser"}, {}/' trunnion.fcm >doubt.fcm
fivecheck import -o doubt doubt.fcm
