# A case that rounding leaves undecided is an error, never clear: a drawing too far from the origin for its tolerance.
small_machine
box head 899999936 -16 900000064 900000064 16 900000128
box table 899999936 -48 899999936 900000064 48 900000000
echo 'G1 Z-63.99999 F1000' >near.nc
status fivecheck -q m.xml near.nc
status fivecheck -q --tolerance 1e-6 m.xml near.nc
# At the start, too, and for a clearance.
sed -i 's,</base>,</base><pairs><pair a="head" b="table" check="always" clearance="63.9999999"/></pairs>,' m.xml
status fivecheck -q --tolerance 1e-6 m.xml near.nc
# After the first finding it does not count, unless the finding is accepted and the check continues.
sed -i 's,<pairs>.*</pairs>,,' m.xml
printf 'G0 X300\nG0 X0\nG1 Z-63.99999 F1000\n' >behind.nc
echo '<waivers version="1"/>' >none.xml
for accepts in --fail-on=collision,limit --waivers=none.xml --fail-on=collision; do
	status fivecheck -q --tolerance 1e-6 "$accepts" m.xml behind.nc | grep -e '^behind' -e status
done
