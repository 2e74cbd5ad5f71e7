# The remaining stock in the report and in the scene, against the closed forms of examples/stock.
need python3
here=$(dirname "$LIB")
examples=$here/../../examples/stock
machine=$here/../../machines/ac-trunnion/machine.xml

# draw NAME [OPTION...]
draw() {
	name=$1
	shift
	"$FIVECHECK" -q "$@" --report="$name.html" --glb="$name.glb" -s s.xml "$machine" "$name.nc" >/dev/null
	echo "exit status $?"
}

# hold NAME TOP FLOOR - the block is TOP mm high, and the floor of the slot along X is FLOOR mm high
hold() {
	PYTHONPATH=$here python3 "$here/stock_report.py" "$1.html" "$1.glb" block "$2" "$3"
}

cp "$examples/setup.xml" s.xml
cp "$examples"/*.nc .
echo '== the holder meets a wall while the third pass of the slot begins'
draw holder
hold holder 40 22
echo '== with all findings: at the first one'
draw holder -a
hold holder 40 22
echo '== a rapid into the end of the first pass'
draw rapid
hold rapid 40 31
echo '== clear: what remains at the end'
draw clear
hold clear 21 12
echo '== a small report has a coarser mesh'
draw holder --report-size=0.6
hold holder 40 22
test "$(wc -c <holder.html)" -lt 600000
echo '== no cut before the finding: the blank as it is'
sed 's/box="80 60 40"/cylinder="80 30"/' "$examples/setup.xml" >s.xml
sed '/^G1/d; s/Z-9$/Z-12/' "$examples/rapid.nc" >start.nc
draw start
hold start 30 30
