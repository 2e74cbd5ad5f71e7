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
