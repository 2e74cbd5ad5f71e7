#include "gcode/dialect/standard_codes.h"

/*
 * LinuxCNC's manual, "G-Codes", "M-Codes"; Fanuc 30i-B operator's manual (B-64484EN), preparatory function; Haas mill
 * operator's manual, G-codes, M-codes: the codes of all three.
 */
static const struct code g_codes[] = {
	{G0, G_MOTION, CODE_READ, "rapid positioning"},
	{G1, G_MOTION, CODE_READ, "straight feed"},
	{G2, G_MOTION, CODE_READ, "arc or helix, clockwise"},
	{G3, G_MOTION, CODE_READ, "arc or helix, counter-clockwise"},
	{G4, G_NONMODAL, CODE_READ, "dwell"},
	{G10, G_NONMODAL, CODE_READ, "setting of work offsets and other data"},
	{G17, G_PLANE, CODE_READ, "plane XY"},
	{G18, G_PLANE, CODE_READ, "plane ZX"},
	{G19, G_PLANE, CODE_READ, "plane YZ"},
	{G20, G_UNITS, CODE_READ, "inches"},
	{G21, G_UNITS, CODE_READ, "millimetres"},
	{G28, G_NONMODAL, CODE_READ, "return to the reference position"},
	{G30, G_NONMODAL, CODE_READ, "return to the second reference position"},
	{G40, G_CUTTER, CODE_READ, "end of cutter compensation"},
	{G43, G_LENGTH, CODE_READ, "tool length compensation"},
	{G49, G_LENGTH, CODE_READ, "end of tool length compensation"},
	{G52, G_NONMODAL, CODE_READ, "local coordinate system"},
	{G53, G_NONMODAL, CODE_READ, "move in machine coordinates"},
	{G54, G_SYSTEM, CODE_READ, "work offset 1"},
	{550, G_SYSTEM, CODE_READ, "work offset 2"},
	{560, G_SYSTEM, CODE_READ, "work offset 3"},
	{570, G_SYSTEM, CODE_READ, "work offset 4"},
	{580, G_SYSTEM, CODE_READ, "work offset 5"},
	{G59, G_SYSTEM, CODE_READ, "work offset 6"},
	{G61, G_PATH, CODE_READ, "exact path or exact stop"},
	{G64, G_PATH, CODE_READ, "continuous path, with a tolerance in P on some controls"},
	{G73, G_MOTION, CODE_READ, "high-speed peck drilling cycle"},
	{G74, G_MOTION, CODE_READ, "left-hand tapping cycle"},
	{G80, G_MOTION, CODE_READ, "end of a canned cycle"},
	{G81, G_MOTION, CODE_READ, "drilling cycle"},
	{G82, G_MOTION, CODE_READ, "drilling cycle with dwell"},
	{G83, G_MOTION, CODE_READ, "peck drilling cycle"},
	{G84, G_MOTION, CODE_READ, "tapping cycle"},
	{G85, G_MOTION, CODE_READ, "boring cycle, feed out"},
	{G86, G_MOTION, CODE_READ, "boring cycle, spindle stop"},
	{G89, G_MOTION, CODE_READ, "boring cycle with dwell, feed out"},
	{G90, G_DISTANCE, CODE_READ, "absolute coordinates"},
	{G91, G_DISTANCE, CODE_READ, "incremental coordinates"},
	{G92, G_NONMODAL, CODE_READ, "coordinate system shift"},
	{G93, G_FEED_MODE, CODE_READ, "inverse time feed"},
	{G94, G_FEED_MODE, CODE_READ, "feed per minute"},
	{G95, G_FEED_MODE, CODE_READ, "feed per revolution"},
	{G98, G_RETRACT, CODE_READ, "canned cycles retract to the initial level"},
	{G99, G_RETRACT, CODE_READ, "canned cycles retract to R"},
};

/* The same in the programming manual of Sinumerik 840D sl, "Fundamentals". */
static const struct code basic_rows[] = {
	{0, M_STOP, CODE_READ, "program stop"},
	{1, M_STOP, CODE_READ, "optional stop"},
	{2, M_STOP, CODE_READ, "end of program"},
	{3, M_SPINDLE, CODE_READ, "spindle on, clockwise"},
	{4, M_SPINDLE, CODE_READ, "spindle on, counter-clockwise"},
	{5, M_SPINDLE, CODE_READ, "spindle stop"},
	{6, M_TOOL, CODE_READ, "tool change"},
	{7, M_COOLANT, CODE_IGNORED, "coolant"},
	{8, M_COOLANT, CODE_IGNORED, "coolant"},
	{9, M_COOLANT, CODE_IGNORED, "coolant off"},
};

static const struct code m_codes[] = {
	{30, M_STOP, CODE_READ, "end of program and rewind"},
	{60, GROUP_NONE, CODE_REFUSED, "pallet change"},
	{99, M_STOP, CODE_READ, "end of a subprogram, or restart of the program"},
};

const struct code_set standard_g_codes = CODE_SET(g_codes);
const struct code_set basic_m_codes = CODE_SET(basic_rows);
const struct code_set standard_m_codes = CODE_SET(m_codes);
