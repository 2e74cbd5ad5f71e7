# On a terminal init asks, repeats a question after an invalid answer, and writes the same file as with options.
need python3
python3 -c 'import pty; pty.openpty()' 2>/dev/null || skip "there is no pseudo-terminal"
cat >terminal.py <<'PY'
import os, pty, select, sys
answers = sys.argv[1].split("/")
child, terminal = pty.fork()
if not child:
    os.execv(sys.argv[2], sys.argv[2:])
# Each answer is given when it is asked for: a question ends in "): ".
said = b""
while True:
    try:
        piece = os.read(terminal, 4096)
    except OSError:
        break
    if not piece:
        break
    said += piece
    if said.endswith(b"): "):
        os.write(terminal, (answers.pop(0) + "\n").encode() if answers else b"\x04")
sys.stdout.write(said.decode().replace("\r", ""))
sys.exit(os.waitstatus_to_exitcode(os.waitpid(child, 0)[1]))
PY
ask() {
	python3 terminal.py "$@"
	echo "status $?"
}
ask 'table-table/A,C/none/-300:300/-250:250/oops/400:100/100:400/100/-120:30/0,0,120/none/0 0 120/0,0,520/' "$FIVECHECK" init
fivecheck init table-table --rotary A,C --limits X=-300:300,Y=-250:250,Z=100:400,A=-120:30,C=none --home Z=100 \
	--location A=0,0,120 --location C=0,0,120 --spindle 0,0,520 2>/dev/null | cmp - machine.xml
echo "where the oblique axis of a nutating table points:"
ask 'nutating-table/B,C/none/none/none/none/none/0,0,100/none/0,0,100/0,-1,-2/0,0,500/' "$FIVECHECK" init --output oblique.xml |
	grep -A 1 'oblique axis'
grep 'name="B"' oblique.xml
echo "only what is missing:"
ask 0,0,500/fanuc "$FIVECHECK" init head-head --rotary C,B --table X --limits X=none,Y=none,Z=none,C=none,B=none \
	--location C=0,0,0 --location B=0,0,0 --output other.xml
grep -c 'rapid="any"' other.xml
echo "no answer:"
ask head-head "$FIVECHECK" init --output third.xml
ls
