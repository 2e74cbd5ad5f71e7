# Text around the blocks of a posted program: names, text before the first '%', ends of tapes and files.
small_machine
sed -i 's|<base>|<controller dialect="fanuc" least_input="0.001"/><base>|' m.xml

# read TEXT - one line per control: the result of a program with this text
read_as() {
	printf '%b' "$1" >p.nc
	for dialect in fanuc haas; do
		printf '%s: ' "$dialect"
		fivecheck --dialect="$dialect" --parse-only $2 m.xml p.nc 2>&1 | grep -E '(error|warning|limits|finding):|within' |
			head -n "${3:-1}"
	done
}

body='G21 G90 G17\nG0 X1.\n'
read_as "%\n<PART-1>(TITLE)\n${body}M30\n%\n"
read_as "%\n<PART-1> X2.\n${body}M30\n%\n"
read_as "%\nO1\n<PART-2>\n${body}M30\n%\n"
read_as "%\nO ENTER OP AND LAST 3 DIGITS\n${body}M30\n%\n"
read_as "%\nO X500.\n${body}M30\n%\n"
read_as "%\nOCIRCLE(TITLE)\n${body}M30\n%\n"
read_as "%\nOX500.\n${body}M30\n%\n"
read_as "=====\nListing by: lili (draft\nDate: 10/25/2006 5:12:18 PM D:\\\\part.prt\n%\nO1\n${body}M30\n%\nend of listing\n"
# A single '%' may be the end of the program: nothing is skipped.
read_as "${body}M30\n%\n"
read_as "(header)\n${body}%\n${body}M30\n"
# Bytes of tapes and of CP/M.
read_as "\0\0\0\0%\nO1\n${body}M30\n%\n"
read_as "%\nO1\n${body}\0X5.\nM30\n%\n"
read_as "O1\n${body}\032"
read_as "O1\n${body}X2.\032X3.\n"
# DC1 to DC4 of a reader or punch; LF CR CR of Fanuc's punch code; a transfer that made CR CR LF of CR LF.
read_as "\021%\nO1\n${body}M30\n%\024"
read_as "%\n\r\rO1\n\r\rG21 G90 G17\n\r\rG0 X1.\n\r\rX1.\n\r\rX500.\n\r\rM30\n\r\r%\n\r\r"
read_as "%\r\r\nO1\r\r\nG21 G90 G17\r\r\nG0 X1.\r\r\nX1.\r\r\nX500.\r\r\nM30\r\r\n%\r\r\n"
read_as "%\nO1\nG21 G90\rG0 X1.\nM30\n%\n"
read_as "%\rO1\r\rG21 G90\rG0 X1.\rM30\r%\r"
read_as "%\r\n\r\no1\r\ng21 g90\r\n\tg0 x 1 . 5\r\nn123456789012345678 m30\r\n%\r\n"
# X500 is beyond the limit: skipped blocks do not count.
slashes="O1\n${body}/X500.\n/2 X500.\n/1/3 X500.\nN10 /X500.\nM30\n"
read_as "$slashes" --block-delete
read_as "$slashes" -a 9
# Text after ';' is accepted if it has no word.
read_as "O1\n${body}G0 X2.; to the left, then back\nM30;\n"
read_as "O1\n${body}G0 X2.; then X500.\nM30;\n"
read_as "O1\n${body}G0 X2.; then; #1=5\nM30;\n"
# A comment inside a comment, if no interpretation of it leaves a word.
read_as "O1 (TITLE (DRAFT) )\n(#508= (MILL_.25 ))\n${body}M30\n"
read_as "O1\n${body}G0 (TO (LEFT) X500.)\nM30\n"
