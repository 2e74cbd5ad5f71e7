# Doubts: a link far from everything that carries it, and bodies that only a large adjacent_within excuses. No doubt: a
# joint with a small gap, and an axis with checked="".
drawn_mill whole.xml
# The printed distance is a lower bound, at most a tenth too small.
doubts() { # MACHINE DISTANCE...
	fivecheck --check-machine "$1" | sed -n '/^oddities/,$p' | grep 'mm apart' >said
	shift
	[ -s said ] || echo "  silent"
	sed 's/ about [0-9.]* mm apart.*axis \([A-Z]\) to.*/: the joint of \1/; s/, but are about.*//' said
	sed 's/.* about \([0-9.]*\) mm apart.*/\1/' said | awk -v all="$*" '
		BEGIN { split(all, true) }
		!($1 <= true[NR] * 1.0001 && $1 >= true[NR] * 0.8999) { print "  " $1 " for " true[NR] }'
}
echo "whole:"
doubts whole.xml
echo "without the slide:"
sed '/name="slide"/d' whole.xml >m.xml
doubts m.xml 150
# The slide is 20 mm above the bed, the table 2.
echo "a bed 29, 31 and 60 mm lower:"
for down in 29 31 60; do
	sed "s|bed.stl\"|& location=\"0 0 -$down\"|" whole.xml >m.xml
	doubts m.xml $((20 + down)) $((2 + down))
done
echo "X or both axes checked:"
sed 's/name="X"/& checked="ball screws of 60 mm"/' m.xml >x.xml
doubts x.xml 62
sed 's/name="Y"/& checked="the same"/' x.xml >xy.xml
doubts xy.xml
echo "a sketch of two links:"
sed '/name="slide"/d; /name="table"/d' whole.xml >m.xml
doubts m.xml
# The joints of the lowered bed are 40 and 22 mm wide.
sed 's|bed.stl"|& location="0 0 -20"|' whole.xml >low.xml
for within in 20 25 500; do
	echo "neighbours within $within mm:"
	sed "s|</machine>|<pairs adjacent_within=\"$within\"/>&|" low.xml >m.xml
	case $within in
	25) doubts m.xml 22 ;;
	*) doubts m.xml 40 ;;
	esac
done
