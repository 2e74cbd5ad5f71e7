#include "gcode/dialect/dialects.h"
#include "gcode/dialect/fanuc/fanuc_family.h"
#include "gcode/dialect/fanuc/macro_b.h"
#include "gcode/dialect/fanuc/macro_b_call.h"
#include "gcode/dialect/fanuc/macro_b_state.h"
#include "gcode/dialect/haas/haas_macro.h"
#include "gcode/dialect/standard_codes.h"

/* Haas mill operator's manual, G-codes, M-codes. */
static const struct code g_codes[] = {
	{120, GROUP_UNSUPPORTED, "circular pocket milling"},
	{130, GROUP_UNSUPPORTED, "circular pocket milling"},
	{350, GROUP_UNSUPPORTED, "tool diameter measurement"},
	{360, GROUP_UNSUPPORTED, "work offset measurement"},
	{470, GROUP_UNSUPPORTED, "text engraving"},
	{G53_1, GROUP_UNSUPPORTED, "tool axis direction control"},
	{G68_2, GROUP_UNSUPPORTED, "tilted working plane"},
	{700, GROUP_UNSUPPORTED, "bolt circle cycle"},
	{710, GROUP_UNSUPPORTED, "bolt arc cycle"},
	{720, GROUP_UNSUPPORTED, "bolt line cycle"},
	{770, GROUP_UNSUPPORTED, "back boring cycle"},
	/* G100 takes back what is an error where it is switched on. */
	{1000, GROUP_HARMLESS, NULL},
	{1010, GROUP_UNSUPPORTED, "mirror image"},
	{G103, G_CONTOUR, NULL},
	{1100, G_SYSTEM, NULL},
	{1110, G_SYSTEM, NULL},
	{1120, G_SYSTEM, NULL},
	{1130, G_SYSTEM, NULL},
	{1140, G_SYSTEM, NULL},
	{1150, G_SYSTEM, NULL},
	{1160, G_SYSTEM, NULL},
	{1170, G_SYSTEM, NULL},
	{1180, G_SYSTEM, NULL},
	{1190, G_SYSTEM, NULL},
	{1200, G_SYSTEM, NULL},
	{1210, G_SYSTEM, NULL},
	{1220, G_SYSTEM, NULL},
	{1230, G_SYSTEM, NULL},
	{1240, G_SYSTEM, NULL},
	{1250, G_SYSTEM, NULL},
	{1260, G_SYSTEM, NULL},
	{1270, G_SYSTEM, NULL},
	{1280, G_SYSTEM, NULL},
	{1290, G_SYSTEM, NULL},
	{1360, GROUP_UNSUPPORTED, "work offset centre measurement"},
	{1410, GROUP_UNSUPPORTED, "3D cutter compensation"},
	{1430, GROUP_UNSUPPORTED, "5-axis tool length compensation"},
	{1500, GROUP_UNSUPPORTED, "pocket milling"},
	{G154, G_SYSTEM, NULL},
	{G187, G_CONTOUR, NULL},
	{G234, G_LENGTH, NULL},
	{2530, GROUP_UNSUPPORTED, "spindle orientation to the feature coordinates"},
	{G254, G_DYNAMIC, NULL},
	{G255, G_DYNAMIC, NULL},
	{2680, GROUP_UNSUPPORTED, "feature coordinate system"},
	{2690, GROUP_UNSUPPORTED, "cancelling of the feature coordinate system"},
};

static const struct code m_codes[] = {
	/* Haas mill operator's manual, M-codes: brakes of the rotary axes. */
	{10, GROUP_HARMLESS, NULL},
	{11, GROUP_HARMLESS, NULL},
	{12, GROUP_HARMLESS, NULL},
	{13, GROUP_HARMLESS, NULL},
	/* Haas: chip conveyor, gears; further on the air jet (M83, M84) and coolant through the spindle (M88, M89). */
	{31, GROUP_HARMLESS, NULL},
	{33, GROUP_HARMLESS, NULL},
	{34, GROUP_UNSUPPORTED, "move of the coolant nozzle"},
	{35, GROUP_UNSUPPORTED, "move of the coolant nozzle"},
	{41, GROUP_HARMLESS, NULL},
	{42, GROUP_HARMLESS, NULL},
	{50, GROUP_UNSUPPORTED, "pallet change"},
	{83, GROUP_HARMLESS, NULL},
	{84, GROUP_HARMLESS, NULL},
	{88, GROUP_HARMLESS, NULL},
	{89, GROUP_HARMLESS, NULL},
	{96, GROUP_UNSUPPORTED, "jump on an input"},
	{97, M_STOP, NULL},
	{138, GROUP_HARMLESS, NULL},	/* and M139: the spindle's speed varies */
	{139, GROUP_HARMLESS, NULL},
};

static void *new_state(void)
{
	return macro_b_state_new(&haas_macro_rules);
}

const struct dialect dialect_haas = {
	.name = "haas",
	.legacy = GCODE_HAAS,
	.g_codes = {&standard_g_codes, &fanuc_family_g_codes, &(const struct code_set)CODE_SET(g_codes)},
	.m_codes = {&standard_m_codes, &fanuc_family_m_codes, &(const struct code_set)CODE_SET(m_codes)},
	.state_new = new_state,
	.state_free = macro_b_state_free,
	.statement = macro_b_line,
	.read_block = macro_b_read_block,
	.after_block = macro_b_call_after_block,
	.end_of_file = macro_b_call_end_of_file,
	.note_callers = macro_b_call_note_callers,
};
