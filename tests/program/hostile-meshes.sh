# Invalid meshes: missing, a folder, a device, a pipe, truncated, with a wrong size, 2 GB of holes, all zeros.
small_machine
echo 'G0 X10' >a.nc
mkdir folder
mkfifo pipe
awk 'BEGIN { for (i = 0; i < 80; i++) printf "x" }' >header
# count TAIL - the header, a count of four bytes in octal, and so many bytes of zeros
binary() {
	cat header
	# shellcheck disable=SC2059 # octal escapes, on purpose
	printf "$1"
	head -c "$2" /dev/zero
}
binary '\377\377\377\377' 50 >lie
binary '\002\000\000\000' 99 >cut
binary '\001\000\000\000' 51 >trailing
binary '\000\000\000\000' 0 >none
binary '\001\000\000\000' 50 >zeros
binary '\002\000\000\000' 100 >unwritten
truncate -s 2147483684 sparse
printf 'solid \001\002 in name only, and nothing behind' >name
: >empty
printf 'solid\r\nfacet normal 0 0 0\r\nouter loop\r\nvertex 1e3 0 0\r\nvertex 0 1e39 0' >range
for mesh in missing folder /dev/null pipe lie cut trailing none zeros unwritten sparse name empty range; do
	sed "s,head.stl,$mesh," m.xml >bad.xml
	status soon "$FIVECHECK" -q bad.xml a.nc 2>&1 | cut -c1-160
done
