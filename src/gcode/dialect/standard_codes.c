#include "gcode/dialect/standard_codes.h"

/*
 * LinuxCNC's manual, "G-Codes", "M-Codes"; Fanuc 30i-B operator's manual (B-64484EN), preparatory function; Haas mill
 * operator's manual, G-codes, M-codes: what all three know.
 */
static const struct code g_codes[] = {
	{G0, G_MOTION, NULL},
	{G1, G_MOTION, NULL},
	{G2, G_MOTION, NULL},
	{G3, G_MOTION, NULL},
	{G4, G_NONMODAL, NULL},
	{G10, G_NONMODAL, NULL},
	{G17, G_PLANE, NULL},
	{G18, G_PLANE, NULL},
	{G19, G_PLANE, NULL},
	{G20, G_UNITS, NULL},
	{G21, G_UNITS, NULL},
	{G28, G_NONMODAL, NULL},
	{G30, G_NONMODAL, NULL},
	{G40, G_CUTTER, NULL},
	{G43, G_LENGTH, NULL},
	{G43_4, G_LENGTH, NULL},
	{435, GROUP_UNSUPPORTED, "tool centre point control with tool vectors"},
	{G49, G_LENGTH, NULL},
	{G52, G_NONMODAL, NULL},
	{G53, G_NONMODAL, NULL},
	{G54, G_SYSTEM, NULL},
	{550, G_SYSTEM, NULL},
	{560, G_SYSTEM, NULL},
	{570, G_SYSTEM, NULL},
	{580, G_SYSTEM, NULL},
	{G59, G_SYSTEM, NULL},
	{G61, G_PATH, NULL},
	{G64, G_PATH, NULL},
	{G73, G_MOTION, NULL},
	{G74, G_MOTION, NULL},
	{G80, G_MOTION, NULL},
	{G81, G_MOTION, NULL},
	{G82, G_MOTION, NULL},
	{G83, G_MOTION, NULL},
	{G84, G_MOTION, NULL},
	{G85, G_MOTION, NULL},
	{G86, G_MOTION, NULL},
	{G89, G_MOTION, NULL},
	{G90, G_DISTANCE, NULL},
	{G91, G_DISTANCE, NULL},
	{G92, G_NONMODAL, NULL},
	{G93, G_FEED_MODE, NULL},
	{G94, G_FEED_MODE, NULL},
	{G95, G_FEED_MODE, NULL},
	{G98, G_RETRACT, NULL},
	{G99, G_RETRACT, NULL},
};

static const struct code m_codes[] = {
	{0, M_STOP, NULL},
	{1, M_STOP, NULL},
	{2, M_STOP, NULL},
	{3, M_SPINDLE, NULL},
	{4, M_SPINDLE, NULL},
	{5, M_SPINDLE, NULL},
	{6, M_TOOL, NULL},
	{7, M_COOLANT, NULL},
	{8, M_COOLANT, NULL},
	{9, M_COOLANT, NULL},
	{30, M_STOP, NULL},
	{60, GROUP_UNSUPPORTED, "pallet change"},
	{99, M_STOP, NULL},
};

const struct code_set standard_g_codes = CODE_SET(g_codes);
const struct code_set standard_m_codes = CODE_SET(m_codes);
