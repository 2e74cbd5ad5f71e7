# make watches the files that --depfile names, whatever their names.
small_machine
echo 'G0 X10' >good.nc
cp m.xml 'a $b#c.xml'
cat >near.ngc <<'NC'
o<near> sub
G0 X20
o<near> endsub
NC
echo 'o<near> call' >main.nc
status fivecheck -q -o main.checked --depfile main.d m.xml main.nc
cat main.d
status fivecheck -q --parse-only -f 'ndjson=o u:t%.json' --depfile odd.d 'a $b#c.xml' good.nc
# make reads the depfile: after the first run everything is up to date, after a change of any input it is not.
cat >Makefile <<'MK'
o\ u\:t\%.json:
	@echo made; touch 'o u:t%.json'
main.checked:
	@echo checked; touch $@
-include main.d odd.d
MK
uptodate() {
	make -s -q "$1" && echo "$1 is up to date" || echo "$1 is to be made"
}
touch -d '-3 hours' m.xml head.stl table.stl main.nc near.ngc 'a $b#c.xml' good.nc
touch -d '-2 hours' main.checked 'o u:t%.json'
uptodate main.checked
uptodate 'o u:t%.json'
for input in m.xml head.stl table.stl main.nc near.ngc; do
	touch -d '-1 hour' "$input"
	uptodate main.checked
	touch -d '-3 hours' "$input"
done
uptodate main.checked
touch -d '-1 hour' 'a $b#c.xml'
uptodate 'o u:t%.json'
# A deleted mesh that is no longer needed does not stop make.
rm head.stl
make -s main.checked
status fivecheck --depfile x.d m.xml good.nc
status fivecheck --depfile m.xml -o out m.xml good.nc
