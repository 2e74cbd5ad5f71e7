# Files that cannot be imported: each message says what to do instead.
told() { # NAME - standard input is the file
	cat >"$1"
	status "$FIVECHECK" import --output out "$1" 2>&1 | sed 's/: error: /:\n  /'
	[ ! -e out ] || echo "a folder was written"
}
printf 'any text of an old machine\n' | told old.mch
printf 'any text\nVersion: 6.2.1\n' | told versed.tls
printf 'any text\n' | told JOB.VCPROJECT
printf '\357\273\277* a comment\r\nUNITS\tMM\r\nNAME "Tisch \344"\r\n\f\032' | told windows.usr
printf '{"machine": 1}' | told autodesk.mch
printf 'text\001\002' | told binary.mch
printf '\377\376<\000V\000' | told wide.mch
printf 'ISO-10303-21;\n' | told arm.STEP
printf 'PK\003\004zip' | told library.tools
printf '\000\001\002' | told bytes.bin
printf '\377\376<\000?\000' | told library.hsmlib
printf '"Type (tool_type)","Number (tool_number)"\n"flat end mill",3\n' | told library.csv
printf '' | told empty.mch
printf '<VcMachineX/>' | told other.mch
printf '<machine version="1"/>' | told m.xml
printf 'solid head\n' | told head.STL
printf '\037\213\010' | told DMU50.mch.gz
echo "a text form that another file names:"
printf 'any text\n' >old.mch
printf 'VERSION 5.4\n' >old.tls
cat >job.VcProject <<'EOF'
<VcProject Version="7.0" Unit="millimeter"><Setup><Machine><File>old.mch</File></Machine></Setup></VcProject>
EOF
cat >setup.xml <<'EOF'
<setup version="1" units="mm"><tools href="old.tls"/></setup>
EOF
small_machine
status "$FIVECHECK" import --output out job.VcProject 2>&1 | sed 's/: error: /:\n  /'
printf 'M2\n' | status "$FIVECHECK" -s setup.xml m.xml - 2>&1 | sed 's/: error: /:\n  /'
