#include "gcode/dialect/sinumerik/path/sinumerik_comp.h"

#include <math.h>

#include "base/same_double.h"
#include "gcode/dialect/sinumerik/frames/sinumerik_frame.h"
#include "gcode/dialect/sinumerik/frames/sinumerik_open_place.h"
#include "gcode/dialect/sinumerik/frames/sinumerik_place_check.h"
#include "gcode/execute/cutter_comp/comp_lookahead.h"
#include "gcode/execute/cutter_comp/comp_moves.h"
#include "gcode/execute/cutter_comp/cutter_comp.h"
#include "geom/tolerance.h"

/* A direction is along an axis if its other part is less than this part of its length. */
#define ALONG 1e-9

/* --------------------------------------------------------------- questions */

static bool refuse(struct interp *interp, int column, const char *what)
{
	return fault(&interp->at, column, "%s while tool radius compensation is on; G40 first", what);
}

/* With a radius of 0 the tool is on the path (comp.side is 0), but another radius would move it aside. */
static bool is_on(const struct interp *interp)
{
	return interp->comp.side != 0 || sinumerik_of(interp)->comp.selected > G40;
}

bool sinumerik_comp_check(struct interp *interp, const struct sinumerik_block *block)
{
	static const struct {
		enum sinumerik_group group;
		const char *what;
	} groups[] = {{SINUMERIK_TRANSFORM, "TRAORI or TRAFOOF"},
		      {SINUMERIK_FRAME, "a change of the frame"},
		      {SINUMERIK_TOOL_FRAME, "a change of the frame"},
		      {SINUMERIK_SYSTEM, "a change of the work offset"},
		      {SINUMERIK_SUPPRESSION, "a move in the machine's coordinates"}};
	const int once = block->code[SINUMERIK_ONCE];

	if (!is_on(interp))
		return true;
	for (size_t i = 0; i < sizeof(groups) / sizeof(groups[0]); i++) {
		if (block->code[groups[i].group] != CODE_NONE)
			return refuse(interp, block->code_column[groups[i].group], groups[i].what);
	}
	if (block->code[SINUMERIK_PLANE] != CODE_NONE && block->code[SINUMERIK_PLANE] != interp->state.plane)
		return refuse(interp, block->code_column[SINUMERIK_PLANE], "a change of the plane");
	if (once == SINUMERIK_G(74) || once == SINUMERIK_G(75))
		return refuse(interp, block->code_column[SINUMERIK_ONCE], "a move in the machine's coordinates");
	if (sinumerik_block_has(block, 'D') && fabs(block->value['D' - 'A'] - sinumerik_of(interp)->tool.edge) > 0)
		return refuse(interp, block->column['D' - 'A'], "another D");
	for (int i = 0; i < block->m_count; i++) {
		if (block->m[i] == 6)
			return refuse(interp, block->m_column[i], "a tool change");
	}
	if (block->modal && block->call[0])
		return refuse(interp, block->modal_column, "a modal call");
	if (block->stops_reading)
		return refuse(interp, 1, "STOPRE, which ends the control's look ahead,");
	return true;
}

/* ---------------------------------------------------------------- switching */

/* The radius of the active edge. False: it is not known, which was reported. */
static bool find_radius(struct interp *interp, int column, double *radius)
{
	const struct sinumerik *sinumerik = sinumerik_of(interp);
	const int number = interp->state.tool;
	const struct tool *tool = tool_table_find(&interp->tools, number);
	double diameter = tool ? tool->diameter : 0;

	*radius = 0;
	if (!sinumerik_place_check_edge(interp, column))
		return false;
	if (sinumerik->tool.edge == 0 || number == 0)
		return true;
	for (size_t i = 0; i < interp->config->edge_count; i++) {
		const struct tool_edge *edge = &interp->config->edges[i];

		if (edge->tool == number && edge->number == sinumerik->tool.edge &&
		    fabs(edge->diameter) > 0)
			diameter = edge->diameter;
	}
	*radius = diameter / 2;
	return diameter > 0 ||
	       fault(&interp->at, column,
		     "the radius of T%d D%d is not known, or 0: give the tool of the setup a <cutter>, or "
		     "diameter=\"\"",
		     number, sinumerik->tool.edge);
}

/*
 * 840D sl, job planning, "CUT2D, CUT2DF": CUT2D corrects in the plane of the machine's axes, CUT2DF in the plane of
 * the frame. The two planes are the same if the frame does not tilt the plane, and after CYCLE800 if the table has
 * turned. While TRAORI is on, the plane of the machine's axes is that of the workpiece coordinates, for any position
 * of the rotary axes.
 */
static bool check_plane(struct interp *interp, int column)
{
	const struct state *state = &interp->state;
	const int across = comp_slot_across(interp);
	const vec3 normal = {across == SLOT_X, across == SLOT_Y, across == SLOT_Z};
	vec3 seen = normal;

	if (sinumerik_frame_resizes(interp))
		return fault(&interp->at, column,
			     "tool radius compensation while SCALE is in force is not supported");
	if (sinumerik_of(interp)->comp.turns_plane)
		return true;
	if (state->tcp != TCP_BY_PLANE && state->frame.on)
		seen = mat3_apply(&state->frame.turn, normal);
	if (state->tcp == TCP_BY_PLANE && sinumerik_of(interp)->frames.tool_upright && state->plane == G17)
		return true;
	return (state->tcp != TCP_BY_PLANE && vec3_norm(vec3_cross(seen, normal)) <= ALONG * vec3_norm(seen)) ||
	       fault(&interp->at, column,
		     "tool radius compensation in a plane that a frame tilts: CUT2D, which is in force, corrects in "
		     "the plane of "
		     "the machine's axes; CUT2DF corrects in the tilted one");
}

/*
 * With NORM the tool moves straight to the point beside the contour. Before any NORM or KONT the machine file may say
 * that NORM is active.
 */
static enum comp_start start_type(const struct interp *interp)
{
	const int approach = sinumerik_of(interp)->comp.approach;
	const bool begun = interp->config->controller.comp_start == COMP_START_A;

	return approach == SINUMERIK_NORM || (approach == CODE_NONE && begun) ? COMP_START_A : COMP_START_UNKNOWN;
}

/* Before any G450 or G451 the machine file may say which one is active at the start (MD20150), with DISC=0. */
static enum comp_corner_form corner_form(const struct interp *interp)
{
	const struct sinumerik *sinumerik = sinumerik_of(interp);
	const enum comp_corner_form begun = interp->config->controller.comp_corner;

	if (sinumerik->comp.corner == SINUMERIK_G(451) ||
	    (sinumerik->comp.corner == CODE_NONE && begun == COMP_CORNER_LINEAR))
		return COMP_CORNER_CROSSING_IF_BLUNT;
	if ((sinumerik->comp.corner == SINUMERIK_G(450) || begun == COMP_CORNER_CIRCULAR) &&
	    !(sinumerik->comp.disc > 0))
		return COMP_CORNER_CIRCULAR;
	return COMP_CORNER_BETWEEN;
}

bool sinumerik_comp_rounds(const struct interp *interp)
{
	return corner_form(interp) == COMP_CORNER_CIRCULAR;
}

static bool switch_on(struct interp *interp, int column, int side)
{
	struct cutter_comp *comp = &interp->comp;
	const double aside = sinumerik_of(interp)->comp.allowance;
	double radius;

	if (comp->side == side)
		return true;
	if (comp->side != 0)
		return refuse(interp, column, "the other side of the path");
	if (!find_radius(interp, column, &radius) || !check_plane(interp, column))
		return false;
	if (!(radius > 0) && fabs(aside) > 0)
		return fault(&interp->at, column,
			     "OFFN while no edge of a tool is in force (T0 or D0): whether the control keeps the tool "
			     "away from the contour by OFFN alone is not known; write D1, or OFFN=0");
	if (radius + aside < 0)
		return fault(&interp->at, column, "OFFN is less than minus the tool's radius, which is not supported");
	radius += aside;
	/* The tool is on the path. */
	if (!(radius > 0))
		return true;
	comp_lookahead_begin(comp, side, radius);
	comp->start_type = start_type(interp);
	comp->corner_form = corner_form(interp);
	return true;
}

static bool moves_in_plane(const struct interp *interp, const struct sinumerik_block *block)
{
	return interp->state.motion <= G3 && (sinumerik_block_has(block, AXIS_LETTERS[comp_slot_a(interp)]) ||
					      sinumerik_block_has(block, AXIS_LETTERS[comp_slot_b(interp)]));
}

/* In rotated coordinates, a move of one axis may leave the position of any axis uncertain. */
static void loosen_all(struct interp *interp)
{
	double *loose = interp->comp.loose;

	for (int slot = SLOT_X; slot <= SLOT_Z && (interp->state.frame.on || interp->state.tcp != TCP_OFF); slot++)
		loose[slot] = interp->comp.radius;
}

static bool switch_off(struct interp *interp, const struct sinumerik_block *block)
{
	struct cutter_comp *comp = &interp->comp;
	const bool soft = block->code[SINUMERIK_SOFT] != CODE_NONE;
	const int motion =
	    block->code[SINUMERIK_MOTION] != CODE_NONE ? block->code[SINUMERIK_MOTION] : interp->state.motion;

	if (comp->side == 0)
		return true;
	if (comp->entered && (motion <= G1 || soft) && moves_in_plane(interp, block)) {
		comp->leaving = true;
		return true;
	}
	if (comp->entered && soft)
		return fault(&interp->at, block->code_column[SINUMERIK_CUTTER],
			     "G40 beside a soft retraction without a coordinate of the plane is not supported: give it "
			     "both coordinates of its end");
	interp->block.g_column[G_CUTTER] = block->code_column[SINUMERIK_CUTTER];
	interp->block.g[G_CUTTER] = G40;
	if (comp->entered) {
		if (moves_in_plane(interp, block))
			return fault(&interp->at, block->code_column[SINUMERIK_CUTTER],
				     "tool radius compensation ends in a straight line (G0, G1), not in a circle");
		if (!comp_lookahead_stop(interp))
			return false;
		loosen_all(interp);
	}
	interp->block.g[G_CUTTER] = CODE_NONE;
	comp->side = 0;
	comp->entered = false;
	return true;
}

/*
 * 840D sl, "OFFN": the tool stays farther from the contour by this length, as if its radius were larger. Posts write -R
 * with the path of the tool's centre.
 */
static bool set_allowance(struct interp *interp, const struct sinumerik_block *block)
{
	struct sinumerik *sinumerik = sinumerik_of(interp);
	const int column = block->address_column[SINUMERIK_OFFN];
	const double allowance = block->address_value[SINUMERIK_OFFN] * interp->state.scale;

	if (!sinumerik_block_has_address(block, SINUMERIK_OFFN) || same_double(allowance, sinumerik->comp.allowance))
		return true;
	if (is_on(interp))
		return refuse(interp, column, "another OFFN");
	if (interp->state.unknown_modes & 1U << G_UNITS)
		return fault(&interp->at, column,
			     "a parameter of the control decides whether OFFN is in mm or inches before any G70, "
			     "G71, G700 or G710: set power_on_units=\"mm\" or \"inch\" in the machine file's "
			     "<controller>");
	if (!same_double(interp->state.scale, sinumerik->feed_scale) && !same_double(allowance, 0))
		return fault(&interp->at, column,
			     "whether OFFN is in mm or inches where G70 or G71 differs from the control's own unit is "
			     "not known here; write G700 or G710");
	sinumerik->comp.allowance = allowance;
	return true;
}

bool sinumerik_comp_check_turn(struct interp *interp, const slot_values *target, bool on_circle, int column)
{
	const slot_values *place = sinumerik_frame_place(interp);

	if (interp->comp.side == 0 || interp->state.tcp != TCP_BY_LENGTH)
		return true;
	for (int slot = SLOT_A; slot <= SLOT_C; slot++) {
		if (on_circle || !same_double(target->v[slot], place->v[slot]))
			return fault(&interp->at, column,
				     "TRAORI turns the tool while tool radius compensation is on, which is not "
				     "supported: turn it before G41 or G42");
	}
	return true;
}

bool sinumerik_comp_select(struct interp *interp, const struct sinumerik_block *block)
{
	struct sinumerik *sinumerik = sinumerik_of(interp);
	const int *code = block->code, column = block->code_column[SINUMERIK_CUTTER];
	const bool shapes = code[SINUMERIK_CORNER] != CODE_NONE || sinumerik_block_has_address(block, SINUMERIK_DISC);
	const double disc = block->address_value[SINUMERIK_DISC];

	if (interp->comp.side != 0 && shapes)
		return refuse(interp, code[SINUMERIK_CORNER] != CODE_NONE ? block->code_column[SINUMERIK_CORNER]
									  : block->address_column[SINUMERIK_DISC],
			      "another way round corners");
	if (sinumerik_block_has_address(block, SINUMERIK_DISC) && !(disc >= 0 && disc <= 100))
		return fault(&interp->at, block->address_column[SINUMERIK_DISC], "DISC lies between 0 and 100");
	if (code[SINUMERIK_APPROACH] != CODE_NONE) {
		sinumerik->comp.approach = code[SINUMERIK_APPROACH];
		/* This block defines the retraction. */
		interp->comp.start_type = start_type(interp);
	}
	if (code[SINUMERIK_CORNER] != CODE_NONE)
		sinumerik->comp.corner = code[SINUMERIK_CORNER];
	if (sinumerik_block_has_address(block, SINUMERIK_DISC))
		sinumerik->comp.disc = disc;
	if (!set_allowance(interp, block))
		return false;
	if (code[SINUMERIK_CUT] != CODE_NONE)
		sinumerik->comp.turns_plane = code[SINUMERIK_CUT] == SINUMERIK_CUT2DF;
	if (code[SINUMERIK_CUTTER] == CODE_NONE)
		return true;
	/* A soft retraction is still on the side of G41 or G42: G40 holds from its last way on. */
	if (code[SINUMERIK_CUTTER] != G40 || code[SINUMERIK_SOFT] == CODE_NONE)
		sinumerik->comp.selected = code[SINUMERIK_CUTTER];
	if (code[SINUMERIK_CUTTER] == G40)
		return switch_off(interp, block);
	if (!sinumerik_open_place_check(interp, column, "tool radius compensation"))
		return false;
	sinumerik->open.on = interp->comp.keeps_loose = false;
	return switch_on(interp, column, code[SINUMERIK_CUTTER] == G41 ? 1 : -1);
}

bool sinumerik_comp_stop(struct interp *interp, int column, bool ends)
{
	struct cutter_comp *comp = &interp->comp;

	if (comp->side == 0 || comp->queue.count == 0)
		return true;
	if (comp->starting || !ends)
		return fault(&interp->at, column,
			     "the program stops under cutter compensation: controls differ in where the tool waits; "
			     "write G40 first");
	return comp_send_to(interp, comp->current);
}
