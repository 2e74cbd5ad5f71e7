# Fanuc and Haas controls start in cutting mode (G64): without G61 the control may leave the path by a tolerance that
# only the machine file gives.
small_machine
for dialect in fanuc haas; do
	echo "== $dialect"
	controller="<controller dialect=\"$dialect\" power_on_units=\"mm\" power_on_distance=\"absolute\" power_on_plane=\"xy\""
	sed "s|<base>|$controller/>&|" m.xml >bare.xml
	sed "s|<base>|$controller path_tolerance=\"0.01\"/>&|" m.xml >told.xml
	printf '%s\n' % O1 'G0 X10.' M30 % >blends.nc
	printf '%s\n' % O1 'G61 G0 X10.' M30 % >exact.nc
	for run in 'bare.xml blends.nc' 'bare.xml exact.nc' 'told.xml blends.nc'; do
		echo "$run:"
		# shellcheck disable=SC2086
		fivecheck -q $run
	done
done

# How their rapids move, only the machine file can tell: straight ones are assumed, and that is said. One axis alone has
# no choice, and a feed is straight on every control.
for dialect in fanuc haas sinumerik linuxcnc; do
	echo "== rapids of $dialect"
	controller="<controller dialect=\"$dialect\" path_tolerance=\"0.01\""
	[ $dialect = linuxcnc ] || controller="$controller power_on_units=\"mm\" power_on_distance=\"absolute\" power_on_plane=\"xy\""
	sed "s|<base>|$controller/>&|" m.xml >bare.xml
	printf '%s\n' 'G0 X10.' 'G1 X11. Z-1. F100.' M30 >one.nc
	printf '%s\n' 'G0 X10. Z-10.' M30 >both.nc
	for run in 'bare.xml one.nc' 'bare.xml both.nc' 'linear.xml both.nc' 'any.xml both.nc'; do
		way=${run%.xml*}
		[ "$way" = bare ] || sed "s|<base>|$controller rapid=\"$way\"/>&|" m.xml >"$way.xml"
		echo "$run: $(fivecheck -q ${run% *} ${run#* } 2>&1 | grep -c 'checked as straight lines')"
	done
done
