# Device descriptions of MTConnect: with Motion elements, which make the chain, and without, as most agents have them.
need python3
truth=$(dirname "$LIB")/../import/kinematics_truth.py
motion() { # ID TYPE PARENT AXIS ORIGIN
	printf '<Motion id="%s" type="%s" actuation="DIRECT" coordinateSystemIdRef="machine"%s>' "$1" "$2" "${3:+ parentIdRef=\"$3\"}"
	printf '%s<Axis>%s</Axis></Motion>' "${5:+<Origin>$5</Origin>}" "$4"
}
spec() { # TYPE UNITS MIN MAX
	printf '<Specification type="%s" units="%s"><Maximum>%s</Maximum><Minimum>%s</Minimum></Specification>' "$1" "$2" "$4" "$3"
}
part() { # TAG NATIVE MOTION SPECIFICATIONS
	echo "<$1 id=\"$2\" name=\"$2\" nativeName=\"$2\"><Configuration>$3<Specifications>$4</Specifications></Configuration></$1>"
}
device() { # parts on standard input
	cat <<-XML
	<?xml version="1.0"?>
	<MTConnectDevices xmlns="urn:mtconnect.org:MTConnectDevices:2.3"><Header version="2.3"/><Devices>
	<Agent id="agent" name="Agent"/>
	<Device id="d" name="mill &amp; co" uuid="1">
	<Configuration><CoordinateSystems><CoordinateSystem id="machine" type="MACHINE"/><CoordinateSystem id="work" type="OBJECT"/></CoordinateSystems></Configuration>
	<Components><Structures id="s"><Configuration><SolidModel id="m" mediaType="STEP" href="mill.stp"/></Configuration>
	<Components><Link id="l"><Configuration><Motion id="arm" type="FIXED" parentIdRef="mz" coordinateSystemIdRef="machine"/></Configuration></Link></Components></Structures>
	<Axes id="a"><Components>
	$(cat)
	</Components></Axes></Components></Device></Devices></MTConnectDevices>
	XML
}
mill() {
	{
		part Rotary C "$(motion mc CONTINUOUS mb '0 0 -1' '10 20 0')" "$(spec ROTARY_VELOCITY REVOLUTION/MINUTE 0 50)$(spec VELOCITY REVOLUTION/MINUTE 0 25)"
		part Rotary B "$(motion mb REVOLUTE my '0 -2 0' '10 0 -100.5')" "$(spec ANGLE DEGREE -30 120)"
		part Linear X "$(motion mx PRISMATIC '' '1 0 0' '300 915 590')" "$(spec POSITION MILLIMETER -400 400)$(spec POSITION MILLIMETER -380 500)$(spec LENGTH MILLIMETER 0 900)"
		part Linear Y "$(motion my PRISMATIC '' '0 -1 0')" "$(spec POSITION INCH -10 10)$(spec VELOCITY MILLIMETER/SECOND 1 500)"
		part Linear Z "$(motion mz PRISMATIC mx '0 0 1')" "$(spec POSITION MILLIMETER -500 0)"
		part Rotary S1 "$(motion ms CONTINUOUS arm '0 0 1')" "$(spec ROTARY_VELOCITY REVOLUTION/MINUTE 0 12000)"
	} | device
}
echo "Motion elements make the chain:"
mill >mill.xml
fivecheck import -o mill mill.xml
cat mill/machine.xml
python3 "$truth" mtconnect mill.xml/YBC/XZ mill/machine.xml
mill | sed 's|<Axis>0 0 -1</Axis>|<AxisDataSet><Entry key="Z">-1</Entry></AxisDataSet>|
	s|<Origin>10 20 0</Origin>|<OriginDataSet><Entry key="X">10</Entry><Entry key="Y">20</Entry></OriginDataSet>|' >set.xml
fivecheck import -o set set.xml 2>/dev/null
tail -n +3 set/machine.xml | diff mill/machine.xml - | grep '^[<>]'
for table in BCY BC YBCX; do
	fivecheck import -o asked --table=$table mill.xml 2>&1 | grep 'error:'
done
mill | sed '/<Rotary id="S1"/d; s/parentIdRef="mx"//' >asked.xml
fivecheck import -o asked --table=YBC --head=ZX asked.xml 2>/dev/null
python3 "$truth" mtconnect asked.xml/YBC/ZX asked/machine.xml
echo "without them the user has to:"
cat >plain.xml <<'XML'
<m:MTConnectDevices xmlns:m="urn:mtconnect.org:MTConnectDevices:1.2"><m:Devices><m:Device id="d" name="VMC">
<m:Components><m:Axes id="a"><m:Components>
<m:Rotary id="s" name="C" nativeName="S"/>
<m:Rotary id="t" name="B"><m:DataItems><m:DataItem type="ROTARY_VELOCITY" id="tv" category="SAMPLE"/></m:DataItems></m:Rotary>
<m:Linear id="x" name="X1"><m:DataItems>
<m:DataItem type="POSITION" id="xw" coordinateSystem="WORK" units="MILLIMETER"><m:Constraints><m:Minimum>-1</m:Minimum><m:Maximum>1</m:Maximum></m:Constraints></m:DataItem>
<m:DataItem type="POSITION" id="xm" coordinateSystem="MACHINE" units="MILLIMETER"><m:Constraints><m:Minimum>-700</m:Minimum><m:Maximum>0</m:Maximum></m:Constraints></m:DataItem>
</m:DataItems></m:Linear><m:Linear id="y" name="y"/><m:Linear id="z" name="Z"/><m:Rotary id="r" name="A"/>
</m:Components></m:Axes></m:Components></m:Device></m:Devices></m:MTConnectDevices>
XML
fivecheck import -o plain plain.xml
fivecheck import -o plain --table=XYA plain.xml
grep '<axis' plain/machine.xml

echo "faults:"
fault() { # SED-SCRIPT
	mill | sed "$1" >bad.xml
	"$FIVECHECK" import -o bad bad.xml 2>&1 | grep error: || echo "no error: $1"
	[ ! -e bad ] || { echo "a folder was written"; rm -r bad; }
}
fault 's/nativeName="Z"/nativeName="X"/'
fault 's/name="Z" nativeName="Z"/name="front"/'
fault 's/name="C" nativeName="C"/name="Y2" nativeName=""/'
fault 's/nativeName="S1"/nativeName="A"/'
fault 's/parentIdRef="mb"/parentIdRef="mq"/'
fault 's/parentIdRef="my"/parentIdRef="mc"/'
fault 's/parentIdRef="my"/parentIdRef="mz"/'
fault 's/parentIdRef="mb"//'
fault 's/parentIdRef="mb"/parentIdRef="ms"/'
fault 's/id="mb" type="REVOLUTE"/id="mb" type="PRISMATIC"/'
fault 's/id="mb" type="REVOLUTE" actuation="DIRECT"/id="mb" type="REVOLUTE" actuation="VIRTUAL"/'
fault '/id="mb"/s/coordinateSystemIdRef="machine"/coordinateSystemIdRef="work"/'
fault 's/0 -1 0/0 1 0/'
fault 's/0 -1 0/0 0 0/'
fault 's/0 -1 0/0 -1/'
fault 's/0 -1 0/0 -1 0 0/'
fault 's/0 -1 0/0 -1 nan/'
fault 's|<Origin>10 20 0</Origin>|<Transformation><Translation>10 20 0</Translation></Transformation>|'
fault 's|<Origin>10 20 0</Origin>|<Transformation><Rotation>10 20 0</Rotation></Transformation>|'
fault 's|<Origin>10 20 0</Origin>|&<Transformation/>|'
fault 's|<Axis>0 0 -1</Axis>|<AxisDataSet><Entry key="C">-1</Entry></AxisDataSet>|'
fault 's/INCH/CUBIT/'
fault 's/>-30</>130</'
fault 's/>-30</>low</'
fault 's/<Linear/<Path/; s/<.Linear/<\/Path/; s/<Rotary/<Path/; s/<.Rotary/<\/Path/'
fault 's|</Devices>|<Device id="e"><Linear name="X"/></Device>&|'
echo "one of several machines, by its name or its id:"
mill | sed 's|</Devices>|<Device id="e"><Linear name="X"/></Device>&|' >two.xml
fivecheck import --device=lathe --output two two.xml 2>&1 | head -1
fivecheck import --device='mill & co' --output two two.xml 2>&1 | grep -c wrote
fivecheck import --device=d --output two-by-id two.xml 2>&1 | grep -c wrote
cmp two/machine.xml two-by-id/machine.xml
fault 's|</Devices>||'
