#include "gcode/dialect/fanuc/fanuc_family.h"

/* Fanuc 30i-B operator's manual (B-64484EN), preparatory function; Haas mill operator's manual, G-codes, M-codes. */
static const struct code g_codes[] = {
	{90, GROUP_UNSUPPORTED, "exact stop in one block"},
	{290, GROUP_UNSUPPORTED, "return from the reference position"},
	{310, GROUP_UNSUPPORTED, "skip function"},
	{370, GROUP_UNSUPPORTED, "tool offset measurement"},
	{G41, GROUP_UNSUPPORTED, "cutter compensation"},
	{G42, GROUP_UNSUPPORTED, "cutter compensation"},
	{440, GROUP_UNSUPPORTED, "negative tool length compensation"},
	/* G50 takes back what is an error where it is switched on. */
	{500, GROUP_HARMLESS, NULL},
	{510, GROUP_UNSUPPORTED, "scaling"},
	{G54_1, G_SYSTEM, NULL},
	{600, GROUP_UNSUPPORTED, "unidirectional positioning"},
	{650, GROUP_STATEMENT, NULL},
	{G68, G_ROTATION, NULL},
	{G69, G_ROTATION, NULL},
	{G76, G_MOTION, NULL},
	{G87, G_MOTION, NULL},
	{G88, G_MOTION, NULL},
};

static const struct code m_codes[] = {
	/* Fanuc B-64483EN, spindle orientation; Haas, "M19 Orient Spindle": the spindle stops, at the angle of P or R. */
	{19, M_SPINDLE, NULL},
	{98, M_STOP, NULL},
};

const struct code_set fanuc_family_g_codes = CODE_SET(g_codes);
const struct code_set fanuc_family_m_codes = CODE_SET(m_codes);
