# --parse-only -a continues after an error: all errors of a program in one pass, each message once, at most 20 of them.
small_machine
sed -i 's|<base>|<controller dialect="fanuc" least_input="0.001"/><base>|' m.xml
# One missing word is one error; X500 after an error is no finding, because the position of the axes is not known.
printf 'O1 G21 G90 G17\nG0 X1. M31\nG187 P1 E.1\nM31 X2.\nG555 X3.\n#1=\nM32\nX500.\nB5.\nG1 X2.\nM30\n' >p.nc
status fivecheck -q --parse-only -a m.xml p.nc 2>&1
status fivecheck -q --parse-only m.xml p.nc 2>&1
# Findings before the first error are reported.
printf 'G21 G90\nG0 X500.\nM31\nX-500.\nM30\n' >limit.nc
status fivecheck -q --parse-only -a m.xml limit.nc 2>&1
# 30 errors; an error in a loop; a program without an error.
for number in 1 2 3; do for digit in 0 1 2 3 4 5 6 7 8 9; do echo "M3$number$digit"; done; done >many.nc
fivecheck -q --parse-only -a m.xml many.nc 2>&1 | grep -c 'error: '
fivecheck --parse-only -a m.xml many.nc 2>&1 | grep 'note:'
printf 'G21 G90\n#1=0\nWHILE [#1 LT 5] DO1\n#1=#1+1\nM31\nEND1\nM30\n' >loop.nc
status fivecheck --parse-only -a m.xml loop.nc 2>&1
# An error of a subprogram that is called three times: the calls that led into it are named once, too.
printf 'O1 G21 G90\nM98 P2 L2\nM98 P2\nM30\nO2\nM31\nM99\n' >calls.nc
status fivecheck -q --parse-only -a m.xml calls.nc 2>&1
# Because of the error the loop never ends.
printf 'G21 G90\nN10 #1=SQRT[-1]\nGOTO 10\nM30\n' >endless.nc
status fivecheck --parse-only -a m.xml endless.nc 2>&1
printf 'G21 G90\nG0 X5.\nM30\n' >good.nc
status fivecheck -q --parse-only -a m.xml good.nc 2>&1

# Each missing element of the setup is one error: the block is executed, and arcs after it have their radius.
cat >lacks.nc <<'END'
G21 G90 G17 G0 X0 Y0
T3 M6
G55 G0 X10. Y5.
G43 H4 Z1.
G1 G41 D6 Y10. F100
G3 X5. Y15. I-5.
G1 G40 X0
G59 X1. M77
G2 X3. I1.
G0 G56 X#500 Y1.
G2 X5. Y2. R1.
G2 X3. Y4. I-1. J1.
M30
END
echo '<setup version="1"><work_offset name="G54"/></setup>' >empty.xml
stock_mill
sed 's|<base>|<controller dialect="fanuc" least_input="0.001"/><base>|; s|least_input|length_offset_moves="no" least_input|; s|"0.001"/>|"0.001"><tool_change/></controller>|' m.xml >more.xml
status fivecheck -q --parse-only -a -s empty.xml more.xml lacks.nc 2>&1
