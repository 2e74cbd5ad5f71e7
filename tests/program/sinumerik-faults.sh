# After an error, -a reads every block once: a loop with an unknown condition would have no end.
small_machine
sed 's/<base>/<controller dialect="sinumerik" path_tolerance="0.01"\/>\n<base>/' m.xml >s.xml
program loops.mpf <<'NC'
N1 G500 G17 G71 G90 F600
FOR NOBODY=0 TO 1
X1
ENDFOR
WHILE UNKNOWN<3
X2
ENDWHILE
AGAIN: R1=MISSING
IF R1<1 GOTOB AGAIN
LOOP
Q1
ENDLOOP
M30
NC
"$FIVECHECK" --parse-only -a s.xml loops.mpf

# A refused modal call does not act: the blocks after it are read once, too.
program modal.mpf <<'NC'
%
N1 G500 G17 G71 G90 F600
MCALL CYCLE80
X10
X20
G2 X30 CR=5
MCALL NOWHERE
X40
M30
NC
"$FIVECHECK" --parse-only -a s.xml modal.mpf

# After a subprogram has redefined a name of DEFINE, or changed its parameter and is repeated.
program changed.mpf <<'NC'
%_N_MAIN_MPF
N1 G500 G17 G71 G90 F600
DEFINE GO_ON AS X10
SAME
GO_ON
OTHER
DOWN(5) P2
M30
%_N_SAME_SPF
DEFINE GO_ON AS X10
RET
%_N_OTHER_SPF
DEFINE GO_ON AS X20
RET
%_N_DOWN_SPF
PROC DOWN(INT BY, REAL AT=1)
X=AT
AT=AT-BY
RET
NC
"$FIVECHECK" --parse-only -a s.xml changed.mpf
