#include "gcode/dialect/fanuc/fanuc_family.h"

/* Fanuc 30i-B operator's manual (B-64484EN), preparatory function; Haas mill operator's manual, G-codes, M-codes. */
static const struct code g_codes[] = {
	{G9, G_EXACT, CODE_IGNORED, "exact stop in one block"},
	{290, GROUP_NONE, CODE_REFUSED, "return from the reference position"},
	{G31, G_MOTION, CODE_BOUNDED, "skip function"},
	{370, GROUP_NONE, CODE_REFUSED, "tool offset measurement"},
	{G41, G_CUTTER, CODE_BOUNDED, "cutter compensation, left"},
	{G42, G_CUTTER, CODE_BOUNDED, "cutter compensation, right"},
	{G43_4, G_LENGTH, CODE_READ, "tool centre point control"},
	{440, GROUP_NONE, CODE_REFUSED, "negative tool length compensation"},
	{G50, G_SCALING, CODE_READ, "end of scaling"},
	{G51, G_SCALING, CODE_READ, "scaling"},
	{G54_1, G_SYSTEM, CODE_READ, "additional work offset"},
	{G60, G_APPROACH, CODE_BOUNDED, "unidirectional positioning"},
	{650, GROUP_STATEMENT, CODE_READ, "macro call"},
	{G68, G_ROTATION, CODE_READ, "coordinate rotation"},
	{G69, G_ROTATION, CODE_READ, "end of coordinate rotation"},
	{G76, G_MOTION, CODE_BOUNDED, "fine boring cycle"},
	{G87, G_MOTION, CODE_BOUNDED, "back boring cycle, or boring cycle with a retract by hand"},
	{G88, G_MOTION, CODE_READ, "boring cycle with a retract by hand"},
};

static const struct code m_codes[] = {
	/* Fanuc B-64483EN, spindle orientation; Haas, "M19 Orient Spindle": it stops at the angle of P or R. */
	{19, M_SPINDLE, CODE_READ, "spindle orientation"},
	{98, M_STOP, CODE_READ, "subprogram call"},
};

/* B-63944EN, custom macro; Haas mill operator's manual, "Macros". */
static const struct code_word words[] = {
	{"#n =", CODE_READ, "macro variable; reading a value that only the machine knows is an error"},
	{"IF [...] GOTO n", CODE_READ, "conditional jump"},
	{"IF [...] THEN", CODE_READ, "conditional statement"},
	{"GOTO n", CODE_READ, "jump"},
	{"WHILE [...] DO m", CODE_READ, "loop up to END m"},
	{"POPEN", CODE_IGNORED, "output to a port or a file (also PCLOS, BPRNT, DPRNT)"},
};

const struct word_set fanuc_family_words = {words, sizeof(words) / sizeof(*words)};
const struct code_set fanuc_family_g_codes = CODE_SET(g_codes);
const struct code_set fanuc_family_m_codes = CODE_SET(m_codes);
