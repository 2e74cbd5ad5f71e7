# With any options, init writes a machine file that is valid as soon as its meshes exist.
mkdir stl
make_meshes() { # MACHINE.xml: a small box for each body, apart from the others
	i=0
	for mesh in $(sed -n 's/.*<body .*mesh="\([^"]*\)".*/\1/p' "$1"); do
		i=$((i + 1))
		rectangle "${mesh%.stl}" 1 1 1 $((i * 10)) 0 0
	done
}
for family in table-table head-head head-table; do
	for rotary in A,C C,B B,A; do
		for more in '' '--units inch --dialect fanuc' '--dialect haas --rapid linear --table X' '--head Z,Y'; do
			rm -f m.xml stl/*
			first=${rotary%,*} second=${rotary#*,}
			# shellcheck disable=SC2086 # words, on purpose
			"$FIVECHECK" init $family --rotary $rotary --limits X=-300:300,Y=:250,Z=-400:0 \
				--limits $first=-30:120,$second=none --location $first=0,0,120 --location $second=1e1,-2.5,0 \
				--spindle 0,0,520 $more >m.xml 2>notes || cat notes
			if "$FIVECHECK" -q --check-machine m.xml >/dev/null 2>errors; then
				echo "the meshes were not missed"
			fi
			make_meshes m.xml
			"$FIVECHECK" --check-machine m.xml >tree 2>errors || cat errors
			grep -c '^ *body ' tree
		done
	done
done | sort | uniq -c
echo "nutating tables and heads:"
nutating() { # FAMILY FIRST,SECOND [OPTION...]
	first=${2%,*} second=${2#*,} family=$1 rotary=$2
	shift 2
	"$FIVECHECK" init "$family" --rotary "$rotary" --limits X=-300:300,Y=:250,Z=-400:0,$first=-30:120,$second=none \
		--location $first=0,0,120 --location $second=0,0,120 --spindle 0,0,520 "$@" >n.xml 2>notes || { cat notes; return; }
	make_meshes n.xml
	grep '<axis name="[ABC]"\|45 degrees' n.xml
	"$FIVECHECK" --check-machine n.xml | grep -c '^ *body '
}
nutating nutating-table B,C
nutating nutating-table A,C --table Y
nutating nutating-head C,B
nutating nutating-head C,A --direction A=1,0,2
nutating nutating-table C,B
nutating nutating-head B,C
# A title with all special characters of XML; a tilted axis; a home, because 0 is outside the limits.
init() {
	status fivecheck init table-table --rotary B,C --limits X=-300:300,Y=-1:1,Z=-400:0,B=0:180,C=none \
		--location B=0,0,0 --location C=0,0,0 --spindle 0,0,0 "$@"
}
init --title 'B=a<b & "c" > d' --name 'Fräse' --direction B=0,1,1 --limits Z=100:400 --home Z=150 >odd.xml 2>&1
make_meshes odd.xml
grep -v '^fivecheck\|^status' odd.xml >m.xml
fivecheck --check-machine m.xml | grep 'machine:\|B "\|Z:'
echo "nothing is overwritten:"
init --output odd.xml
echo "faults:"
rm -f m.xml
fault() {
	"$FIVECHECK" init "$@" --output m.xml 2>&1 </dev/null | grep -v "lists the options" | sed 's/[^ -~]/?/g'
	[ ! -e m.xml ] || echo "a file was written"
}
fault
fault table-table --rotary A
fault gantry
fault table-table head-head
fault head-table --rotary B,C --rapid dogleg
complete() {
	fault table-table --rotary A,C --limits X=-300:300,Y=-1:1,Z=-400:0,A=-1:1,C=none --location A=0,0,0 \
		--location C=0,0,0 --spindle 0,0,0 "$@"
}
complete --limits X=300:-300
complete --limits X
complete --limits X=1e9:
complete --limits Z=100:400
complete --location A=0,0
complete --rotary A,X
complete --limits B=0:1
complete --table X --head X,Y
complete --table X --head Y
complete --body C=part.stl
complete --body base=a/head.stl
complete --body W=w.stl
complete --dialect siemens
complete --direction A=0,0,0
complete --rates X=0
complete --inclination A=0
complete --inclination A=180
complete --inclination C=30
complete --inclination X=30
complete --inclination A=30 --direction A=1,0,1
complete --nonsense
complete --title "A=$(printf '\377')"
