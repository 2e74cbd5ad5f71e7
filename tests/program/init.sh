# The three machines that ship with fivecheck, given to init by options, become the same machines: the same tree, the
# same pairs with their reasons, and the same verdict for a colliding program.
root=$(dirname "$LIB")/../..
same() { # FOLDER, then options
	folder=$1
	shift
	rm -f stl made.xml
	ln -s "$root/machines/$folder/stl" stl
	status fivecheck init "$@" --output=made.xml
	for what in --check-machine --list-pairs; do
		fivecheck $what made.xml | tail -n +2 >made.txt
		fivecheck $what "$root/machines/$folder/machine.xml" | tail -n +2 >shipped.txt
		cmp made.txt shipped.txt
	done
	"$FIVECHECK" -q -s "$root/examples/$folder/setup.xml" made.xml "$root/examples/$folder/collision.nc" >made.txt
	echo "status $?, $(grep -c error: made.txt) finding"
	"$FIVECHECK" -q -s "$root/examples/$folder/setup.xml" "$root/machines/$folder/machine.xml" \
		"$root/examples/$folder/collision.nc" | cmp - made.txt
}
same ac-trunnion table-table --rotary A,C --limits X=-300:300,Y=-250:250,Z=-400:0 --limits A=-120:30,C=none \
	--location A=0,0,120 --location 'C=0 0 120' --spindle 0,0,520 --workholding 0,0,80 --rates Z=24000,C=14400 \
	--title 'A=First axis' --title 'C=Second axis' --name 'A/C trunnion 400' --body base=stl/bed.stl \
	--body base=stl/bearing_left.stl --body base=stl/bearing_right.stl --body Y=stl/bridge.stl --body X=stl/carriage.stl
same cb-head head-head --rotary C,B --limits X=-500:500,Y=-750:750,Z=-700:0,C=-360:360,B=-110:110 \
	--location C=0,0,1050 --location B=0,0,1050 --spindle 0,0,800 --rates X=40000,Y=40000,C=18000,B=14400 \
	--title 'C=First axis' --title 'B=Second axis' --name 'C/B head portal 1900' --body base=stl/bed.stl \
	--body base=stl/table.stl --body Y=stl/portal.stl --body X=stl/carriage.stl --body Z=stl/ram.stl
same b-head-c-table head-table --rotary B,C --table Y --head X,Z --limits X=-500:500,Z=-560:0,Y=-220:220,B=-30:120 \
	--limits C=none --location B=0,0,720 --location C=0,0,0 --spindle 0,0,500 --rates B=10800,C=36000 \
	--title 'B=Swivel head' --title 'C=Turning table' --name 'B head C table 560' --body X=stl/column.stl \
	--body Z=stl/slide.stl --body Y=stl/saddle.stl --body B=stl/head.stl
# If the origin of fixtures and parts is not given, the file marks it as a guess.
for workholding in --workholding=0,0,80 ''; do
	# shellcheck disable=SC2086 # no word if there is none
	"$FIVECHECK" init head-head --rotary C,B --limits X=none,Y=none,Z=none,C=none,B=none --location C=0,0,1050 \
		--location B=0,0,1050 --spindle 0,0,800 $workholding 2>/dev/null | grep -B 1 '<workholding'
done
