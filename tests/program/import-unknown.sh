# Files that cannot be imported: each is told what to do instead.
told() { # NAME - standard input is the file
	cat >"$1"
	status "$FIVECHECK" import --output out "$1" 2>&1 | sed 's/: error: /:\n  /'
	[ ! -e out ] || echo "a folder was written"
}
printf 'any text of an old machine\n' | told old.mch
printf 'any text\nVersion: 6.2.1\n' | told versed.tls
printf 'any text\n' | told JOB.VCPROJECT
printf '\377\376<\000V\000' | told wide.mch
printf 'ISO-10303-21;\n' | told arm.STEP
printf 'PK\003\004zip' | told library.tools
printf '\000\001\002' | told bytes.bin
printf '' | told empty.mch
printf '<VcMachineX/>' | told other.mch
