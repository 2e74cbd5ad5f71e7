# SIGINT in the middle of one long proof: a ball turns in a bowl, hundredths of a mm away, which takes minutes.
need python3
cat >start.py <<'PY'
import os, signal, sys
signal.signal(signal.SIGINT, signal.SIG_DFL)
os.execv(sys.argv[1], sys.argv[1:])
PY
# ticks PID - the processor time used by the process, in ticks of the system
ticks() {
	sed 's/.*) //' "/proc/$1/stat" | awk '{ print $12 + $13 }'
}
[ -e /proc/self/stat ] || skip "there is no /proc"
sphere ball 99.95 80
sphere hollow 100 80
sphere bowl 120 8
# A bowl is a ball with a hollow of the same triangles, facing the other way.
awk '/^vertex/ { v[n++] = $0; if (n == 3) { print v[0]; print v[2]; print v[1]; n = 0 }; next } !/solid/' hollow.stl >inside
{
	grep -v '^endsolid' bowl.stl
	cat inside
	echo 'endsolid bowl'
} >both && mv both bowl.stl
machine m.xml <<'XML'
  <axis name="A" type="rotary" direction="1 0 0" location="0 0 0" rate_max="3600">
    <axis name="C" type="rotary" direction="0 0 1" location="0 0 0" rate_max="3600">
      <body name="ball" mesh="ball.stl"/>
    </axis>
  </axis>
  <body name="bowl" mesh="bowl.stl"/>
--
  <pairs><pair a="ball" b="bowl" check="always"/></pairs>
XML
mkfifo a.nc
for threads in 1 2; do
	python3 start.py "$FIVECHECK" -q -j $threads m.xml a.nc 2>&1 &
	checker=$!
	# The program is opened only after everything is loaded.
	printf 'G1 A30 C360 F1000\n' >a.nc
	began=$(ticks $checker)
	# Reading one line takes almost no time: all other time is the proof.
	until [ $(($(ticks $checker) - began)) -ge 20 ]; do
		:
	done
	kill -INT $checker
	wait $checker
	echo "status $?"
done
