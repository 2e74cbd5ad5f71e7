# scan reads Klartext past its first TOOL CALL: tools of any number and name, and their radii, need no setup.
program part.h <<'NC'
0 BEGIN PGM PART MM
1 TOOL DEF 3 L+50 R+4
2 TOOL CALL 3 Z S2000 DL+0.1
3 L X+0 Y+0 R0 FMAX M77
4 L X+10 RL F500
5 L X+50
6 L Y+20 R0
7 TOOL CALL "DRILL 8" Z S1000
8 CYCL DEF 240 CENTERING ~
    Q200=+2 ~
    Q343=+1 ~
    Q201=-1 ~
    Q344=-4 ~
    Q206=+150 ~
    Q211=+0 ~
    Q203=+0 ~
    Q204=+50
9 CYCL CALL M3
10 L Z+Q1600 FMAX
11 PLANE SPATIAL SPA+30 SPB+0 SPC+0 TURN MB MAX FMAX
12 L M92 Z+0 FMAX
13 PLANE RESET STAY
14 L C+90 FMAX
15 PLANE SPATIAL SPA+0 SPB+0 SPC+30 TURN FMAX
16 PLANE RESET STAY
17 CYCL DEF 392 ATC Q240=0
18 END PGM PART MM
NC
status fivecheck scan part.h 2>&1 | sed -n '/error/p; /^needed in the machine/,$p'
# Parameters that keep their values, and data of the tables that FN 18 reads; the lines are those that a machine file takes.
program kept.h <<'NC'
0 BEGIN PGM KEPT MM
1 FN 18: SYSREAD Q1 = ID50 NR3 IDX12
2 L X+Q1600 Y+QR5 Z+Q1 R0 FMAX
3 CALL LBL QS3
4 LBL "1"
5 LBL 0
6 END PGM KEPT MM
NC
status fivecheck scan --dialect=klartext kept.h 2>&1 | sed -n '/error/p; /^needed in the machine/,/^$/p; /status/p'
