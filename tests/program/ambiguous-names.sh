# A name that may mean two places is refused where it is used, with both lines: labels, block numbers and programs of
# the sinumerik dialect, labels of klartext. A file, redirected input and a pipe give the same status.
small_machine
sed 's|<base>|<controller dialect="sinumerik" path_tolerance="0.01"/><base>|' m.xml >s.xml
sed 's|<base>|<controller dialect="klartext" path_tolerance="0.01"/><base>|' m.xml >k.xml

# ways MACHINE - p.nc as a file, redirected and on a pipe: the status of each, and the positions
ways() {
	for way in file redirected pipe; do
		case $way in
		file) fivecheck --include=lib --dump-path "$1" p.nc >out ;;
		redirected) fivecheck --include=lib --dump-path "$1" - <p.nc >out ;;
		pipe) cat p.nc | fivecheck --include=lib --dump-path "$1" - >out ;;
		esac
		echo "$way $?: $(cut -f 1,4,5 out | tail -n +2 | tr '\t\n' ' ;')"
	done
}
# three MACHINE - the same of the program of standard input
three() {
	cat >p.nc
	ways "$1"
}
mkdir lib

echo '== labels'
# Forward, backward, in either direction, by number, and the start and the end of a repeated part.
for jump in 'GOTOF AA' 'GOTO AA' 'GOTOC N7' 'REPEAT AA BB' 'CALL BLOCK AA TO BB'; do
	echo "-- $jump"
	printf 'G500 G17 G71 G90 G0\n%s\nM30\nAA:\nN7 X1\naa : X2\nN7 X3\nBB:\nM30\n' "$jump" | three s.xml
done
for jump in 'GOTOB AA' 'GOTO AA' 'GOTOB N7' 'REPEAT AA P=1' 'REPEAT BB CC' 'IF R1==2 GOTOB AA'; do
	echo "-- $jump"
	printf 'G500 G17 G71 G90 G0\nR1=1\nAA: R1=R1+1\nBB:\nAA:\nN7 X1\nN7 X2\nCC:\nX3\nCC:\n%s\nM30\n' "$jump" | three s.xml
done
# One label in the direction of the search is enough, and other programs have labels of their own.
printf 'G500 G17 G71 G90 G0\nR1=0\nAA: R1=R1+1 X=R1\nIF R1<2 GOTOB AA\nGOTOF AA\nX9\nAA: X10\nM30\n' | three s.xml
printf '%%_N_A_MPF\nG500 G17 G71 G90 G0\nGOTOF AA\nX9\nAA: X1\nSUB\nM30\n%%_N_SUB_SPF\nGOTOF AA\nX8\nAA: X2\nM17\n' | three s.xml
# Posts end the parts behind M30 with one label, and ENDLABEL stands once for each part.
printf 'G500 G17 G71 G90 G0\nREPEAT P1 PE\nREPEAT P2 PE\nM30\nP1:\nX1\nPE:\nP2:\nX2\nPE:\n' | three s.xml
printf 'G500 G17 G71 G91 G0\nP1: X1\nENDLABEL:\nP2: X10\nENDLABEL:\nREPEAT P1\nREPEAT P2\nM30\n' | three s.xml

echo '== sections'
head='%%_N_A_MPF\nG500 G17 G71 G90 G0\n'
printf "$head"'SUB\nM30\n%%_N_SUB_SPF\nX1\nM17\n%%_n_sub_spf\nX2\nM17\n' | three s.xml
printf "$head"'SUB\nM30\n%%_N_SUB_MPF\nX1\nM17\n%%_N_SUB_SPF\nX2\nM17\n' | three s.xml
printf "$head"'CALL "SUB_SPF"\nM30\n%%_N_SUB_MPF\nX1\nM17\n%%_N_SUB_SPF\nX2\nM17\n' | three s.xml
printf "$head"'SUB\nX3\nSUB P2\nM30\n%%_N_SUB_SPF\nX=IC(1)\nM17\n' | three s.xml

echo '== files'
# A file in a folder of --include, and a program of its name in the same file.
printf 'X5\nM17\n' >lib/SUB.SPF
printf "$head"'SUB\nM30\n%%_N_SUB_SPF\nX1\nM17\n' | three s.xml
printf "$head"'SUB\nM30\n%%_N_OTHER_SPF\nX1\nM17\n' | three s.xml
# Called from a file, a program of the main program's file.
printf 'X6\nOTHER\nM17\n' >lib/SUB.SPF
printf "$head"'SUB\nM30\n%%_N_OTHER_SPF\nX1\nM17\n' | three s.xml
printf 'X7\nM17\n' >lib/OTHER.SPF
printf "$head"'SUB\nM30\n%%_N_OTHER_SPF\nX1\nM17\n' | three s.xml
# Two files in one folder; the type tells them apart.
printf 'X8\nM17\n' >lib/OTHER.MPF
printf "$head"'OTHER\nM30\n' | three s.xml
printf "$head"'EXTCALL "OTHER.MPF"\nCALL "_N_OTHER_SPF"\nM30\n' | three s.xml
printf 'X9\nM17\n' >lib/other.spf
printf "$head"'CALL "OTHER_SPF"\nM30\n' | three s.xml
printf 'X9\nM17\n' >lib/THIRD.SPF
# A folder that ignores the case of names has one file of both names.
ln lib/THIRD.SPF lib/third.spf
printf "$head"'THIRD\nM30\n' | three s.xml
rm lib/third.spf
# Paths of two folders of the control, for which there is only one file here.
for path in /_N_WKS_DIR/_N_B_WPD/THIRD /_n_wks_dir/_n_a_wpd/third THIRD; do
	printf "$head"'CALL "/_N_WKS_DIR/_N_A_WPD/_N_THIRD_SPF"\nPCALL %s\nM30\n' $path | three s.xml
done
printf "$head"'CALL "/_N_WKS_DIR/_N_A_WPD/_N_THIRD_SPF"\nEXTCALL "/WKS.DIR/A.wpd/THIRD.SPF"\nM30\n' | three s.xml
# The folder of the program comes before the folders of --include, whatever the type.
printf 'X8\nM17\n' >THIRD.MPF
printf "$head"'THIRD\nM30\n' >q.mpf
fivecheck --include=lib --dump-path s.xml q.mpf | cut -f 1,4
rm THIRD.MPF

echo '== a pipe with more than 4 MiB behind the line'
# far - as many bytes of blank lines
far() {
	head -c 4500000 /dev/zero | tr '\0' ' ' | fold -w 100
	echo
}
# A label may come twice up to the end of its program, a program up to the end of the file.
for call in 'GOTOF AA' 'FOUR' 'CALL "THIRD.SPF"'; do
	{
		printf "$head"'%s\nAA: X1\nM30\n%%_N_FOUR_SPF\nX2\nM17\n' "$call"
		far
	} >p.nc
	echo "-- $call"
	ways s.xml
done
echo '-- GOTOF AA'
{
	printf "$head"'GOTOF AA\nAA: X1\n'
	far
	echo M30
} >p.nc
ways s.xml

echo '== klartext'
for labels in '1 01' '"A" A' '2 1'; do
	set -- $labels
	printf 'BEGIN PGM P MM\nL X+0 R0 FMAX\nCALL LBL %s\nM30\nLBL %s\nL X+1 FMAX\nLBL 0\nLBL %s\nL X+2 FMAX\nLBL 0\nEND PGM P MM\n' \
		"$1" "$1" "$2" | three k.xml
done
{
	printf 'BEGIN PGM P MM\nL X+0 R0 FMAX\nCALL LBL 1\nM30\nLBL 1\nL X+1 FMAX\nLBL 0\n'
	far
	echo 'END PGM P MM'
} >p.nc
ways k.xml
