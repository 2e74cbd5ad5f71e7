BEGIN TOOL .T MM
; seed
T     NAME        L        R     R2    DL    DR     DR2  TYP   LCUTS T-ANGLE 
0     NULL        +0       +0    +0    +0    +0     +0   0     +0    +0
5     D8,5 ü      +120.25  +4.25 +0    +0    -0.01  +0   DRILL 60    118
5.1   STEP        +100     +6    +0    +0    +0     +0   0     +0    +0
7                 +95,5    +4    +4    -0.02 -0.015 +0   22    12    +0
9     PROBE       +150     +2    +2    +0    +0     +0   21    +0    +0
12                +88      +20   +1
[END]
