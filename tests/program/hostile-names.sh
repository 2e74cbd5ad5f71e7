# A foreign file name can neither add lines to a report nor control the terminal.
small_machine
program bad.nc <<'NC'
G21 G90 G61
G1 Z-120 F6000
M2
NC
escape=$(printf '\033')
name="bad.nc
ok.nc: clear: 3 blocks${escape}[2J$(printf '\302\233').nc"
cp bad.nc "$name"
echo '== a finding'
status fivecheck m.xml "$name" 2>&1 | grep -v "blocks/s"
echo '== a fault'
printf 'G999\n' >"$name"
status fivecheck -q m.xml "$name" 2>&1
echo '== a file that is not there'
status fivecheck -q m.xml "no$name" 2>&1
status fivecheck -q "no$name" bad.nc 2>&1
echo '== a block'
printf 'G1 Z-120 F6000 (\302\233 2J \303\251)\n' >block.nc
status fivecheck -q m.xml block.nc 2>&1 | grep 'block  '
printf 'G1 Z-1 F6000 (\302\233) G999\n' >block.nc
status fivecheck -q m.xml block.nc 2>&1
echo '== an option'
status fivecheck -q --no"$escape" m.xml bad.nc 2>&1
