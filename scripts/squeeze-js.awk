# squeeze-js.awk - removes comments and needless blanks from JavaScript. Strings and regular expressions stay unchanged;
# templates lose only the indentation of their lines. A line break stays if a statement may end there.
#
# Not supported: a regular expression after `)` or `}`, or with an unescaped / in brackets.

{ text = text $0 "\n" }

function word(c) { return c ~ /[A-Za-z0-9_$]/ }

# Adds the pending blanks, then a piece of code.
function put(piece,    first) {
	first = substr(piece, 1, 1)
	if (blank == "\n" && last != "" && !index("{;,([=*&|?:<>!~^%", last) && !index(")],.?:&|=*<>^%;", first) && first != "}")
		printf "\n"
	else if (blank != "" && ((word(last) && word(first)) || (index("+-/", last) && last == first)))
		printf " "
	blank = ""
	printf "%s", piece
	last = substr(piece, length(piece))
}

# The end of the quoted text that begins at i.
function after_quotes(i,    quote) {
	quote = substr(text, i, 1)
	for (i++; substr(text, i, 1) != quote; i++)
		if (substr(text, i, 1) == "\\")
			i++
	return i + 1
}

# Copies a template from i on, up to its end or to the next ${; returns the position after it.
function template(i,    c) {
	for (;; i++) {
		c = substr(text, i, 1)
		if (c == "\\") {
			printf "%s", substr(text, i, 2)
			i++
		} else if (c == "\n") {
			printf "\n"
			while (substr(text, i + 1, 1) == "\t")
				i++
		} else if (c == "`") {
			printf "`"
			last = "`"
			return i + 1
		} else if (c == "$" && substr(text, i + 1, 1) == "{") {
			printf "${"
			last = "{"
			inside[++depth] = 0
			return i + 2
		} else {
			printf "%s", c
		}
	}
}

END {
	count = length(text)
	for (i = 1; i <= count;) {
		c = substr(text, i, 1)
		two = substr(text, i, 2)
		if (two == "//") {
			i += index(substr(text, i), "\n") - 1
		} else if (two == "/*") {
			i += index(substr(text, i), "*/") + 1
			if (blank == "")
				blank = " "
		} else if (c ~ /[ \t]/) {
			if (blank == "")
				blank = " "
			i++
		} else if (c == "\n") {
			blank = "\n"
			i++
		} else if (c == "'" || c == "\"" || (c == "/" && (last == "" || index("{;,([=&|?:!", last)))) {
			end = after_quotes(i)
			put(substr(text, i, end - i))
			i = end
		} else if (c == "`") {
			put("`")
			i = template(i + 1)
		} else {
			put(c)
			i++
			if (depth && c == "{")
				inside[depth]++
			if (depth && c == "}" && inside[depth]-- == 0) {
				depth--
				i = template(i)
			}
		}
	}
	printf "\n"
}
