# Machines from an ini file of a control and from URDF: an independent script says where everything must be.
need python3
truth=$(dirname "$LIB")/../import/kinematics_truth.py
ini() { # KINEMATICS COORDINATES - and HAL commands on standard input
	cat <<-INI
	# a machine
	[EMC]
	MACHINE = test <"&> machine
	[KINS]
	KINEMATICS = $1
	JOINTS = 5
	[TRAJ]
	COORDINATES = $2
	LINEAR_UNITS = ${units:-mm}
	[OFFSETS]
	Y = 20.5
	[HAL]
	HALFILE = LIB:basic_sim.tcl
	HALFILE = kins.hal
	INI
	sed 's/^/HALCMD = /'
	n=0
	for letter in $(echo "$2" | sed 's/./& /g'); do
		echo "[JOINT_$n]"
		printf 'MIN_LIMIT = -%s\nMAX_LIMIT = %s # end\nMAX_VELOCITY = 20\nHOME = %s\n' $((100 + n)) $((90 + n)) $((n == 2 ? 5 : 0))
		n=$((n + 1))
	done
	printf '[AXIS_X]\nMIN_LIMIT = -50\nMAX_LIMIT = 1000\n'
}
echo 'setp xyzac-trt-kins.x-rot-point 3 # x' >kins.hal
ini 'xyzac-trt-kins sparm=identityfirst' XYZAC >ac.ini <<'HAL'
net :y-offset xyzac-trt-kins.y-offset <= gui.y-offset
net :tool-offset motion.tooloffset.z => xyzac-trt-kins.tool-offset
sets :y-offset [OFFSETS]Y
setp xyzac-trt-kins.z-offset -10
setp xyzac-trt-kins.y-rot-point 7
HAL
fivecheck import -o ac ac.ini
cat ac/machine.xml
python3 "$truth" xyzac-trt-kins x-rot-point=3,y-rot-point=7,y-offset=20.5,z-offset=-10 ac/machine.xml
fivecheck import --table Y -o acy ac.ini 2>/dev/null
python3 "$truth" xyzac-trt-kins x-rot-point=3,y-rot-point=7,y-offset=20.5,z-offset=-10 acy/machine.xml
: >kins.hal
echo 'setp xyzbc-trt-kins.x-offset 0.5' | units=inch ini 'xyzbc-trt-kins coordinates=xyzcb' XYZBC >bc.ini
fivecheck import -o bc bc.ini 2>/dev/null
python3 "$truth" xyzbc-trt-kins x-offset=12.7 bc/machine.xml
grep 'units=\|"[XB]" type' bc/machine.xml
ini '5axiskins coordinates=xyzbcwy' XYZBCWY >head.ini </dev/null
fivecheck import -o head head.ini 2>/dev/null
python3 "$truth" 5axiskins '' head/machine.xml
echo "which way the rotary axes turn may be set:"
for yes in 1 TRUE; do
	printf 'setp xyzac-trt-kins.%s\n' 'y-offset 4' 'z-rot-point 5' "conventional-directions $yes" |
		ini xyzac-trt-kins XYZAC >con.ini
	fivecheck import -o "con$yes" con.ini 2>/dev/null
	python3 "$truth" xyzac-trt-kins y-offset=4,z-rot-point=5,conventional-directions=1 "con$yes/machine.xml"
done
printf 'setp xyzbc-trt-kins.%s\n' 'x-offset 4' 'conventional-directions 1' | ini xyzbc-trt-kins XYZBC >con.ini
fivecheck import -o conb con.ini 2>/dev/null
python3 "$truth" xyzbc-trt-kins x-offset=4,conventional-directions=1 conb/machine.xml
printf 'setp xyzab_tdr_kins.%s\n' 'x-rot-point 1' 'y-rot-point 2' 'z-rot-point 5' 'z-offset 11' |
	ini xyzab_tdr_kins XYZAB >tdr.ini
fivecheck import -o tdr tdr.ini 2>/dev/null
python3 "$truth" xyzab_tdr_kins x-rot-point=1,y-rot-point=2,z-rot-point=5,z-offset=11 tdr/machine.xml
for con in 0 1; do
	printf 'setp maxkins.%s\n' 'pivot-length 80' "conventional-directions $con" | ini maxkins XYZBCVW >max.ini
	fivecheck import -o "max$con" max.ini 2>/dev/null
	python3 "$truth" maxkins "pivot-length=80,conventional-directions=$con" "max$con/machine.xml"
done
ini maxkins XYZBCU </dev/null >max.ini
fivecheck import -o maxu max.ini 2>&1 | grep 'treat U'
echo "nutating heads:"
for kins in xyzacb-y xyzbca-x; do
	name=${kins%-?}_trsrn
	pins="${kins#*-}-pivot 31.5|z-pivot -120|x-offset 3|y-offset -7|${kins#*-}-rot-axis 50|z-rot-axis -800|nut-angle 48"
	echo "$pins" | tr '|' '\n' | sed "s/^/setp ${name}_kins./" | ini $name XYZABC >$name.ini
	fivecheck import -o $name $name.ini
	python3 "$truth" $name "$(echo "$pins" | tr ' |' '=,')" $name/machine.xml
done
sed 's/setp xyzbca_trsrn_kins.nut-angle.*/net :tilt xyzbca_trsrn_kins.nut-angle <= gui.tilt/' xyzbca_trsrn.ini >signal.ini
fivecheck import -o nutating signal.ini 2>&1 | grep warning:
echo "what the file does not say is asked:"
ini trivkins XYZA >triv.ini </dev/null
fivecheck import -o triv triv.ini
fivecheck import --table YA -o triv triv.ini
grep -v '^$' triv/machine.xml
ini trivkins XYZBC >bc.ini </dev/null
fivecheck import -o bctriv --table XY bc.ini
fivecheck import -o bctriv --table XY --head ZCB bc.ini 2>/dev/null
grep -o '<axis name=".' bctriv/machine.xml
fivecheck import -o acy2 --head XZ ac.ini
fivecheck import --table YQ -o triv2 triv.ini
fivecheck import --table YY -o triv2 triv.ini
echo "faults:"
fault() { # SED-SCRIPT
	sed "$1" ac.ini >bad.ini
	"$FIVECHECK" import --output bad bad.ini 2>&1 | grep error:
	[ ! -e bad ] || { echo "a folder was written"; rm -r bad; }
}
fault 's/XYZAC/XYZAQ/'
fault 's/^LINEAR_UNITS.*/LINEAR_UNITS = cubit/'
fault '/^LINEAR_UNITS/d'
fault 's/-100/-1oo/'
fault 's/MAX_LIMIT = 94/MAX_LIMIT = -200/'
fault 's/Y = 20.5/Y = many/'
fault 's/^HALCMD = setp .*z-offset.*/HALCMD = setp xyzac-trt-kins.conventional-directions maybe/'
fault 's/kins.hal/gone.hal/'
fault 's/\[TRAJ\]/[TRAJ/'
fault 's/^KINEMATICS.*/KINEMATICS/'
echo '#INCLUDE loop.inc' >loop.inc
fault '1s/.*/#INCLUDE loop.inc/'
echo "a signal that only the running machine sets is said:"
sed '/sets/d' ac.ini >signal.ini
fivecheck import -o signal signal.ini 2>&1 | grep warning:
echo "axes without an end of their travel are said, also where an older release numbers its sections otherwise:"
sed 's/\[JOINT_0\]/[JOINT_9]/; s/\[JOINT_2\]/[AXIS_2]/; s/\[AXIS_X\]/[AXIS_W]/' ac.ini >endless.ini
fivecheck import -o endless endless.ini 2>&1 | grep end
grep -c 'TODO Add limit_min' endless/machine.xml

echo "URDF:"
mkdir -p robot/meshes
rectangle robot/meshes/column 0.3 0.2 0.5
box robot/meshes/table -100 -80 -20 100 80 0
urdf() {
	cat <<'XML'
<?xml version="1.0"?>
<robot name="mill" version="1.0" xmlns:xacro="http://www.ros.org/wiki/xacro">
  <material name="grey"><color rgba="0.5 0.5 0.5 1"/></material>
  <link name="base">
    <visual><geometry><sphere radius="1"/></geometry></visual>
    <collision><origin xyz="0 0.1 -0.4" rpy="0.1 0.2 0.3"/><geometry><mesh filename="package://mill/meshes/column.stl"/></geometry></collision>
  </link>
  <link name="slide"><visual><origin xyz="0 0 0.1"/><geometry><box size="0.4 0.3 0.2"/></geometry></visual></link>
  <link name="ram"><visual><geometry><cylinder radius="0.05" length="0.3"/></geometry></visual></link>
  <link name="tool0"/>
  <link name="cradle"><collision><geometry><mesh filename="meshes/TABLE.stl" scale="0.001 0.001 0.001"/></geometry></collision></link>
  <link name="plate"/>
  <link name="part"/>
  <joint name="joint_x" type="prismatic"><parent link="base"/><child link="slide"/><origin xyz="0.1 0.2 0.3" rpy="0 0 0.1"/><axis xyz="1 0 0"/><limit lower="-0.3" upper="0.4" velocity="0.5" effort="1"/></joint>
  <joint name="Z-axis" type="prismatic"><parent link="slide"/><child link="ram"/><axis xyz="0 0 1"/><limit lower="-0.2" upper="0" velocity="0.2" effort="1"/></joint>
  <joint name="flange" type="fixed"><parent link="ram"/><child link="tool0"/><origin xyz="0 0 -0.15" rpy="3.141592653589793 0 0"/></joint>
  <joint name="a" type="revolute"><parent link="base"/><child link="cradle"/><origin xyz="0 0.5 0" rpy="0.2 0 0"/><axis xyz="-1 0 0"/><limit lower="-2" upper="0.5" velocity="1" effort="1"/></joint>
  <joint name="joint_c" type="continuous"><parent link="cradle"/><child link="plate"/><origin xyz="0 0 0.02"/><axis xyz="0 0 -1"/></joint>
  <joint name="mount" type="fixed"><parent link="plate"/><child link="part"/></joint>
</robot>
XML
}
urdf >robot/mill.urdf
fivecheck import -o mill --dialect fanuc robot/mill.urdf
cat mill/machine.xml
python3 "$truth" urdf robot/mill.urdf mill/machine.xml
echo "faults:"
fault() { # SED-SCRIPT
	urdf | sed "$1" >robot/bad.urdf
	"$FIVECHECK" import --output bad robot/bad.urdf 2>&1 | grep error:
	[ ! -e bad ] || { echo "a folder was written"; rm -r bad; }
}
fault 's/joint_c/spin/'
fault 's/joint_c/joint_y/'
fault 's/joint_c/joint_a/'
fault 's/parent link="base"\/><child link="slide"/parent link="nobody"\/><child link="slide"/'
fault 's/parent link="base"\/><child link="cradle"/parent link="plate"\/><child link="cradle"/'
fault 's/child link="part"/child link="plate"/'
fault 's/type="fixed"/type="floating"/'
fault 's/lower="-2"/lower="2"/'
fault 's/upper="0.5"/upper="nan"/'
fault 's/-1 0 0/0 0 0/'
fault 's/0.001 0.001 0.001/0.001 0.001 0.002/'
fault 's/0.1 0.2 0.3"/0.1 0.2"/'
fault 's/TABLE/..\/..\/TABLE/'
fault 's/<box size="0.4 0.3 0.2"/<sphere radius="1"/'
fault 's/<child link="ram"\/>/&<mimic joint="joint_x"\/>/'
fault 's/.*<link name="ram"/  <xacro:include filename="gantry.xacro"\/>\n&/'
fault 's/<joint name="joint_x"/<xacro:if value="1">&/; s/.*<joint name="Z-axis"/<\/xacro:if>&/'
echo "two packages may have a mesh of the same name:"
mkdir -p packages/plate packages/mill
cp robot/meshes/column.stl packages/mill
box packages/plate/column 0 0 0 1 1 1
urdf | sed 's|package://mill/meshes|package://mill|; s|<box size="0.4 0.3 0.2"/>|<mesh filename="package://plate/Column.stl"/>|' >robot/two.urdf
fivecheck import --meshes packages -o two robot/two.urdf 2>/dev/null
cmp two/stl/slide.stl two/stl/link_base.stl >/dev/null || echo "each has its own"
rm packages/plate/column.stl
mv packages/mill/column.stl packages
fivecheck import --meshes packages -o same robot/two.urdf 2>&1 | grep both
echo "the file begins with any section or includes one, and the machine's name holds any bytes:"
named() { # NAME
	printf '[DISPLAY]\nCYCLE_TIME = 0.2\n'
	sed "s/^MACHINE.*/MACHINE = $1/" ac.ini
}
named "$(printf 'Fr\344se \002')" >named.ini
fivecheck import -o named named.ini 2>/dev/null
named "$(printf 'a%.0s' $(seq 201))" >long.ini
fivecheck import -o long long.ini 2>/dev/null
printf '; all of it is elsewhere\n#INCLUDE ac.ini\n' >include.ini
fivecheck import -o include include.ini 2>/dev/null
for name in named long include; do
	fivecheck --check-machine $name/machine.xml | head -1 | sed 's/aaaaaaaa*/a.../'
done
