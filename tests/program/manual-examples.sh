# The examples of fivecheck-machine(5) are files that fivecheck accepts, as they are shown.
need python3
page=$(dirname "$LIB")/../../man/fivecheck-machine.5
cat >examples.py <<'PY'
import re
import sys

text = open(sys.argv[1]).read()
blocks = [block.replace('\\e', '\\') for block in re.findall(r'^\.Bd -literal -offset indent\n(<.*?)^\.Ed', text, re.M | re.S)]
names = {'<machine': 'machine', '<setup': 'setup', '<jobs': 'jobs', '<waivers': 'waivers', '<controller': 'control', '<axis': 'nutating'}
found = [names[re.match(r'<\w+', block).group()] for block in blocks]
assert sorted(found) == sorted(names.values()), found
files = dict(zip(found, blocks))
files['control'] = re.sub(r'<controller.*?/>\n', lambda _: files['control'], files['machine'], count=1)
files['nutating'] = f'<machine version="1"><base>\n{files["nutating"]}</base></machine>\n'
for name, content in files.items():
    with open(name + '.xml', 'w') as file:
        file.write(content)
PY
python3 examples.py "$page"
mkdir ac dmu50
for name in bed saddle ram cover head cradle table; do
	box "$name" 0 0 0 100 100 100
	mv "$name.stl" ac
done
for name in vise impeller chuck fork head; do
	box "$name" 0 0 0 10 10 10
done
for name in machine control; do
	status fivecheck -q --check-machine -s setup.xml -o "$name.txt" "$name.xml"
done
status fivecheck -q --list-pairs -o nutating.txt nutating.xml
grep -c '' machine.txt control.txt nutating.txt | sed 's/:[1-9].*/: not empty/'
# Programs of the names that the examples use; the waiver is for a program of that machine.
echo 'G21 G61 G0 X1' >part.nc
cp part.nc 1001.nc
cp part.nc 1002.nc
cp part.nc 2001.nc
status fivecheck -q --parse-only -s setup.xml --waivers waivers.xml machine.xml part.nc
sed 's,ac/,../ac/,' machine.xml >dmu50/machine.xml
cp setup.xml op10.xml
cp setup.xml op20.xml
status fivecheck -q --parse-only jobs.xml
