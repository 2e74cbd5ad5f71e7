# Tools of makers' catalogues: XML and tables of DIN 4000, products of ISO 13399. An independent script compares sizes.
need python3
truth() { # FILE SETUP
	python3 "$(dirname "$LIB")/../import/catalog_truth.py" "$1" "$2"
}
codes() { # CODE=VALUE...
	for pair; do
		printf '<Property-Data><PropertyName source="din_mk">%s</PropertyName><Value>%s</Value></Property-Data>\n' \
			"${pair%%=*}" "${pair#*=}"
	done
}
catalog() { # CLASS PICTURE CODE=VALUE...
	printf '\357\273\277<?xml version="1.0"?>\n<!DOCTYPE Tool-Data SYSTEM "https://example.org/din4000.dtd">\n<Tool-Data><Tool>\n'
	printf '<Category><Category-Data><PropertyName source="din_mk">NSM</PropertyName><Value>%s</Value></Category-Data></Category>\n' "$1"
	shift
	printf '<Properties>\n'
	codes "BLD=$@"
	printf '</Properties></Tool></Tool-Data>\n'
}
one() { # NAME - imports NAME and compares
	fivecheck import --number-tools --output "out-$1" "$1" 2>&1 | sed 's/.*: warning: //' | grep -v note:
	truth "$1" "out-$1/setup.xml"
}
echo "a mill with a neck, a torus, a ball, a chamfered corner, a drill:"
catalog DIN4000-82 2 J23=neck J23=Hals A1=12 A5=11 B2=26 B9=36,13 B3=38 B5=83 C3=12 C4=46 G1=0,8 >neck.xml
one neck.xml
cat out-neck.xml/setup.xml
catalog DIN4000-82 02 A1=10 A5=9,2 B3=36 B6=11 B5=73 C3=10 C4=39,9 G1=3,5 >torus.xml
one torus.xml
catalog 'DIN 4000-82' 6 A1=3 B2=3,5 B3=23 B5=50 C3=4 C4=27 G4=1,5 | sed 's/DIN 4/DIN4/' >ball.xml
one ball.xml
catalog DIN4000-82 1 A1=5.0 B2=10 B5=58 C3=6 C4=36 G2=0.15 G3=45 >chamfer.xml
one chamfer.xml
catalog DIN4000-81 1 A11=10 B4=31,3 B6=46,3 B5=89 C3=10 C4=40,5 E1=140 G5=0 >drill.xml
one drill.xml
echo "the same as a table, with a tool of another class:"
cat >table.csv <<'EOF'
J21;J3;NSM;BLD;A1;B2;B3;B5;C3;C4;F21;J8;
6767;KH;DIN4000-82;2;1.588;3.175;10.188;38.1;3.175;27.912;4;"FZI,FSE";
6768;KH;DIN4000-80;2;M;12;22;45;4.5;36;3;"";
EOF
one table.csv
echo "products of ISO 13399, with symbols and with names, in mm and in inches:"
product() { # KIND VALUE-LINES...
	printf "ISO-10303-21;\nHEADER;\nFILE_NAME /* a ; comment */ ('it''s; (one', '');\nFILE_SCHEMA (('CUTTING_TOOL_SCHEMA_ARM'));\nENDSEC;\nDATA;\n"
	printf "#1 = STRING_WITH_LANGUAGE ('MILL (1)', #9);\n#2=MULTI_LANGUAGE_STRING((),#1);\n#3 = ITEM (\$, '4711', #2);\n"
	printf "#4 = SPECIFIC_ITEM_CLASSIFICATION ((#3), '%s', \$);\n#5 = UNIT ('mm');\n#6 = UNIT ('deg');\n#7 = UNIT('in');\n" "$1"
	shift
	number=10
	for line; do
		printf '#%d = NUMERICAL_VALUE (%s);\n' $((number += 1)) "$line"
	done
	printf 'ENDSEC;\nEND-ISO-10303-21;\n'
}
mill="'DC', \$, #5, '6'|'OAL', \$, #5, '57'|'APMX', \$, #5, '13'|'DCONMS', \$, #5, '6'|'LS', \$, #5, '36'|'FHA', \$, #6, '30'|'ZEFF', \$, \$, '4'"
ball="'cutting diameter',\$,#5,'1'|'overall length',\$,#5,'75'|'depth of cut maximum',\$,#5,'2'|'corner radius',\$,#5,'0.5'|'neck diameter',\$,#5,'0.96'|'usable length',\$,#5,'4'|'connection diameter machine side',\$,#5,'6'"
drill="'DC', \$, #7, '0.25'|'OAL', \$, #7, '3'|'LCF', \$, #7, '1.5'|'DMM', \$, #7, '0.375'|'SIG', \$, #6, '140'"
split() { # KIND VALUES
	kind=$1
	IFS='|'
	set -- $2
	unset IFS
	product "$kind" "$@"
}
split 'tool item' "$mill" >mill.p21
one mill.p21
split 'tool item' "$ball" >ball.p21
one ball.p21
split 'tool item' "$drill" | sed "s/'DMM'/'DCONMS'/" >drill.p21
one drill.p21
sed -n '/<tool /p' out-mill.p21/setup.xml
echo "a neck that is said to reach into the shank ends where the shank begins:"
catalog DIN4000-82 1 A1=12 A5=11 B2=26 B9=60 B5=83 C3=12 C4=45 >into.xml
fivecheck import --number-tools --output out-into into.xml 2>/dev/null
sed -n '/<shank/,/shank>/p' out-into/setup.xml
echo "left out:"
left() { # reads a file
	cat >bad.x
	"$FIVECHECK" import --number-tools --output bad bad.x 2>&1 | grep -v 'no tool of the library'
	[ ! -e bad ] || { echo "a folder was written"; rm -r bad; }
}
catalog DIN4000-82 10 A1=12 B2=20 B5=80 C3=12 | left
catalog DIN4000-82 1 A1=12 B2=20 B5=80 | left
catalog DIN4000-82 1 A1=12 B5=80 C3=12 | left
catalog DIN4000-82 1 A1=-12 B2=20 B5=80 C3=12 | left
catalog DIN4000-82 1 A1=1e999 B2=20 B5=80 C3=12 | left
catalog DIN4000-82 1 A1=12 A1=13 B2=20 B5=80 C3=12 | left
catalog DIN4000-82 1 A1=12 B2=90 B5=80 C3=12 | left
catalog DIN4000-82 1 A1=12 B2=20 B5=80 C3=12 G1=7 | left
catalog DIN4000-82 1 A1=12 B2=20 B5=80 C3=12 G1=1 G2=1 G3=45 | left
catalog DIN4000-82 1 A1=12 B2=20 B5=80 C3=12 G2=1 | left
catalog DIN4000-82 1 A1=12 B2=20 B5=80 C3=12 G6=80 | left
catalog DIN4000-82 6 A1=12 B2=20 B5=80 C3=12 G4=5 | left
catalog DIN4000-81 1 A11=12 B6=20 B5=80 C3=12 | left
catalog DIN4000-82 1 A1=12 A5=11 B2=26 B9=90 B5=83 C3=12 | left
split 'adaptive item' "$mill" | left
split 'cutting item' "$mill" | left
# Strings may go on over several lines; a message has one.
split 'cutting item' "$mill" | sed 's/MILL (1)/MILL\n(1)/; s/cutting item/assembly\nitem/' | left
split 'tool item' "$mill|'thread pitch', \$, #5, '1'" | left
split 'tool item' "$mill|'KAPR', \$, #6, '45'" | left
split 'tool item' "$mill|'DCX', \$, #5, '8'" | left
split 'tool item' "$mill|'BD', \$, #5, '20'" | left
split 'tool item' "$mill|'CICT', \$, \$, '3'" | left
split 'tool item' "$mill|'RE', \$, #5, 'nan'" | left
split 'tool item' "$mill|'RE', \$, \$, '1'" | left
split 'tool item' "$mill|'RE', \$, #6, '1'" | left
split 'tool item' "$mill|'PSIR', \$, #5, '0'" | left
split 'tool item' "$mill|'DC', \$, #5, '7'" | left
split 'tool item' "$mill" | sed 's/^#3 .*/&&/' | left
echo "faults:"
catalog DIN4000-82 1 A1=12 B2=20 B5=80 C3=12 | sed 's/SYSTEM.*dtd"/[<!ENTITY a "12">]/' | left
catalog DIN4000-82 1 A1='1&a;2' B2=20 B5=80 C3=12 | left
printf '<Tool-Data/>' | left
split 'tool item' "$mill" | head -c 300 | left
split 'tool item' "$mill" | sed 's/^#5 =/#5 -/' | left
split 'tool item' "$mill" | sed 's/^\(#5 .*\);/\1/' | left
fivecheck import --output bad neck.xml
small_machine
echo '<setup version="1" units="mm"><tools href="mill.p21"/></setup>' >s.xml
printf 'M2\n' | status "$FIVECHECK" -s s.xml m.xml - 2>&1 | grep error
