# <variable> in the machine file gives values that the control keeps from earlier programs. scan prints these lines.
small_machine
machine() {
	sed "s|<base|<controller dialect=\"$1\" rapid=\"linear\" power_on_units=\"mm\" power_on_distance=\"absolute\" power_on_plane=\"xy\" least_input=\"1\">$2</controller><base|" m.xml
}
program a.mpf <<'NC'
N10 G0 G90 G500 G710
N20 IF _READY==1
N30 X=_POS[2,1] C=R5
N40 ENDIF
N50 _MADE="A"
N60 Z=$MN_TOP+_MADE_NOT
N70 _POS[0,0]=3
N80 X=_POS[0,0]
N85 POS[Z]=1
N90 M30
NC
program b.nc <<'NC'
%
O1
G0 G90 G21 G17 X#500 C#[100+R]
M30
%
NC
sed -i 's/+R]/+401]/' b.nc
status fivecheck scan --dialect=sinumerik a.mpf 2>&1 | grep -v '^[GM]'
status fivecheck scan --dialect=fanuc b.nc 2>&1 | sed -n '/machine file/,$p'
machine sinumerik '' >s.xml
status fivecheck -q --parse-only -a s.xml a.mpf 2>&1 | grep error
machine sinumerik '<variable name="_ready" type="INT" value="1"/><variable name="_POS" type="REAL" size="3,2"/><variable name="_POS[2,1]" value="12.5"/><variable name="R5" value="7"/><variable name="_MADE" type="STRING"/><variable name="$MN_TOP" value="40"/><variable name="_MADE_NOT" type="REAL" value="0.5"/>' >s.xml
status fivecheck -q --dump-path s.xml a.mpf | cut -f 1-6
machine fanuc '<variable name="#500" value="4"/><variable name="#501" value="vacant"/>' >f.xml
status fivecheck -q --dump-path f.xml b.nc | cut -f 1-6
# Each program of a run begins with them again: the 900 mm of the first would be beyond the limits of X in the second.
program one.nc <<'NC'
%
O1
G0 G90 G21 G17
#500=900
M30
%
NC
program two.nc <<'NC'
%
O2
G0 G90 G21 G17 X#500
M30
%
NC
machine fanuc '<variable name="#500" value="4"/>' >f.xml
status fivecheck -q --parse-only f.xml one.nc two.nc 2>&1 | grep -v 'without a tolerance'
# A setup replaces values of the machine file for its job; values only in the machine file stay.
machine fanuc '<variable name="#500" value="4"/><variable name="#501" value="3"/>' >f.xml
sed 's/C#\[100+401\]/Z#501/' b.nc >c.nc
echo '<setup version="1"><variable name="#500" value="9"/></setup>' >setup.xml
status fivecheck -q -s setup.xml --dump-path f.xml c.nc | cut -f 1-6
machine sinumerik '<variable name="_ready" type="INT" value="0"/><variable name="_POS" type="REAL" size="3,2" value="1"/><variable name="R5" value="7"/><variable name="_MADE" type="STRING"/><variable name="$MN_TOP" value="40"/>' >s.xml
echo '<setup version="1"><variable name="_READY" value="1"/><variable name="_POS[2,1]" value="15"/><variable name="$MN_TOP" value="30"/><variable name="_MADE_NOT" type="REAL" value="0.5"/></setup>' >setup.xml
status fivecheck -q -s setup.xml --dump-path s.xml a.mpf | cut -f 1-6
# A redefined array loses its elements; a name without a value removes the value.
sed 's|<variable name="R5"|<variable name="_POS[2,1]" value="11"/>&|' s.xml >e.xml
echo '<setup version="1"><variable name="_READY" value="1"/><variable name="_POS" type="REAL" size="3,2" value="16"/><variable name="_MADE_NOT" type="REAL" value="0.5"/></setup>' >setup.xml
status fivecheck -q -s setup.xml --dump-path e.xml a.mpf | cut -f 1-6
echo '<setup version="1"><variable name="_READY"/><variable name="_MADE_NOT" type="REAL" value="0.5"/></setup>' >setup.xml
status fivecheck -q -s setup.xml --parse-only e.xml a.mpf 2>&1 | grep error
echo '<setup version="1"><variable name="_POS" value="1"/></setup>' >setup.xml
status fivecheck -q -s setup.xml --parse-only s.xml a.mpf 2>&1 | grep error
printf '<setup version="1"><variable name="R5" value="9"/>\n<variable name="R5" value="8"/></setup>\n' >setup.xml
status fivecheck -q -s setup.xml --parse-only s.xml a.mpf 2>&1 | grep error
status fivecheck -q -s setup.xml --parse-only m.xml a.mpf 2>&1 | grep error
# An error in an element that is found only with a program is reported at the element.
cat >k.h <<'NC'
BEGIN PGM K MM
FN 18: SYSREAD Q1 = ID50 NR3 IDX1
L X+Q1 R0 FMAX
END PGM K MM
NC
for element in 'ID50 NR3 IDX1" value="3,5' 'ID240 NR1 IDX1" value="3' 'Q120" value="3' 'Q5" value="five' 'QS1900x" value="a'; do
	sed "s|<base|<controller dialect=\"klartext\">\n<variable name=\"$element\"/></controller>&|" m.xml >k.xml
	status fivecheck -q --parse-only k.xml k.h 2>&1 | grep error:
done
for element in '_A" type="INT" size="2" value="1"/><variable name="_A[2]" value="1' 'R05" value="1' '_B" value="1' '_X" type="AXIS" value="B' '_T" type="BOOL" value="7' '$AA_IM[X]" value="1'; do
	machine sinumerik "<variable name=\"$element\"/>" | sed "s/<variable/\n&/" >k.xml
	status fivecheck -q --parse-only k.xml a.mpf 2>&1 | grep error:
done
machine fanuc '<variable name="#500" value="none"/>' | sed 's/<variable/\n&/' >k.xml
status fivecheck -q --parse-only k.xml b.nc 2>&1 | grep error:
