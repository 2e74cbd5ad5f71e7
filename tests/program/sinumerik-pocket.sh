# A pocket is a region: it is clear where the cutter is long enough for its depth, and found where the holder meets the
# block, for any path of the control in it; the same holds for the move after it, which can start anywhere above the
# pocket.
root=$(dirname "$LIB")/../..
cp -r "$root/machines/ac-trunnion/stl" stl
sed 's|<controller dialect="[a-z]*" rapid="linear"/>|<controller dialect="sinumerik" rapid="linear" power_on_units="mm" edge_after_tool_change="first" swivel_axis="A" swivel_pole="stays"><tool_change/></controller>|' \
	"$root/machines/ac-trunnion/machine.xml" >machine.xml
pocket()
{
	printf 'G54 G17 G71 G90 G94 G60\nT1 D1 M6\nS8000 M3 F1000\nG0 X-60 Y0 A0 C0\nZ20\n%s\n%s\nM30\n' "$1" "$2" >part.mpf
	fivecheck -q -s "$root/examples/stock/setup.xml" machine.xml part.mpf 2>&1 | grep -v '^ ' | sed 's/^\([^[]*\) \[.*/\1/'
}
pocket 'POCKET1(10,0,2,-8,,30,24,6,0,0,0,300,1000)' 'G0 Z50'
pocket 'POCKET1(10,0,2,-26,,30,24,6,0,0,0,300,1000)' 'G0 Z50'
pocket 'POCKET1(10,0,2,-8,,30,24,6,0,0,0,300,1000)' 'G0 Z-5'
# In rotated coordinates, too, the region and the unknown end position do not extend beyond the reach of the tool.
pocket 'AROT Z30
POCKET1(10,0,2,-8,,30,24,6,0,0,0,300,1000)' 'G0 Z50'
swivel='CYCLE800(0,"TC1",0,57,0,0,0,20,0,0,0,0,0,1)
POCKET1(30,16,2,12,,60,24,6,0,0,0,300,1000)'
pocket "$swivel" 'SUPA G0 Z0 D0
CYCLE800()'
pocket "$swivel" 'CYCLE800()
SUPA G0 Z0 D0'
pocket "$swivel" 'G0 Z-5'
# A region certainly cuts nothing: the middle of the circle of two slots is not cut.
pocket 'SLOT2(10,0,2,-4,,2,30,12,0,0,22,0,180,300,1000,2,2,0,0)' 'G0 X0 Y0
Z-3.5'
