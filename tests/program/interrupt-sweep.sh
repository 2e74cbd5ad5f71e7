# SIGINT in the middle of one long proof: a ball turns in a bowl, hundredths of a mm away, which takes minutes.
need python3
cat >start.py <<'PY'
import os, signal, sys
signal.signal(signal.SIGINT, signal.SIG_DFL)
os.execv(sys.argv[1], sys.argv[1:])
PY
sphere ball 99.95 80
sphere bowl 100 80
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
	# Opened only once everything is loaded.
	printf 'G1 A30 C360 F1000\n' >a.nc
	sleep 0.5
	kill -INT $checker
	wait $checker
	echo "status $?"
done
