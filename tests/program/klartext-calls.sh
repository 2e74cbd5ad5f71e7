# Klartext from files: CALL PGM finds programs beside the program and in --include, messages name the calls that led there,
# a pipe is read like a file, endless loops end, and text after M30 is not a second program.
small_machine
sed 's|<base|<controller dialect="klartext" path_tolerance="0.01"><tool_change/></controller><base|' m.xml >k.xml
mkdir more
printf '0 BEGIN PGM SUB MM\n1 L IX+1 R0 F1000\n2 END PGM SUB MM\n' >sub.h
printf '0 BEGIN PGM FAR MM\n1 CALL PGM sub.h\n2 L IZ+5\n3 END PGM FAR MM\n' >more/FAR.H
program p.h <<'NC'
0 BEGIN PGM P MM
1 CALL PGM TNC:\NC\sub.h
2 CALL PGM FAR
3 CALL LBL 1
4 L M30
5 LBL 1
6 L IZ+1
7 LBL 0
8 END PGM P MM
NC
fivecheck --dump-path --include=more k.xml p.h | cut -f 1,4-6
status fivecheck --parse-only k.xml p.h
fivecheck --dump-path --include=more --include=. k.xml - <p.h | cut -f 1,4-6 | tail -n 1

# SEL PGM and CALL SELECTED PGM, and cycle 12 after a move: the move comes first, then the program, then the rest.
program q.h <<'NC'
0 BEGIN PGM P MM
1 SEL PGM "TNC:\NC\sub.h"
2 CALL SELECTED PGM
3 CYCL DEF 12.0 PGM CALL
4 CYCL DEF 12.1 PGM sub
5 L Z+7 FMAX M99
6 L IZ+1
7 END PGM P MM
NC
fivecheck --dump-path k.xml q.h | cut -f 1,4-6

# SEL PATTERN: the points of a table beside the program, without those that FADE hides; an empty value between others.
printf 'BEGIN P.PNT MM\nNR   X      Y     Z     FADE  CLEARANCE\n0    +1,5   +2    -1    N\n1    +3     +4          Y\n' >P.PNT
printf '2    +5     +6\n[END]\n' >>P.PNT
program q.h <<'NC'
0 BEGIN PGM P MM
1 CYCL DEF 200 DRILLING Q200=2 Q201=-5 Q206=150 Q202=5 Q203=+0 Q204=20
2 SEL PATTERN "TNC:\NC\P"
3 CYCL CALL PAT FMAX
4 END PGM P MM
NC
fivecheck --dump-path k.xml q.h | cut -f 1,4-6
sed -i 's/Q203=+0/Q203=+1/' q.h
status fivecheck --parse-only k.xml q.h
sed -i 's/^2 .*/2    +5     +6                7/' P.PNT
status fivecheck --parse-only k.xml q.h
sed -i 's/^2 .*/2         +6/' P.PNT
status fivecheck --parse-only k.xml q.h
sed -i 's/^2 .*/2    +100000  +6/' P.PNT
status fivecheck --parse-only k.xml q.h
sed -i 's/MM$//' P.PNT
status fivecheck --parse-only k.xml q.h
# Ambiguous columns: two values below one name, a name twice, tabs.
printf 'BEGIN P.PNT MM\nNR X Y Z\n0 1 2 3\n[END]\n' >P.PNT
status fivecheck --parse-only k.xml q.h
printf 'BEGIN P.PNT MM\nX    Y    X\n1    2    3\n[END]\n' >P.PNT
status fivecheck --parse-only k.xml q.h
printf 'BEGIN P.PNT MM\nNR\tX\tY\n1\t1\t2\n[END]\n' >P.PNT
status fivecheck --parse-only k.xml q.h

# The error is two calls deep.
printf '0 BEGIN PGM SUB MM\n1 L IX+1 R0\n2 END PGM SUB MM\n' >sub.h
status fivecheck --parse-only --include=more k.xml p.h

printf 'BEGIN PGM P MM\nLBL 1\nL X+0 FMAX\nCALL LBL 2\nFN 9: IF 1 EQU 1 GOTO LBL 1\nM2\nLBL 2\nLBL 0\nEND PGM P MM\n' >p.h
status fivecheck --parse-only --max-blocks=1000 k.xml p.h

# The signs of the other kind of control, both ways.
printf 'G0 X1\nM30\n' >g.nc
status fivecheck --parse-only k.xml g.nc
status fivecheck --parse-only m.xml p.h

# Names in upper and lower case mean one file; different folders may mean two files, of which only one exists.
printf '0 BEGIN PGM SUB MM\n1 L IX+1 R0 F1000\n2 END PGM SUB MM\n' >sub.h
program w.h <<'NC'
0 BEGIN PGM P MM
1 CALL PGM TNC:\A\sub.h
2 CALL PGM a\SUB.H
3 CALL PGM Sub
4 END PGM P MM
NC
fivecheck --dump-path k.xml w.h | cut -f 1,4-6
sed -i 's/^3 .*/3 CALL PGM TNC:\\B\\SUB.H/' w.h
status fivecheck --parse-only k.xml w.h
