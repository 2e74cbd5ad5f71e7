# Every usage error is named, ends with status 2, and prints nothing on standard output.
bad() {
	echo "\$ $*"
	"$FIVECHECK" "$@" 2>message >result
	result=$?
	grep -v "lists the options" message
	if [ -s result ]; then
		echo "printed on standard output"
	fi
	[ $result = 2 ] || echo "status $result"
}
bad
bad m.xml
bad --parse-only m.xml
bad --nonsense m.xml a.nc
bad -x m.xml a.nc
bad --d m.xml a.nc
bad --tolerence=1 m.xml a.nc
bad --prase-only m.xml a.nc
bad m.xml a.nc --tolerance
bad m.xml a.nc -s
bad m.xml a.nc --all=yes
bad m.xml a.nc --setup ''
bad m.xml a.nc --tolerance 0
bad m.xml a.nc --tolerance -1
bad m.xml a.nc --tolerance 1mm
bad m.xml a.nc --tolerance ''
bad m.xml a.nc --tolerance ' 1'
bad m.xml a.nc --tolerance 0x1
bad m.xml a.nc --tolerance inf
bad m.xml a.nc --tolerance nan
bad m.xml a.nc --tolerance 1e999
bad m.xml a.nc --clearance -0.1
bad m.xml a.nc --step 0 --method conventional
bad m.xml a.nc -j 0
bad m.xml a.nc -j 1.5
bad m.xml a.nc -j -1
bad m.xml a.nc -j 99999999999999999999
bad m.xml a.nc --method fast
bad m.xml a.nc --method cert
bad m.xml a.nc -f xml
bad m.xml a.nc --duplicates first
bad m.xml a.nc --dialect siemens
bad m.xml a.nc --step 0.1
bad m.xml a.nc -q -v
bad m.xml a.nc -v --method interpolated
bad m.xml a.nc -v -f ndjson
bad m.xml a.nc --pose -
bad m.xml a.nc --dump-path --parse-only
bad m.xml --list-pairs --check-machine
bad m.xml a.nc --list-pairs
bad m.xml a.nc --check-machine
bad m.xml a.nc b.nc --dump-path
bad m.xml a.nc --parse-only --clearance 1
bad m.xml a.nc --parse-only --method certified
bad m.xml a.nc --parse-only --pose p.stl
bad m.xml a.nc --dump-path -f ndjson
bad m.xml a.nc --dump-path -a
bad m.xml --list-pairs --tolerance 1
bad m.xml --check-machine --clearance 1
bad m.xml - -
bad - a.nc
bad m.xml a.nc -s -
bad m.xml a.nc -f text -f ndjson
bad m.xml a.nc -f text=a -f text=b
bad m.xml a.nc -f sarif=
bad m.xml a.nc -f sarif=a -o b
bad m.xml a.nc -f sarif=a -f junit=a
bad m.xml a.nc -f sarif=a.nc
bad m.xml a.nc --depfile d
bad m.xml a.nc -o a --depfile -
bad m.xml --list-pairs --depfile d
: >empty
printf 'a.nc\0' >zero
printf '%s\n' - - >twice
bad m.xml --files-from empty
bad m.xml --files-from zero
bad m.xml --files-from twice
bad m.xml --files-from nowhere
bad m.xml --files-from - -
bad m.xml a.nc --shard 0/3
bad m.xml a.nc --shard 4/3
bad m.xml a.nc --shard 1
bad m.xml a.nc --shard 1/2x
bad m.xml a.nc --shard 1/1000001
bad m.xml a.nc -q --progress=plain
bad m.xml a.nc --fail-on collision,
bad m.xml a.nc --fail-on crash
bad m.xml a.nc --fail-on collision --fail-on limit
bad m.xml a.nc -s vise.xml --setup=tools.xml
bad m.xml --files-from twice --files-from zero
bad m.xml a.nc --shard 1/2 --shard 2/2
bad m.xml --list-pairs --stats
bad m.xml a.nc --record -
bad m.xml - --record r.json
bad m.xml a.nc --record a.nc
bad -o /dev/null part.nc m.xml

# A misspelled command is not taken as a machine file.
for word in m.xml inti scna; do
	"$FIVECHECK" $word a.nc 2>&1 | grep 'did you mean'
done
