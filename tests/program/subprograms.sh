# A subprogram's file is found beside the program and in --include folders only; findings name its file.
small_machine
mkdir lib
printf 'G21\no<far> call [3]\nM2\n' >a.nc
printf 'o<far> sub\nG0 X#1\no<near> call\no<far> endsub\n' >lib/far.ngc
printf 'o<near> sub\nG0 X99999\no<near> endsub\n' >near.ngc
fivecheck --dump-path m.xml a.nc
echo "exit $?"
fivecheck --dump-path --include=lib m.xml a.nc
echo "exit $?"
fivecheck --parse-only --include=lib -q m.xml a.nc
echo "exit $?"
printf 'o1 while [1]\no1 endwhile\n' >b.nc
fivecheck --parse-only --max-blocks=500 -f ndjson m.xml b.nc >b.json
status=$?
grep -v -e header b.json
(exit $status)
echo "exit $?"
fivecheck --parse-only --max-blocks=0 m.xml b.nc
