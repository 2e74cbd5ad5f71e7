#include "gcode/dialect/family_signs.h"

#include <stdlib.h>
#include <string.h>

#include "base/ascii.h"
#include "gcode/text/line_shape.h"

static const struct family klartext = {"Heidenhain Klartext", {"klartext", NULL}};
static const struct family sinumerik = {"a program for Siemens Sinumerik", {"sinumerik", NULL}};
static const struct family linuxcnc = {"a program for LinuxCNC", {"linuxcnc", NULL}};
static const struct family haas = {"a program for Haas", {"haas", NULL}};
static const struct family fanuc = {"a program for Fanuc", {"fanuc", NULL}};
static const struct family okuma = {"a program for Okuma OSP, which no dialect reads", {NULL}};
static const struct family iso = {"a program for Fanuc or Haas", {"fanuc", "haas", NULL}};

/*
 * Heidenhain iTNC 530 manual, Klartext programming; Siemens 840D sl programming manual, "Fundamentals", "Job planning";
 * LinuxCNC's manual, "O Codes"; Haas mill operator's manual, G-codes; Okuma OSP programming manual, program file names,
 * CALL, and "User task": VC1 to VC200 are common variables.
 */
const struct sign family_signs[] = {
	{&klartext, "BEGINPGM", "BEGIN PGM", MATCH_START, true},
	{&klartext, "BLKFORM", "BLK FORM", MATCH_START, true},
	{&klartext, "TOOLCALL", "TOOL CALL", MATCH_START, true},
	{&klartext, "CYCLDEF", "CYCL DEF", MATCH_START, true},
	{&klartext, "CYCLCALL", "CYCL CALL", MATCH_START, true},
	{&klartext, "CALLLBL", "CALL LBL", MATCH_START, true},
	{&klartext, "FMAX", "L ... FMAX", MATCH_STRAIGHT_LINE, true},
	{&sinumerik, "%_N_", "%_N_", MATCH_START, true},
	{&sinumerik, ";$PATH", ";$PATH", MATCH_START, true},
	{&sinumerik, "TRAORI", "TRAORI", MATCH_ALL, true},
	{&sinumerik, "TRAFOOF", "TRAFOOF", MATCH_ALL, true},
	{&sinumerik, "CYCLE6", "CYCLE6..", MATCH_START, true},
	{&sinumerik, "CYCLE7", "CYCLE7..", MATCH_START, true},
	{&sinumerik, "CYCLE8", "CYCLE8..", MATCH_START, true},
	{&sinumerik, "CYCLE9", "CYCLE9..", MATCH_START, true},
	{&sinumerik, "POCKET3(", "POCKET3()", MATCH_CALL, true},
	{&sinumerik, "POCKET4(", "POCKET4()", MATCH_CALL, true},
	{&sinumerik, "HOLES1(", "HOLES1()", MATCH_CALL, true},
	{&sinumerik, "HOLES2(", "HOLES2()", MATCH_CALL, true},
	{&sinumerik, "MCALL", "MCALL", MATCH_START, true},
	{&sinumerik, "DEFREAL", "DEF REAL", MATCH_START, true},
	{&sinumerik, "DEFINT", "DEF INT", MATCH_START, true},
	{&sinumerik, "DEFBOOL", "DEF BOOL", MATCH_START, true},
	{&sinumerik, "DEFCHAR", "DEF CHAR", MATCH_START, true},
	{&sinumerik, "DEFSTRING", "DEF STRING", MATCH_START, true},
	{&sinumerik, "DEFAXIS", "DEF AXIS", MATCH_START, true},
	{&sinumerik, "DEFFRAME", "DEF FRAME", MATCH_START, true},
	{&sinumerik, "FFWON", "FFWON", MATCH_ALL, true},
	{&sinumerik, "FFWOF", "FFWOF", MATCH_ALL, true},
	{&sinumerik, "SOFT", "SOFT", MATCH_ALL, true},
	{&sinumerik, "BRISK", "BRISK", MATCH_ALL, true},
	{&sinumerik, "ORIWKS", "ORIWKS", MATCH_ALL, true},
	{&sinumerik, "ORIMKS", "ORIMKS", MATCH_ALL, true},
	{&sinumerik, "COMPCAD", "COMPCAD", MATCH_ALL, true},
	{&sinumerik, "COMPOF", "COMPOF", MATCH_ALL, true},
	{&sinumerik, "", "TRANS, ROT, SCALE or MIRROR", MATCH_FRAME, true},
	{&sinumerik, "SUPA", "SUPA", MATCH_ADDRESS, true},
	{&sinumerik, "", "PROC", MATCH_PROC, true},
	{&sinumerik, "MSG(", "MSG()", MATCH_CALL, true},
	{&sinumerik, "EXTCALL(", "EXTCALL()", MATCH_CALL, true},
	{&sinumerik, "EXTCALL\"", "EXTCALL", MATCH_START, true},
	{&sinumerik, "WORKPIECE(,", "WORKPIECE()", MATCH_CALL, true},
	{&sinumerik, "STOPRE", "STOPRE", MATCH_ALL, true},
	{&sinumerik, "GOTOF", "GOTOF", MATCH_ADDRESS, true},
	{&sinumerik, "GOTOB", "GOTOB", MATCH_ADDRESS, true},
	{&sinumerik, "T=\"", "T=\"NAME\"", MATCH_ADDRESS, true},
	{&sinumerik, "=IC(", "=IC()", MATCH_FIRST_CALL, true},
	{&sinumerik, "=AC(", "=AC()", MATCH_FIRST_CALL, true},
	{&sinumerik, "=DC(", "=DC()", MATCH_FIRST_CALL, true},
	{&sinumerik, "CR=", "CR=", MATCH_ADDRESS, true},
	{&sinumerik, "TURN=", "TURN=", MATCH_ADDRESS, true},
	{&sinumerik, "$P_", "$P_", MATCH_ANYWHERE, true},
	{&sinumerik, "$AA_", "$AA_", MATCH_ANYWHERE, true},
	{&sinumerik, "$TC_", "$TC_", MATCH_ANYWHERE, true},
	{&sinumerik, "", "R parameters", MATCH_R_PARAMETER, true},
	{&sinumerik, "RND=", "RND=", MATCH_ADDRESS, true},
	{&sinumerik, "CHF=", "CHF=", MATCH_ADDRESS, true},
	{&sinumerik, "CHR=", "CHR=", MATCH_ADDRESS, true},
	{&sinumerik, "SPOS=", "SPOS=", MATCH_ADDRESS, true},
	{&sinumerik, "", "an address with '=', such as X=5", MATCH_ASSIGNED_ADDRESS, true},
	{&okuma, ".MIN%", "$NAME.MIN%", MATCH_ANYWHERE, true},
	{&okuma, "CALLO", "CALL O", MATCH_START, true},
	{&okuma, "", "VC1, a common variable", MATCH_OKUMA_VARIABLE, false},
	{&sinumerik, "", "G70 or G71 without further words", MATCH_UNITS, false},
	{&sinumerik, "G500", "G500", MATCH_G, false},
	{&sinumerik, "G505", "G505", MATCH_G, false},
	{&sinumerik, "G601", "G601", MATCH_G, false},
	{&sinumerik, "G641", "G641", MATCH_G, false},
	{&sinumerik, "G642", "G642", MATCH_G, false},
	{&sinumerik, "G645", "G645", MATCH_G, false},
	{&sinumerik, "G700", "G700", MATCH_G, false},
	{&sinumerik, "G710", "G710", MATCH_G, false},
	{&sinumerik, "", "T with D", MATCH_TOOL_EDGE, false},
	{&linuxcnc, "", "an O-word", MATCH_O_CALL, false},
	{&linuxcnc, "#<", "#<name>", MATCH_ANYWHERE, false},
	{&fanuc, "G5P10000", "G5 P10000", MATCH_G, false},
	{&fanuc, "G05P10000", "G5 P10000", MATCH_G, false},
	{&fanuc, "G5.1Q", "G5.1 Q", MATCH_ANYWHERE, false},
	{&fanuc, "G05.1Q", "G5.1 Q", MATCH_ANYWHERE, false},
	{&haas, "G154", "G154", MATCH_G, false},
	{&haas, "G187", "G187", MATCH_G, false},
	{&haas, "G234", "G234", MATCH_G, false},
	{&haas, "G254", "G254", MATCH_G, false},
	{&iso, "G68.2", "G68.2", MATCH_G, false},
	{&iso, "G53.1", "G53.1", MATCH_G, false},
	{&iso, "G54.1P", "G54.1 P", MATCH_ANYWHERE, false},
	{&iso, "G65P", "G65 P", MATCH_ANYWHERE, false},
	{&iso, "", "the program number O or :", MATCH_PROGRAM_NUMBER, false},
	{NULL, NULL, NULL, MATCH_START, false},
};

static bool starts_with(const char *block, const char *text)
{
	return !strncmp(block, text, strlen(text));
}

/* Has the block this code, without a further digit or point? */
static bool has_code(const char *block, const char *code)
{
	for (const char *at = strstr(block, code); at; at = strstr(at + 1, code)) {
		const char next = at[strlen(code)];

		if (!ascii_is_digit(next) && next != '.')
			return true;
	}
	return false;
}

/* Converts to upper case and removes blanks; parentheses stay. */
static void unspace(const char *line, char out[LINE_SHAPE_MAX])
{
	size_t length = 0;

	for (; *line && *line != ';' && length < LINE_SHAPE_MAX - 1; line++) {
		if (!ascii_is_space(*line))
			out[length++] = ascii_upper(*line);
	}
	out[length] = '\0';
}

/* Has the line the text with a parenthesis, at its start (after its number) or after other words? */
static bool has_call(const char *line, const char *text, bool begins)
{
	char words[LINE_SHAPE_MAX];
	const char *start = words, *found;

	unspace(line, words);
	start += *start == '/';
	start += *start == 'N' ? 1 + strspn(start + 1, "0123456789") : 0;
	if (begins)
		return starts_with(start, text);
	found = strstr(start, text);
	return found && start + strcspn(start, "(") > found;
}

/* Has the block the address, without a letter before it? "MYCR=5" does not have "CR=5". */
static bool has_address(const char *block, const char *address)
{
	for (const char *at = strstr(block, address); at; at = strstr(at + 1, address)) {
		if (at == block || ascii_is_digit(at[-1]) || strchr(".)]", at[-1]))
			return true;
	}
	return false;
}

/* Does the block start with "R1=5" or "R[1]=5"? */
static bool assigns_r(const char *block)
{
	size_t digits = *block == 'R' ? strspn(block + 1, "0123456789") : 0;

	return digits > 0 && digits < 4 && block[1 + digits] == '=';
}

/* "PROC NAME", "PROC NAME(REAL A) SAVE". Plain text with the same start continues with other words. */
static bool is_proc(const char *line)
{
	const char *at = line + strspn(line, " \t");
	size_t name;

	if (strncmp(at, "PROC", 4) != 0 || (at[4] != ' ' && at[4] != '\t'))
		return false;
	at += 4 + strspn(at + 4, " \t");
	name = ascii_is_letter(*at) || *at == '_' ? strcspn(at, " \t(;\r\n") : 0;
	at += name;
	at += strspn(at, " \t\r\n");
	return name > 0 && (*at == '\0' || *at == '(' || *at == ';' || starts_with(at, "SAVE") ||
			    starts_with(at, "DISPLOF") || starts_with(at, "SBLOF"));
}

/* "VC1", whole */
static bool is_okuma_variable(const char *text)
{
	const size_t digits = starts_with(text, "VC") ? strspn(text + 2, "0123456789") : 0;

	return digits > 0 && !ascii_is_letter(text[2 + digits]) && text[2 + digits] != '_';
}

/* "VC1=5", "X=VC1": on Sinumerik, too, if the program defines such a name. */
static bool has_okuma_variable(const char *block)
{
	const char *value = strchr(block, '=');

	if (!value || value > block + strcspn(block, "[("))
		return false;
	return is_okuma_variable(value + 1) ||
	       (is_okuma_variable(block) && block + 2 + strspn(block + 2, "0123456789") == value);
}

/*
 * "X=5", "S1=500". Others are a text in brackets (DPRNT[X=#1]), a parameter (#1=, Q1=), a comparison (==), and a
 * contour of Klartext (I2 = LBL 5).
 */
static bool assigns_address(const char *block)
{
	const char *end = block + strcspn(block, "[");

	for (const char *at = strchr(block, '='); at && at < end && at[1] != '='; at = strchr(at + 1, '=')) {
		const char *letter = at - 1;

		while (letter > block && ascii_is_digit(*letter))
			letter--;
		if (letter >= block && !is_okuma_variable(at + 1) &&
		    strchr(letter < at - 1 ? "MS" : "ABCFIJKMSUVWXYZ", *letter) &&
		    (letter == block || ascii_is_digit(letter[-1]) || letter[-1] == '.'))
			return true;
	}
	return false;
}

/* "TRANS", "ATRANS X5", "ROT RPL=45". Klartext has TRANS DATUM. */
static bool is_frame(const char *block)
{
	static const char *const names[] = {"TRANS", "ROT", "SCALE", "MIRROR"};

	block += *block == 'A';
	for (size_t i = 0; i < sizeof(names) / sizeof(names[0]); i++) {
		const char *rest = block + strlen(names[i]);

		if (starts_with(block, names[i]) &&
		    (*rest == '\0' || strchr("XYZ", *rest) || starts_with(rest, "RPL=")))
			return true;
	}
	return false;
}

/*
 * G70 and G71 switch to inches and millimetres. As cycles of other controls they have further words. "%PART G71" is
 * the head of a Heidenhain program in DIN/ISO.
 */
static bool switches_units(const char *block)
{
	return *block != '%' && (has_code(block, "G70") || has_code(block, "G71")) && !strpbrk(block, "PQIJLUWR");
}

/* "T1 D1", "T1 M6 D1": a tool and its cutting edge. */
static bool selects_edge(const char *block)
{
	bool tool = false, edge = false;

	while (*block) {
		const size_t digits = strspn(block + 1, "0123456789");

		if (digits == 0 || (*block != 'T' && *block != 'D' && *block != 'M') ||
		    (*block == 'M' && strtol(block + 1, NULL, 10) != 6))
			return false;
		tool = tool || *block == 'T';
		edge = edge || *block == 'D';
		block += 1 + digits;
	}
	return tool && edge;
}

/* "o<name> call", "o100 if [...]" */
static bool is_o_word(const char *block)
{
	static const char *const keywords[] = {"SUB", "ENDSUB", "CALL", "IF[", "ENDIF",
						"WHILE[", "ENDWHILE", "REPEAT["};
	const char *behind = block + 1;

	if (*block != 'O')
		return false;
	behind += *behind == '<' ? strcspn(behind, ">") : strspn(behind, "0123456789");
	behind += *behind == '>';
	for (size_t i = 0; i < sizeof(keywords) / sizeof(keywords[0]); i++) {
		if (behind > block + 1 && starts_with(behind, keywords[i]))
			return true;
	}
	return false;
}

bool family_signs_match(const struct sign *sign, const char *line, const char *block)
{
	const char *words = block + (*block == 'N');

	words += strspn(words, "0123456789");
	/* A structuring block of Klartext ("36 * - TOOL: DM=8 CR=0") is a title: its text is no sign. */
	if (*words == '*')
		return false;
	switch (sign->match) {
	case MATCH_START:
		return starts_with(words, sign->text) || starts_with(line, sign->text);
	case MATCH_ALL:
		return !strcmp(words, sign->text);
	case MATCH_ANYWHERE:
		return strstr(words, sign->text) != NULL;
	case MATCH_STRAIGHT_LINE:
		return words[0] == 'L' && words[1] != '\0' && strchr("XYZABC", words[1]) && strstr(words, sign->text);
	case MATCH_O_CALL:
		return is_o_word(block);
	case MATCH_G:
		return has_code(words, sign->text);
	case MATCH_ADDRESS:
		return has_address(words, sign->text);
	case MATCH_CALL:
	case MATCH_FIRST_CALL:
		return has_call(line, sign->text, sign->match == MATCH_CALL);
	case MATCH_R_PARAMETER:
		return assigns_r(words);
	case MATCH_PROC:
		return is_proc(line);
	case MATCH_ASSIGNED_ADDRESS:
		return assigns_address(words);
	case MATCH_OKUMA_VARIABLE:
		return has_okuma_variable(words);
	case MATCH_FRAME:
		return is_frame(words);
	case MATCH_UNITS:
		return switches_units(words);
	case MATCH_TOOL_EDGE:
		return selects_edge(words);
	case MATCH_PROGRAM_NUMBER:
		return line_shape_is_program_number(block);
	}
	return false;
}
