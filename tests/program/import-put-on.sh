# A project of VERICUT whose setup brings an axis: a rotary table with a chuck on one attach of the machine, a moving
# tailstock on another, and a fixed stop. An independent script says where every body must be.
need python3
box block 0 0 0 40 30 20
mesh() { # POSITION
	echo "$1" | awk '{printf "<Poly Unit=\"millimeter\" Mirror=\"Off\"><File>block.stl</File><Position X=\"%s\" Y=\"%s\" Z=\"%s\"/><Rotation I=\"0\" J=\"0\" K=\"0\"/></Poly>", $1, $2, $3}'
}
component() { # NAME TYPE PARENT POSITION ROTATION AND-MORE
	echo "$4 $5" | awk -v name="$1" -v type="$2" -v parent="$3" '{printf "<Component Name=\"%s\" Type=\"%s\"><Attach>%s</Attach><Position X=\"%s\" Y=\"%s\" Z=\"%s\"/><Rotation I=\"%s\" J=\"%s\" K=\"%s\"/>", name, type, parent, $1, $2, $3, $4, $5, $6}'
	printf '%s</Component>\n' "$6"
}
link() { # AXIS REGISTER MIN MAX
	printf '<Link Axis="%s" Register="%s" RapidRate="5000" PartSide="auto"><TlRecord TlMin="%s" TlMax="%s" TlIgnore="off"/></Link>' "$@"
}
cat >mill.mch <<EOF
<VcMachine Version="7.1" Unit="millimeter">
<Collision><Between Sub1="on" Sub2="on" Tol="1"><Component>Z</Component><Component>Side</Component></Between></Collision>
$(component Base base '' '0 0 0' '0 0 0' "$(mesh '0 0 -600')")
$(component X linear Base '0 0 0' '0 0 0' "$(link X X -500 500)$(mesh '0 300 0')")
$(component Table attach X '0 0 100' '0 0 0')
$(component Side attach X '-100 0 100' '0 0 90')
$(component Y linear Base '0 0 500' '0 0 0' "$(link Y Y -200 200)")
$(component Z linear Y '0 0 0' '0 0 0' "$(link Z Z -300 0)$(mesh '0 0 50')")
$(component Tool tool Z '0 0 0' '0 0 0')
</VcMachine>
EOF
setup() { # NAME STOCK-MODEL
	cat <<EOF
<Setup Name="$1"><Build>
$(component Stop fixture Side '0 50 0' '0 0 0' "$(mesh '5 0 0')")
$(component Turned rotary Side '0 10 40' '0 0 30' "$(link X A -90 90)$(mesh '-40 0 0')")
$(component Chuck fixture Turned '15 0 0' '0 0 0' "$(mesh '0 0 5')")
$(component 'Table stock' stock Table '0 0 0' '0 0 0')
$(component Quill linear Table '300 10 40' '0 0 0' "$(link -X U 0 50)")
$(component Tip fixture Quill '0 0 0' '0 0 0' "$(mesh '-20 0 0')")
$(component Stock stock Chuck '20 0 0' '0 0 0' "$2")
</Build>
<GCode><Table Name="Work Offsets"><Row Index="54"><From>Tool</From><To X="1" Y="0" Z="2">Stock</To></Row></Table></GCode>
<Machine><File>mill.mch</File></Machine></Setup>
EOF
}
project() { # SETUPS
	printf '<VcProject Version="7.1" Unit="millimeter">%s</VcProject>\n' "$*" >job.VcProject
}
import() { # FOLDER
	fivecheck import --dialect linuxcnc --output "$1" job.VcProject 2>&1 | grep -v 'tool library\|no limits'
}
project "$(setup one "$(mesh '0 0 0')")"
import new
sed -n '/<base>/,/<.pairs>/p' new/machine.xml
grep 'mesh=\|<work' new/setup.xml
python3 "$(dirname "$LIB")/../import/project_truth.py" job.VcProject mill.mch new
echo "without a model of the stock the work offset says where the work is:"
project "$(setup one)"
import offset
echo "two setups with the same axis, whatever it looks like:"
project "$(setup one)" "$(setup two "$(mesh '0 0 0')" | sed 's/Type="rotary"/Type="rotary" Hue="5"/')"
import two | grep wrote
fault() { # SED-SCRIPT FOR THE SECOND SETUP
	project "$(setup one "$(mesh '0 0 0')")" "$(setup two "$(mesh '0 0 0')" | sed "$1")"
	import bad | grep error:
	[ ! -e bad ] || { echo "a folder was written"; rm -r bad; }
}
echo "what cannot be one machine with one setup at a time:"
fault 's/X="0" Y="50"/X="0" Y="51"/'
fault '/Name="Stop"/d'
fault 's/Register="U"/Register="V"/'
fault '/Name="Stock"/s/Attach>Chuck/Attach>Tip/'
fault "/Name=\"Table stock\"/s,</Comp,$(mesh '0 0 0')&,"
fault 's/Attach>Side/Attach>Sidle/'
project "$(setup one | sed 's/Attach>Side/Attach>Sidle/')"
import bad | grep error:
project "$(setup one | sed 's/Attach>Side/Attach>Chuck/')"
import bad | grep error:
project "$(setup one | sed 's/Register="U"/Register="X"/')"
import bad | grep error:
project "$(setup one | sed 's/"Stop"/"Table"/')"
import bad | grep error:
