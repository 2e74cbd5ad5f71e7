# Klartext: every error of a program is reported once, in one pass: the lines of a refused cycle and its calls are not
# further errors.
small_machine
sed 's|<base|<controller dialect="klartext" path_tolerance="0.01"><tool_change/></controller><base|' m.xml >k.xml
program p.h <<'NC'
0 BEGIN PGM P MM
1 TOOL CALL 0 Z F500
2 CYCL DEF 392 SET-UP ~
    Q240=+0    ;MODE ~
    Q241=+1    ;WEIGHT
3 CYCL DEF 25 CONTOUR TRAIN ~
    Q1=-20 ;DEPTH ~
    Q12=AUTO ;FEED
4 L X+1 FMAX M99
5 CYCL DEF 444 OLD ~
    Q263=MAX
6 CYCL DEF 65.0 BUILDER
7 CYCL DEF 65.1 X+5
8 L X+2 FMAX M99
9 TCH PROBE 413 DATUM ~
    Q321=+0 ~
    Q322=+0
10 TCH PROBE 0.0 REF. PLANE Q5 X-
10 TCH PROBE 0.1 X+5 Z-5
10 CYCLE DEF 9.0 DWELL
11 L X+5 M144
12 L Z+5 M104
13 L Q5
14 END PGM P MM
NC
status fivecheck --parse-only -a k.xml p.h
# A corner that is refused is not an error of the line before it as well.
program r.h <<'NC'
0 BEGIN PGM R MM
1 TOOL CALL 0 Z F500
2 L X+1 F100
3 RND
4 L X+5
5 END PGM R MM
NC
status fivecheck --parse-only k.xml r.h
status fivecheck --parse-only -a k.xml r.h
