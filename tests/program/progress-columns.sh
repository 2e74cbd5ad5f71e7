# The progress line fits into the columns of the terminal; a terminal without control sequences gets none.
need python3
python3 -c 'import pty; pty.openpty()' 2>/dev/null || skip "there is no pseudo-terminal"
small_machine
printf 'o1 while [1]\nG1 F100 X0\no1 endwhile\n' >endless-program-with-a-long-name.nc
cat >terminal.py <<'PY'
import fcntl, os, pty, signal, struct, sys, termios
columns, term, *words = sys.argv[1:]
child, terminal = pty.fork()
if not child:
    os.environ["TERM"] = term
    os.read(0, 1)
    os.execv(words[0], words)
fcntl.ioctl(terminal, termios.TIOCSWINSZ, struct.pack("HHHH", 24, int(columns), 0, 0))
os.write(terminal, b"\n")
said = b""
while True:
    try:
        piece = os.read(terminal, 4096)
    except OSError:
        break
    if not piece:
        break
    said += piece
    if said.count(b"\033[K") > 1:
        os.kill(child, signal.SIGTERM)
        break
os.waitpid(child, 0)
lines = [l for l in said.decode().split("\r") if l.endswith("\033[K")]
print(columns, term, "renewed" if lines else "not renewed")
if lines:
    print("widest fits:", max(len(l) - 3 for l in lines) < int(columns))
    print("tells the line:", all("line " in l for l in lines), "bar:", lines[0].startswith("["))
    print("name:", lines[0].split("] ")[-1].split(":")[0])
PY
watch() {
	python3 terminal.py "$1" "$2" "$FIVECHECK" --parse-only --max-blocks "$3" m.xml \
		endless-program-with-a-long-name.nc
}
watch 100 xterm 100000000
watch 40 xterm 100000000
watch 24 xterm 100000000
watch 100 dumb 1000000
