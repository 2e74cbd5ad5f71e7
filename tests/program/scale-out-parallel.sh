# examples/scale-out with GNU parallel, and the command of its Kubernetes job: the shards have the same findings as one
# run.
need jq
scale_out="$(dirname "$LIB")/../../examples/scale-out"
mkdir 'a folder' && cd 'a folder' || exit 1
small_machine
awk 'BEGIN { for (i = 0; i < 5000; i++) printf "G0 X%d Z%d\n", i % 203, -(7 * i % 103) }' >'long one.nc'
for i in 1 2 3 4; do echo "G0 X${i}0" >p$i.nc; done
ls p?.nc >list
setup setup.xml </dev/null
export FIVECHECK
fivecheck -q -a -f ndjson=whole.json m.xml 'long one.nc' 2>/dev/null
fivecheck -q -f ndjson=list.json --files-from list m.xml 2>/dev/null
same() { # A B: the same but for how numbers are written
	jq -c . "$1" >a.lines
	jq -c . "$2" >b.lines
	cmp a.lines b.lines
}
if command -v parallel >/dev/null && parallel --version 2>/dev/null | grep -q '^GNU parallel'; then
	export HOME="$PWD" PARALLEL_OPTIONS="-j 2"
	mkdir .parallel && : >.parallel/will-cite
	"$scale_out/with-parallel" 3 out -a m.xml 'long one.nc' 2>/dev/null
	[ $? -eq 1 ] && same out/all.json whole.json || echo "parallel: one program"
	"$scale_out/with-parallel" 3 out --files-from list m.xml 2>/dev/null
	[ $? -eq 0 ] && same out/all.json list.json || echo "parallel: a list"
	[ "$(ls out)" = "$(printf '1.json\n2.json\n3.json\nall.json')" ] || ls out
	FIVECHECK=/nowhere "$scale_out/with-parallel" 3 out --files-from list m.xml 2>/dev/null
	[ $? -eq 2 ] || echo "parallel: what did not run passes"
else
	leave_out "there is no GNU parallel"
fi
# The command of the Kubernetes job as its shell receives it.
mkdir results
fivecheck() {
	"$FIVECHECK" "$@"
}
command=$(sed -n 's/^ *- \(fivecheck -.*\)/\1/p' "$scale_out/kubernetes.yml")
mv m.xml machine.xml
fivecheck -q -f ndjson=list.json --files-from list -s setup.xml machine.xml 2>/dev/null
for JOB_COMPLETION_INDEX in 0 1 2 3 4 5 6 7; do
	export JOB_COMPLETION_INDEX
	SHARDS=8
	eval "$command" 2>/dev/null || echo "kubernetes: status $?"
done
"$FIVECHECK" merge results/*.json >all.json || echo "kubernetes: merge"
same all.json list.json
