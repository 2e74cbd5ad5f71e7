# --color: by default only on a terminal; always and never override NO_COLOR.
small_machine
printf 'G0 X10\nG1 Z-120 F6000\n' >a.nc
escapes() {
	grep -c "$(printf '\033')"
}
fivecheck -q m.xml a.nc | escapes
fivecheck -q --color=always m.xml a.nc | escapes
NO_COLOR=1 fivecheck -q --color=always m.xml nowhere.nc 2>&1 | escapes
fivecheck -q --color=never m.xml a.nc | escapes
fivecheck --color=red m.xml a.nc 2>&1 | head -n 1
