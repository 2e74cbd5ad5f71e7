# A machine of VERICUT 7 with a nutating table, a mesh in VERICUT's format, solids by dimensions, and a collision list:
# an independent script says where every body must be.
need python3
mkdir models
# A tetrahedron in the VERICUT-model format: a text header, then triangles with a count, corners and a normal.
python3 - models/Z_Head.PLY <<'EOF'
import struct, sys
corners = [(0, 0, 0), (40, 0, 0), (0, 30, 0), (0, 0, 20)]
with open(sys.argv[1], "wb") as file:
    file.write(b"VERICUT-model\nversion-2.0\n1\n0 1 0\n")
    for face in ((0, 2, 1), (0, 1, 3), (1, 2, 3), (2, 0, 3)):
        file.write(struct.pack("<B12d", 3, *[x for k in face for x in corners[k]], 0, 0, 1))
EOF
box models/table -100 -80 -20 100 80 0
component() { # NAME TYPE PARENT POSITION ROTATION AND-MORE
	printf '<Component Name="%s" Type="%s"><Attach>%s</Attach>\n' "$1" "$2" "$3"
	frame "$4" "$5"
	printf '%s</Component>\n' "$6"
}
frame() { # POSITION ROTATION
	echo "$1 $2" | awk '{printf "<Position X=\"%s\" Y=\"%s\" Z=\"%s\"/><Rotation I=\"%s\" J=\"%s\" K=\"%s\"/>\n", $1, $2, $3, $4, $5, $6}'
}
link() { # AXIS REGISTER MIN MAX ATTRIBUTES
	printf '<Link Axis="%s" Register="%s" RapidRate="5000" %s><TlRecord TlMin="%s" TlMax="%s" TlIgnore="off"/></Link>' \
		"$1" "$2" "$5" "$3" "$4"
}
file() { # ELEMENT PATH POSITION ROTATION
	printf '<Poly Unit="millimeter" Mirror="Off"><File>%s</File>%s</Poly>' "$1" "$(frame "$2" "$3")"
}
solid() { # ELEMENT POSITION ROTATION
	printf '<%s Mirror="Off">%s</%s>' "$1" "$(frame "$2" "$3")" "${1%% *}"
}
machine() { # UNIT - what is in "$changed" is changed with sed
	cat <<EOF
<?xml version="1.0"?>
<VcMachine Version="7.1" Unit="$1">
<Table Name="Initial Machine Location"><Row Index="1"><System>1</System>
<Value>10</Value><Value>-20</Value><Value>300</Value><Value>0</Value></Row></Table>
<Collision>
<Between Sub1="off" Sub2="on" Tol="1.5"><Component>Z axis</Component><Component>B</Component></Between>
<Between Sub1="off" Sub2="off" Tol="0.5"><Component>Tool</Component><Component>C</Component></Between>
<Between Sub1="off" Sub2="off" Tol="2"><Component>Z axis</Component><Component>C</Component></Between>
<Between Sub1="off" Sub2="off" Tol="0"><Component>Probe</Component><Component>Base</Component></Between>
</Collision>
$(component Base base '' '0 0 0' '0 0 0' "$(solid 'Block Length="600" Width="400" Height="50"' '-300 -200 -300' '0 0 0')")
$(component B rotary Base '0 0 155' '-45 0 0' "$(link Y B 0 180 'PartSide="auto"')$(solid 'Cylinder Radius="30" Height="60"' '0 10 20' '0 90 30')")
$(component C rotary B '0 109.601551084 -109.601551084' '45 0 0' "$(link Z C -29999 29999 'PartSide="auto"')$(file 'V:\other\models\TABLE.stl' '1 2 3' '0 0 90')")
$(component Attach attach C '0 0 5' '0 0 90' '')
$(component X linear Base '250 0 0' '0 0 0' "$(link X X -500 0 'DisableAuto="off"')")
$(component Y linear X '0 155 0' '0 0 0' "$(link Y Y -420 0 'DisableAuto="off"')")
$(component 'Z axis' linear Y '0 0 542' '0 0 0' "$(link Z Z 50 380 'DisableAuto="off"')$(file 'D:\machines\models\z_head.ply' '0 -155 0' '10 20 30')")
$(component Probe other 'Z axis' '50 0 0' '0 0 0' "$(solid 'Cylinder Radius="5" Height="40"' '0 0 0' '180 0 0')")
$(component Door linear Base '0 900 0' '0 0 0' "$(link X '' 0 0)$(solid 'Block Length="600" Width="10" Height="500"' '0 0 0' '0 0 0')")
$(component Tool tool 'Z axis' '0 0 0' '0 0 0' '<Link Axis="Z" Register=""/>')
</VcMachine>
EOF
}
machine millimeter >dmu.mch
fivecheck import --output new --dialect klartext dmu.mch
cat new/machine.xml
python3 "$(dirname "$LIB")/../import/vericut_truth.py" dmu.mch new
"$FIVECHECK" --check-machine new/machine.xml | sed -n '/^what a positive/,/^$/p'
echo "solids by their sizes are closed:"
"$FIVECHECK" --check-machine new/machine.xml | grep "mesh is open"
echo "what each axis does, in pictures: the same page from import and from --check-machine"
fivecheck import --pictures --output drawn dmu.mch 2>&1 | grep html
"$FIVECHECK" --check-machine --report=again.html drawn/machine.xml >/dev/null
cmp drawn/axes.html again.html
sed -n 's,</*h2>,,gp; /^<p>.+10/p' again.html
grep -c '<svg' again.html
"$FIVECHECK" --check-machine --report=dmu.mch drawn/machine.xml
rm drawn/machine.xml
fivecheck import --pictures --output drawn dmu.mch
echo "in inches:"
machine inch >inch.mch
fivecheck import --output inch --meshes models inch.mch 2>&1 | grep -c warning
python3 "$(dirname "$LIB")/../import/vericut_truth.py" inch.mch inch
echo "models without the word Mirror are bodies, too:"
machine millimeter | sed 's/ Mirror="Off"//' >plain.mch
fivecheck import --output plain plain.mch 2>/dev/null
grep -c '<body' plain/machine.xml
echo "a solid by its sizes that is not moved is one, too:"
machine millimeter | sed 's/<Block .*/<Block Length="600" Width="400" Height="50"\/><\/Component>/' >block.mch
fivecheck import --output block block.mch 2>/dev/null
sed -n '/<base>/{n;p;}' block/machine.xml
echo "a project: the machine, a setup with its tools, and the program as a job"
mkdir job
box job/z_head -60 -40 0 60 40 30 # as a mesh of the machine is called
box job/blank 0 0 0 80 60 20
box job/part 10 10 0 70 50 15
printf 'G21 G90 G54\nG0 X10\nM2\n' >job/O1.nc
printf 'T1 P1 D10 Z100 ; an end mill\n' >job/tools.tbl
project() { # "X Y Z" as VERICUT stored them
	cat <<EOF
<?xml version="1.0"?>
<VcProject Version="7.1" Unit="millimeter">
<Setup Name="op 10" Active="on">
<Build>
$(component Vise fixture Attach '0 0 10' '0 0 0' "$(file 'D:\jobs\Z_HEAD.stl' '1 2 3' '0 0 90')")
$(component Stock stock Vise '-40 -30 33' '0 0 15' "$(file 'D:\jobs\blank.stl' '0 0 0' '0 0 0')")
$(component Design design Stock '0 0 0' '0 0 0' "$(file 'D:\jobs\part.stl' '0 0 1' '0 0 0')")
</Build>
<NCPrograms Type="gcode"><Init Flag="off"><File>init.nc</File></Init>
<NCProgram Use="on"><File>D:\jobs\o1.NC</File></NCProgram><NCProgram Use="off"><File>no.nc</File></NCProgram>
<NCProgram Use="on"><File>gone.nc</File></NCProgram></NCPrograms>
<GCode><Table Name="Work Offsets">
<Row Index="54"><System>1</System><From CSystem="off" X="0" Y="0" Z="0">Tool</From><To CSystem="on" X="0" Y="0" Z="0">NC</To>
$(for value in $1; do echo "<Value>$value</Value>"; done)</Row>
<Row Index="2"><From CSystem="off">C</From><To CSystem="off" X="5" Y="6" Z="7">Vise</To></Row>
<Row Index="99"><From CSystem="off">Tool</From><To CSystem="on" X="0" Y="0" Z="0">NC</To></Row>
</Table></GCode>
<CSystems><CSystem Name="NC" Type="component"><Attach>Stock</Attach>$(frame '0 0 20' '0 0 0')</CSystem></CSystems>
<ToolMan><Library>D:\tools.tbl</Library></ToolMan>
<Machine><File>C:\machines\DMU.mch</File>
<Collision><Between Tol="1.5"><Component>Z axis</Component><Component>Vise</Component></Between></Collision></Machine>
</Setup></VcProject>
EOF
}
project '-220 -195 -474' >job/job.VcProject
fivecheck import --meshes . --output job/new --dialect linuxcnc job/job.VcProject
sed "s,$PWD,HERE," job/new/setup.xml job/new/jobs.xml
python3 "$(dirname "$LIB")/../import/project_truth.py" job/job.VcProject dmu.mch job/new
"$FIVECHECK" --parse-only -q job/new/jobs.xml 2>&1 | sed "s,$PWD,HERE,"
project '-220 -195 -474.1' >job/job.VcProject
fivecheck import --meshes . --output job/moved job/job.VcProject 2>&1 | grep 'are used'
project '-220 -195 -474 0 45' >job/job.VcProject
fivecheck import --meshes . --output job/turned job/job.VcProject 2>&1 | grep 'not only'
grep -c '<work_offset' job/turned/setup.xml
echo "a base work offset makes the others uncertain, and other tables are named:"
base() { # VALUE
	project '' | sed "s|</GCode>|<Table Name=\"Base Work Offset\"><Row Index=\"1\"><From>Tool</From><To>Vise</To><Value>0</Value><Value>$1</Value></Row></Table><Table Name=\"Shift Offsets\"><Row Index=\"1\"/></Table><Table Name=\"RTCP Pivot Offset\"/>&|" >job/job.VcProject
	fivecheck import --meshes . --output "job/base$1" job/job.VcProject 2>&1 | grep 'base work\|table Shift'
	grep -c '<work_offset' "job/base$1/setup.xml"
}
base 0
base 10
echo "several models of the stock, where they lie apart:"
project '' | sed "/Name=.Stock./,/<.Component>/s|</Component>|$(file 'D:\\\\jobs\\\\blank.stl' '300 0 5' '0 0 90')&|" >job/several.VcProject
fivecheck import --meshes . --output job/several job/several.VcProject 2>/dev/null
python3 - job/several/stl-setup.1/*lank*.stl <<'PYTHON'
import struct
import sys
data = open(sys.argv[-1], "rb").read()
count = struct.unpack("<I", data[80:84])[0]
corners = [struct.unpack("<3f", data[84 + 50 * i + 12 + 12 * k:][:12]) for i in range(count) for k in range(3)]
for name, part in (("first", corners[:36]), ("second", corners[36:])):
    print(name, *[f"{min(c[i] for c in part):.3f} to {max(c[i] for c in part):.3f}," for i in range(3)])
PYTHON
project_fault() { # SED-SCRIPT
	project '0 0 0' | sed "$1" >job/bad.VcProject
	"$FIVECHECK" import --meshes . --output bad job/bad.VcProject 2>&1 | grep error:
	[ ! -e bad ] || { echo "a folder was written"; rm -r bad; }
}
echo "the stock of the second setup is what the first one leaves:"
project '' | python3 -c '
import re, sys
text = sys.stdin.read()
setup = text[text.index("<Setup"):text.index("</VcProject>")].replace("op 10", "op-20")
print(text.replace("</VcProject>", re.sub("<Poly.*blank.*</Poly>", "", setup) + "</VcProject>"))' >job/second.VcProject
fivecheck import --meshes . --output job/second job/second.VcProject 2>&1 | grep "has no model"
grep -c '<stock name' job/second/setup-*.xml
grep 'TODO.*no model' job/second/setup-op-20.xml
echo "two meshes of the same name, of which one is there:"
project '' | sed 's|D:.jobs.part.stl|E:\\other\\BLANK.stl|' >job/same.VcProject
fivecheck import --meshes . --output job/same job/same.VcProject 2>&1 | grep both
project '' | sed 's|D:.jobs.part.stl|d:/JOBS/blank.STL|' >job/same.VcProject
fivecheck import --meshes . --output job/again job/same.VcProject 2>&1 | grep both
echo "most of a project may be missing:"
project '' | sed '/<Build>/,/<.Build>/d; /<NCPrograms/,/<.NCPrograms>/d; /<GCode>/,/<.GCode>/d; /<ToolMan>/d; /<Collision>/d
	s,<.Setup>,</Machine>&,' >job/bare.VcProject
fivecheck import --meshes . --output job/bare job/bare.VcProject 2>&1 | grep -v 'dmu.mch:'
ls job/bare
project_fault 's/DMU.mch/gone.mch/'
project_fault 's,<File>C:[^<]*<,<File><,'
project_fault 's/Attach>Attach</Attach>Q</'
project_fault 's/<Attach>Attach</<Attach>Design</'
project_fault 's/Type="design"/Type="other"/'
project_fault 's/Type="design"/Type="stock"/'
project_fault 's,<Value>0</Value>,<Value>O</Value>,'
project_fault 's,CSystem="on" X="0",CSystem="on" X="nan",'
echo "nothing is overwritten:"
fivecheck import --output new dmu.mch
echo "faults:"
fault() { # SED-SCRIPT
	machine millimeter | sed "$1" >bad.mch
	"$FIVECHECK" import --output bad bad.mch 2>&1 | grep -v 'warning:'
	[ ! -e bad ] || { echo "a folder was written"; rm -r bad; }
}
fault 's/Unit="millimeter">$/Unit="cubit">/'
fault 's/<Attach>X</<Attach>Q</'
fault 's/<Attach>Base<\/Attach>\(.*\)$/<Attach>Tool<\/Attach>\1/; s/Name="Z axis" Type="linear"><Attach>Y</Name="Z axis" Type="linear"><Attach>X</'
fault 's/<Attach>X<.Attach>/<Attach\/>/'
fault 's/Name="Y" Type/Name="X" Type/'
fault 's/Register="Y"/Register="X"/'
fault 's/Register="B"/Register="W"/'
fault 's/Link Axis="Y"/Link Axis="N"/'
fault 's/PartSide="auto"/PartSide="maybe"/'
fault 's/TlMin="50"/TlMin="fifty"/'
fault 's/X="250"/X="1e999"/'
fault 's/<File>[^<]*z_head.ply/<File>D:\\gone.ply/'
fault 's/<File>[^<]*z_head.ply/<File>..\\..\\..\\etc\\passwd/'
fault 's/Mirror="Off"/Mirror="XY"/'
fault 's/<Block /<Sweep /; s/<\/Block/<\/Sweep/'
fault 's/Radius="5"/Radius="-5"/'
fault 's/<Component>Probe</<Component>Robe</'
fault 's/Tol="2"/Tol="-2"/'
fault '/<Component /d'
fault 's/VcMachine/Machine/'
echo "meshes that are not there:"
rm models/Z_Head.PLY
fivecheck import --output less --skip-missing dmu.mch 2>&1 | grep left
grep -c '<body' less/machine.xml
grep TODO.*left less/machine.xml
printf 'VERICUT-model\nversion-3.0\n' >models/Z_Head.PLY
fivecheck import --output less2 dmu.mch 2>&1 | grep error
printf 'VERICUT-model\nversion-2.0\n1\n0 1 0\n\003abc' >models/Z_Head.PLY
fivecheck import --output less2 dmu.mch 2>&1 | grep error
printf 'VERICUT-model\nversion-2.0\n1\n0 1 0\n' >models/Z_Head.PLY
fivecheck import --output less2 dmu.mch 2>&1 | grep error
echo "usage:"
fivecheck import dmu.mch
fivecheck import --output x
fivecheck import --output x --dialect basic dmu.mch
fivecheck import --output x --numbr-tools dmu.mch
fivecheck import --output x not_there.mch
