#include "gcode/execute/cutter_comp/comp_codes.h"

#include <math.h>

#include "base/same_double.h"
#include "gcode/execute/cutter_comp/comp_lookahead.h"
#include "gcode/execute/cutter_comp/comp_moves.h"
#include "gcode/execute/cutter_comp/cutter_comp.h"
#include "gcode/read_on.h"

static bool find_radius(struct interp *interp, double *radius)
{
	const struct block *block = &interp->block;
	const struct tool *tool;
	int code = block->g[G_CUTTER], column = block->g_column[G_CUTTER], number = interp->state.tool;

	if (code == G41_1 || code == G42_1) {
		if (!block_has(block, 'D'))
			return fault(&interp->at, column, "G%d.1 needs D (tool diameter)", code / 10);
		*radius = block_value(block, 'D') * interp->state.scale / 2;
		return true;
	}
	if (block_has(block, 'D')) {
		column = block_column(block, 'D');
		if (!block_integer(block, &interp->at, 'D', 0, 1000000, &number))
			return false;
		number = number == 0 ? interp->state.tool : number;
	}
	tool = tool_table_find(&interp->tools, number);
	*radius = tool ? tool->diameter / 2 : 0;
	return tool || number == 0 ||
	       fault(&interp->at, column, "the setup does not give the diameter of tool T%d", number);
}

/*
 * Fanuc B-64484EN, "Cutter compensation": D is the number of an offset, 0 is none, and D is modal. Haas, "D Code": the
 * same. Only the setup tells whether the table has the full radius of a tool or only its wear.
 */
static bool find_radius_in_table(struct interp *interp, double *radius)
{
	const struct block *block = &interp->block;
	const struct radius_offset *offset;
	int number = interp->comp.number;
	int column = block_has(block, 'D') ? block_column(block, 'D') : block->g_column[G_CUTTER];

	if (number < 0)
		return fault(&interp->at, column, "G%d needs D (number of the radius)", block->g[G_CUTTER] / 10);
	*radius = 0;
	if (number == 0)
		return true;
	offset = tool_table_radius(&interp->tools, number);
	if (!offset)
		return read_on_without(
		    interp, column,
		    "D%d: the setup has no such radius; add <offset number=\"%d\" radius=\"\"/>: the full tool radius "
		    "if the program has the contour of the part; the wear (or 0) if it has the path of the tool centre",
		    number, number);
	*radius = offset->radius;
	return true;
}

/* D with G41 or G42 on controls that look ahead. */
static bool switch_on_ahead(struct interp *interp)
{
	const struct block *block = &interp->block;
	const struct state *state = &interp->state;
	struct cutter_comp *comp = &interp->comp;
	int column = block->g_column[G_CUTTER], side = block->g[G_CUTTER] == G41 ? 1 : -1;
	double radius = 0;
	bool moves = comp_lookahead_leaves(interp);

	if (block_has(block, 'L'))
		return fault(&interp->at, block_column(block, 'L'), "no code in the block uses the word L");
	if (!find_radius_in_table(interp, &radius))
		return false;
	side = radius < 0 ? -side : side;
	/* Modal codes may be repeated. */
	if (comp->side == side && same_double(comp->radius, fabs(radius)))
		return true;
	if (comp->side != 0)
		return fault(&interp->at, column,
			     "another side or radius of cutter compensation while it is on; write G40 first");
	/* On a plane of G53.1 the rotary axes stand still. */
	if (state->tcp != TCP_OFF && state->tcp != TCP_BY_PLANE)
		return fault(&interp->at, column,
			     "cutter compensation under tool centre point control is not supported");
	if (!moves && traits_of(interp)->comp_waits != ANSWER_YES &&
	    interp->config->controller.comp_start == COMP_START_UNKNOWN)
		return fault(
		    &interp->at, column,
		    "G%d in a block without a move in the plane: a parameter of the control decides whether the tool "
		    "moves sideways at once: set cutter_comp_start=\"A\" or \"B\" (both wait for the next move) in the "
		    "machine file's <controller>",
		    block->g[G_CUTTER] / 10);
	comp_lookahead_begin(comp, side, fabs(radius));
	comp->start_type = interp->config->controller.comp_start;
	comp->corner_form = interp->config->controller.comp_corner;
	return true;
}

/* Takes the block's D, on controls where D is modal. */
static bool take_number(struct interp *interp)
{
	const struct block *block = &interp->block;
	struct cutter_comp *comp = &interp->comp;
	int number = 0;

	comp->looks_ahead = traits_of(interp)->d_word == D_WORD_RADIUS;
	if (!comp->looks_ahead || !block_has(block, 'D') || block->g[G_SPINDLE] == G96)
		return true;
	if (!block_integer(block, &interp->at, 'D', 0, 1000000, &number))
		return false;
	if (comp->side != 0 && number != comp->number)
		return fault(&interp->at, block_column(block, 'D'),
			     "another D while cutter compensation is on; write G40 first");
	comp->number = number;
	return true;
}

/* Checks the block's G41 or G42 and takes its side and radius; the next move is the entry. */
static bool switch_on(struct interp *interp)
{
	const struct block *block = &interp->block;
	struct cutter_comp *comp = &interp->comp;
	int code = block->g[G_CUTTER], column = block->g_column[G_CUTTER];
	double radius = 0;

	if (!is_answered(interp, column, (int)traits_of(interp)->d_word, "what D of cutter compensation means"))
		return false;
	if (comp->looks_ahead)
		return switch_on_ahead(interp);
	if (interp->state.plane == G19)
		return fault(&interp->at, column, "cutter compensation works only in the planes of G17 and G18");
	if (comp->side != 0)
		return fault(&interp->at, column, "cutter compensation is already on; write G40 first");
	if (block_has(block, 'L'))
		return fault(&interp->at, block_column(block, 'L'),
			     "L (orientation of a lathe tool) is not supported");
	if (!find_radius(interp, &radius))
		return false;
	comp->side = code == G41 || code == G41_1 ? 1 : -1;
	/* A negative diameter exchanges the sides. */
	if (radius < 0)
		comp->side = -comp->side;
	comp->radius = fabs(radius);
	comp->entered = false;
	return true;
}

bool comp_codes_select(struct interp *interp)
{
	struct cutter_comp *comp = &interp->comp;
	int code = interp->block.g[G_CUTTER];

	if (!take_number(interp))
		return false;
	if (code == CODE_NONE)
		return true;
	if (code != G40)
		return switch_on(interp);
	if (comp->entered && comp->looks_ahead && comp_lookahead_leaves(interp)) {
		comp->leaving = true;
		return true;
	}
	if (comp->entered) {
		if (comp->looks_ahead ? !comp_lookahead_stop(interp) : !comp_send_to(interp, comp->current))
			return false;
		comp->arc_refused = true;
	}
	comp->side = 0;
	comp->entered = false;
	return true;
}

static bool refuse(struct interp *interp, int column, const char *what)
{
	return fault(&interp->at, column, "%s while cutter compensation is on; write G40 first", what);
}

bool comp_codes_start_block(struct interp *interp)
{
	const struct block *block = &interp->block;

	if (interp->comp.side == 0)
		return true;
	if (block->m[M_TOOL] != CODE_NONE)
		return refuse(interp, block->m_column[M_TOOL], "a tool change");
	if (block->m[M_TCP] != CODE_NONE)
		return refuse(interp, block->m_column[M_TCP], "tool centre point control");
	if (block->g[G_PLANE] != CODE_NONE && block->g[G_PLANE] != interp->state.plane)
		return refuse(interp, block->g_column[G_PLANE], "a change of the plane");
	if (block->g[G_MIRROR] != CODE_NONE)
		return refuse(interp, block->g_column[G_MIRROR], "a change of the coordinates");
	if (block->g[G_ROTATION] != CODE_NONE)
		return refuse(interp, block->g_column[G_ROTATION], "a change of the coordinates");
	return true;
}

static bool moves_as_compensated(int motion)
{
	return motion == CODE_NONE || motion == G80 || motion == G0 || motion == G1 || motion == G2 || motion == G3;
}

/* Between G40 and the next move of an axis, the axis' present coordinate must not be used. */
static bool check_loose(struct interp *interp)
{
	const struct block *block = &interp->block;

	for (int slot = SLOT_X; slot <= SLOT_Z && block->g[G_NONMODAL] == G92; slot++) {
		if (interp->comp.loose[slot] > 0)
			return fault(
			    &interp->at, block->g_column[G_NONMODAL],
			    "G92 after G40 before %c has moved: controls differ in the position of the axis",
			    AXIS_LETTERS[slot]);
	}
	return true;
}

bool comp_codes_check_block(struct interp *interp)
{
	static const struct {
		enum g_group group;
		const char *what;
	} groups[] = {{G_LENGTH, "a change of the tool length"},
		      {G_SYSTEM, "a change of the work offset"},
		      {G_PATH, "a change of the path mode"},
		      {G_RETRACT, "a change of the retract mode"}};
	const struct block *block = &interp->block;
	int code = block->g[G_NONMODAL];

	if (interp->comp.side == 0)
		return check_loose(interp);
	for (size_t i = 0; i < sizeof(groups) / sizeof(groups[0]); i++)
		if (block->g[groups[i].group] != CODE_NONE)
			return refuse(interp, block->g_column[groups[i].group], groups[i].what);
	if (code != CODE_NONE && code != G4 && !(code == G53 && !cutter_comp_is_on(interp)))
		return refuse(interp, block->g_column[G_NONMODAL], "a code that moves or shifts the machine's axes");
	if (!moves_as_compensated(block->motion))
		return fault(&interp->at, block_motion_column(block),
			     "G%g while cutter compensation is on; write G40 first", block->motion / 10.0);
	if (cutter_comp_is_on(interp) && interp->state.feed_mode == FEED_INVERSE_TIME && block->motion >= G1)
		return fault(&interp->at, block_motion_column(block),
			     "inverse time mode (G93) under cutter compensation is not supported");
	return true;
}
