# All files named by foreign files must be below --input-root, also by way of ".." and links.
small_machine
mkdir in out lib
mv head.stl table.stl out
cp out/*.stl in
cp m.xml in/m.xml
echo 'G0 X10' >a.nc
status fivecheck -q --input-root in in/m.xml a.nc
status fivecheck -q --input-root=. in/m.xml a.nc
status fivecheck -q --input-root=/ in/m.xml a.nc
# Outside by "..", by an absolute path, by a link to a file, through a link to a folder.
sed 's,head.stl,../out/head.stl,' m.xml >in/up.xml
sed "s,head.stl,$PWD/out/head.stl," m.xml >in/absolute.xml
ln -s ../out/head.stl in/link.stl
sed 's,head.stl,link.stl,' m.xml >in/link.xml
ln -s ../out in/folder
sed 's,head.stl,folder/head.stl,' m.xml >in/folder.xml
for case in up absolute link folder; do
	status fivecheck -q --input-root in in/$case.xml a.nc 2>&1 | sed "s,$PWD,HERE,"
done
# A neighbouring folder with the same beginning of its name is outside; a missing file too; a link to a file inside is
# inside.
mkdir in2
cp out/head.stl in2
sed 's,head.stl,../in2/head.stl,' m.xml >in/alike.xml
status fivecheck -q --input-root in in/alike.xml a.nc
sed 's,head.stl,../out/no.stl,' m.xml >in/none.xml
status fivecheck -q --input-root in in/none.xml a.nc
ln -s head.stl in/within.stl
sed 's,head.stl,within.stl,' m.xml >in/within.xml
status fivecheck -q --input-root in in/within.xml a.nc
# The setup, in every mode; allowed without the option.
setup in/s.xml <<'XML'
  <fixture name="vise" mesh="../out/table.stl" location="0 0 300"/>
XML
status fivecheck -q --input-root in --list-pairs -s in/s.xml in/m.xml
status fivecheck -q -s in/s.xml in/m.xml a.nc
# A tool library outside is never opened, neither from a setup nor from a setup inside the machine file.
printf 'T1 P1 Z100 D6\n' >out/tool.tbl
echo 'a secret line' >out/secret
for name in out/tool.tbl out/secret; do
	setup in/t.xml <<-XML
	  <tools href="../$name"/>
	XML
	status fivecheck -q --input-root in -s in/t.xml in/m.xml a.nc
	sed "s,</machine>,<setup version=\"1\"><tools href=\"../$name\"/></setup></machine>," m.xml >in/inside.xml
	status fivecheck -q --input-root in in/inside.xml a.nc
done
# Subprograms: in the folder of the program, by a link to a file outside, in a folder of --include.
printf 'o<sub> call\nM2\n' >in/p.nc
printf 'o<sub> sub\nG0 X1\no<sub> endsub\n' >lib/sub.ngc
cp lib/sub.ngc in
status fivecheck -q --input-root in in/m.xml in/p.nc
ln -sf ../lib/sub.ngc in/sub.ngc
status fivecheck -q --input-root in in/m.xml in/p.nc
status fivecheck -q in/m.xml in/p.nc
printf '%%\nO1\nM98 P7\nM30\n%%\n' >in/f.nc
printf '%%\nO7\nG21 G90 G0 X1.\nM99\n%%\n' >lib/O7.nc
status fivecheck -q --dialect fanuc --input-root in --include lib in/m.xml in/f.nc
status fivecheck -q --dialect fanuc --include lib in/m.xml in/f.nc
status fivecheck -q --input-root nowhere in/m.xml a.nc
# A job file is trusted, the files that it names are not.
cp a.nc in
echo 'a secret line' >out/secret.nc
cat >in/jobs.xml <<'XML'
<jobs version="1">
  <job name="a" machine="m.xml"><program file="a.nc"/></job>
  <job name="b" machine="m.xml"><program file="a.nc"/></job>
</jobs>
XML
status fivecheck -q --input-root in in/jobs.xml
for change in '3s,a.nc,../out/secret.nc,' '3s,m.xml,../m.xml,' '3s,m.xml",m.xml" setup="../out/secret.nc",' \
	'3s,m.xml",m.xml" waivers="../out/secret.nc",'; do
	sed "$change" in/jobs.xml >in/bad.xml
	status fivecheck -q --input-root in in/bad.xml
	status fivecheck -q --input-root in --depends in/bad.xml
done
# In a job file - is a file name.
sed 's/a\.nc/-/' in/jobs.xml >in/minus.xml
(cd in && echo 'G0 X300' | status fivecheck -q minus.xml)
