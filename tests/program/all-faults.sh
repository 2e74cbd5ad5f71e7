# --parse-only -a reads on after a fault: every fault of a program in one pass, each message once, at most 20 of them.
small_machine
sed -i 's|<base>|<controller dialect="fanuc" least_input="0.001"/><base>|' m.xml
# One missing word is one fault; X500 behind a fault is no finding, because nobody knows where the axes are.
printf 'O1 G21 G90 G17\nG0 X1. M31\nG187 P1 E.1\nM31 X2.\nG555 X3.\n#1=\nM32\nX500.\nB5.\nG1 X2.\nM30\n' >p.nc
status fivecheck -q --parse-only -a m.xml p.nc 2>&1
status fivecheck -q --parse-only m.xml p.nc 2>&1
# What is found before the first fault is told.
printf 'G21 G90\nG0 X500.\nM31\nX-500.\nM30\n' >limit.nc
status fivecheck -q --parse-only -a m.xml limit.nc 2>&1
# 30 faults; a fault in a loop; a program without a fault.
for number in 1 2 3; do for digit in 0 1 2 3 4 5 6 7 8 9; do echo "M3$number$digit"; done; done >many.nc
fivecheck -q --parse-only -a m.xml many.nc 2>&1 | grep -c 'error: '
fivecheck --parse-only -a m.xml many.nc 2>&1 | grep 'note:'
printf 'G21 G90\n#1=0\nWHILE [#1 LT 5] DO1\n#1=#1+1\nM31\nEND1\nM30\n' >loop.nc
status fivecheck --parse-only -a m.xml loop.nc 2>&1
# The fault leaves the loop without its end.
printf 'G21 G90\nN10 #1=SQRT[-1]\nGOTO 10\nM30\n' >endless.nc
status fivecheck --parse-only -a m.xml endless.nc 2>&1
printf 'G21 G90\nG0 X5.\nM30\n' >good.nc
status fivecheck -q --parse-only -a m.xml good.nc 2>&1
