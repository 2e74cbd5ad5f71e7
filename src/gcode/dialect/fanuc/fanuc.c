#include "gcode/dialect/dialects.h"
#include "gcode/dialect/fanuc/fanuc_family.h"
#include "gcode/dialect/fanuc/fanuc_macro.h"
#include "gcode/dialect/fanuc/macro_b.h"
#include "gcode/dialect/fanuc/macro_b_call.h"
#include "gcode/dialect/fanuc/macro_b_state.h"
#include "gcode/dialect/standard_codes.h"

/* Fanuc 30i-B operator's manual (B-64484EN), preparatory function. */
static const struct code g_codes[] = {
	{G5, G_CONTOUR, NULL},
	{G5_1, G_CONTOUR, NULL},
	{62, GROUP_UNSUPPORTED, "NURBS interpolation"},
	{71, GROUP_UNSUPPORTED, "cylindrical interpolation"},
	{G8, G_CONTOUR, NULL},
	/* G15 and G50.1 take back what is an error where it is switched on. */
	{150, GROUP_HARMLESS, NULL},
	{160, GROUP_UNSUPPORTED, "polar coordinate command"},
	{270, GROUP_UNSUPPORTED, "reference position check"},
	{G33, GROUP_UNSUPPORTED, "thread cutting"},
	{431, GROUP_UNSUPPORTED, "tool length compensation in the tool axis direction"},
	{501, GROUP_HARMLESS, NULL},
	{511, GROUP_UNSUPPORTED, "mirror image"},
	{G53_1, G_NONMODAL, NULL},
	{536, GROUP_UNSUPPORTED, "tool axis direction control that keeps the tool centre point"},
	{542, GROUP_UNSUPPORTED, "rotary table dynamic fixture offset"},
	{544, GROUP_UNSUPPORTED, "work setting error compensation"},
	{620, GROUP_UNSUPPORTED, "automatic corner override"},
	{630, GROUP_UNSUPPORTED, "tapping mode"},
	{660, GROUP_STATEMENT, NULL},
	{661, GROUP_UNSUPPORTED, "modal macro call at every block"},
	{670, GROUP_STATEMENT, NULL},
	{G68_2, G_ROTATION, NULL},
	{683, GROUP_UNSUPPORTED, "tilted working plane by the direction of the tool"},
	{684, GROUP_UNSUPPORTED, "tilted working plane on a tilted plane"},
	{G92_1, GROUP_UNSUPPORTED, "workpiece coordinate system preset"},
	{G96, GROUP_UNSUPPORTED, "constant surface speed"},
	{970, G_SPINDLE, NULL},	/* the mode that is always in force here */
};

static const struct code m_codes[] = {
	/* B-63944EN, rigid tapping: M29, unless parameter 5210 gives it another number. */
	{29, GROUP_HARMLESS, NULL},
	{198, GROUP_UNSUPPORTED, "subprogram call from another memory"},
};

static void *new_state(void)
{
	return macro_b_state_new(&fanuc_macro_rules);
}

const struct dialect dialect_fanuc = {
	.name = "fanuc",
	.legacy = GCODE_FANUC,
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
