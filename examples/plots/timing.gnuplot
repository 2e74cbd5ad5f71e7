# timing.gnuplot - draws what --timing wrote: how long each block took to interpret and to check, and a step of motion.
#
#   gnuplot -c timing.gnuplot TIMES.csv PICTURE.svg [PROGRAM]
#
# PICTURE may end in .png, too. Of several programs in the table the named one is drawn, else all of them, one over
# the other. Below stands the time for a second of motion: above 1 s the check is slower than the machine.
if (ARGC < 2) { print "usage: gnuplot -c timing.gnuplot TIMES.csv PICTURE.svg [PROGRAM]"; exit status 2 }
times = ARG1
program = ARG3
if (ARG2[strlen(ARG2) - 3:] eq ".png") { set terminal pngcairo size 1200,800 } else { set terminal svg size 1200,800 }
set datafile separator comma
set output ARG2
set multiplot layout 2,1 title "Time to check" . (program eq "" ? "" : " " . program) noenhanced
set logscale y
set format y "%g"
set grid ytics
set key outside right top
set xlabel "block"
here(value) = (program eq "" || program eq stringcolumn(1)) && value > 0 ? value : NaN
set ylabel "microseconds a block"
plot times skip 1 using 4:(here(column(7))) with points pt 7 ps 0.3 title "interpreted", \
     times skip 1 using 4:(here(column(8))) with points pt 7 ps 0.3 title "checked"
set ylabel "s for a second of motion"
plot times skip 1 using 4:(column(6) > 0 ? here(1e-6 * (column(7) + column(8)) / column(6)) : NaN) \
     with points pt 7 ps 0.3 title "both"
unset multiplot
