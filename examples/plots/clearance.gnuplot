# clearance.gnuplot - draws what --clearance-report wrote: how near each pair of bodies comes, block by block.
#
#   gnuplot -c clearance.gnuplot REPORT.csv PICTURE.svg [PROGRAM]
#
# PICTURE may end in .png, too. Of several programs in the report the named one is drawn, else all of them, one
# over the other. A pair that is never nearer than the cap is left out; a line at the cap means: no nearer than this.
# gnuplot ends a name at its first comma or quotation mark.
if (ARGC < 2) { print "usage: gnuplot -c clearance.gnuplot REPORT.csv PICTURE.svg [PROGRAM]"; exit status 2 }
report = ARG1
program = ARG3
if (ARG2[strlen(ARG2) - 3:] eq ".png") { set terminal pngcairo size 1200,600 } else { set terminal svg size 1200,600 }
set datafile separator comma
set datafile missing NaN

# The pairs that come within the cap.
pairs = ""
count = 0
note(a, b, capped) = capped == 1 || strstrt(pairs, "\n" . a . "\t" . b . "\n") ? 0 : \
	(pairs = pairs . (count ? "" : "\n") . a . "\t" . b . "\n", count = count + 1)
stats report skip 1 using (note(stringcolumn(5), stringcolumn(6), column(8)), 0) nooutput
if (!exists("STATS_records") || STATS_records == 0) { print report . " holds no blocks"; exit status 2 }
name(i) = (start = 1, rest = pairs[2:], sum [k = 1:i - 1] (rest = rest[strstrt(rest, "\n") + 1:], 0), \
	rest[1:strstrt(rest, "\n") - 1])
title(i) = (text = name(i), text[1:strstrt(text, "\t") - 1] . " - " . text[strstrt(text, "\t") + 1:])

set output ARG2
set title "Proven clearance" . (program eq "" ? "" : " in " . program) noenhanced
set xlabel "block"
set ylabel "mm"
set yrange [0:*]
set grid ytics
set key outside right top noenhanced
wanted(i) = (program eq "" || program eq stringcolumn(1)) && stringcolumn(5) . "\t" . stringcolumn(6) eq name(i)
if (count == 0) {
	set label 1 "nothing came within the cap" at graph 0.5, 0.5 center
	plot [0:1] 0 notitle with lines lc rgb "#00000000"
} else {
	plot for [i = 1:count] report skip 1 using (wanted(i) ? column(4) : NaN):7 with steps title title(i)
}
