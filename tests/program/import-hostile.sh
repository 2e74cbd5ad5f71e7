# Files made to mislead or to block an import: each import ends at once, with a message that has the file and its line.
need python3
hostile() { # NAME OPTIONS... - standard input is the file
	name=$1
	shift
	[ -e "$name" ] || cat >"$name"
	"$FIVECHECK" import --number-tools "$@" --output out "$name" 2>&1 | grep -v 'note:\|warning:' | head -1 | cut -c1-150
	[ ! -e out ] || { echo "a folder was written"; rm -r out; }
}
echo "what a NUL byte hides, sizes in other units, numbers that no control has:"
printf 'G10 L10 P1 R100.\n\0G10 L10 P2 R90.\n' | hostile offsets.nc
printf 'number,length,diameter\n1,1e5,6\n' | hostile length.csv
printf 'number,length,diameter\n1,100,1e5\n' | hostile thick.csv
printf 'T1 P1 Z10 Z20 D6\n' | hostile twice.tbl
fusion() { # NUMBER DIAMETER
	printf '\357\273\277{"data":[{"type":"flat end mill","unit":"millimeters","geometry":{"DC":%s,"LB":25,"LCF":15},"post-process":{"number":%s}}]}\n' "$2" "$1"
}
fusion 4000000000 6 | hostile number.json
fusion 1 1e300 | hostile diameter.json
echo "a byte order mark before JSON is none of these:"
fusion 1 6 | hostile mark.json
printf '[EMC]\n' | hostile empty.ini
echo "solids beyond any machine, and a FIFO as a mesh:"
robot() { # GEOMETRY
	printf '<robot name="r"><link name="a"/><link name="b"><visual><geometry>%s</geometry></visual></link>' "$1"
	printf '<joint name="X" type="prismatic"><parent link="a"/><child link="b"/><axis xyz="1 0 0"/>'
	printf '<limit lower="0" upper="1" velocity="1"/></joint></robot>\n'
}
robot '<box size="6000 1 1"/>' | hostile box.urdf
robot '<cylinder radius="1e300" length="1"/>' | hostile cylinder.urdf
mkfifo fifo.stl
robot '<mesh filename="fifo.stl"/>' | hostile fifo.urdf
hostile fifo.stl
echo "a zip bomb, and an archive that is cut off:"
python3 - <<'EOF'
import struct
import zipfile
with zipfile.ZipFile("bomb.3mf", "w") as archive:
    archive.writestr("3D/3dmodel.model", b"x")
data = bytearray(open("bomb.3mf", "rb").read())
place = data.index(b"PK\1\2") + 24
data[place:place + 4] = struct.pack("<I", 4000000000)
open("bomb.3mf", "wb").write(data)
open("cut.3mf", "wb").write(data[:-30])
EOF
hostile bomb.3mf --units mm
hostile cut.3mf --units mm
