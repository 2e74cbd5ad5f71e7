# Editors jump to findings: vim's errorformat, and the regular expression of the problem matcher of VS Code.
need vim
need python3
editors="$(dirname "$LIB")/../../examples/editors"
small_machine
printf 'G0 X10\nG1 Z-120 F6000\nG0 B1\n' >'a b.nc'
cat >try.vim <<VIM
let g:fivecheck = '$FIVECHECK -q -a m.xml'
edit a\\ b.nc
source $editors/fivecheck.vim
silent make
redir! > jumps
for item in getqflist()
	echo bufname(item.bufnr) . '|' . item.lnum . '|' . item.col . '|' . item.type . '|' . item.text
endfor
redir END
qall!
VIM
vim -u NONE -N -es -S try.vim </dev/null >/dev/null 2>&1
grep -v '^$' jumps
fivecheck -q -a m.xml 'a b.nc' >out 2>&1
python3 - "$editors/tasks.json" out <<'PY'
import json, re, sys
pattern = json.load(open(sys.argv[1]))['tasks'][0]['problemMatcher']['pattern']
for line in open(sys.argv[2]):
    found = re.match(pattern['regexp'], line.rstrip('\n'))
    if found:
        print(*(found.group(pattern[key]) for key in ('file', 'line', 'column', 'severity', 'message')), sep='|')
PY
