#include "gcode/dialect/klartext/moves/klartext_comp.h"

#include <math.h>

#include "base/math/math_functions.h"
#include "base/units.h"
#include "gcode/dialect/klartext/frames/klartext_frame.h"
#include "gcode/execute/cutter_comp/comp_lookahead.h"
#include "gcode/execute/cutter_comp/comp_moves.h"
#include "gcode/execute/motion_commands.h"
#include "gcode/execute/rotated_frame.h"
#include "geom/tolerance.h"

/* ------------------------------------------------------------------- radius */

/* "Tool radius compensation": R of the tool, with DR of TOOL CALL. */
static bool find_radius(struct interp *interp, int column, double *radius)
{
	const struct klartext *klartext = klartext_of(interp);
	const int number = interp->state.tool;
	const struct tool *tool = tool_table_find(&interp->tools, number);

	if (number == 0)
		return fault(&interp->at, column, "radius compensation without a tool: TOOL CALL comes first");
	if (!tool || !(tool->diameter > 0))
		return fault(&interp->at, column,
			     "the radius of T%d is not known, or 0: give the tool of the setup a <cutter>, or "
			     "diameter=\"\"",
			     number);
	if (tool != interp->config->any_tool && klartext->tool.defined == number &&
	    fabs(klartext->tool.defined_radius - tool->diameter / 2) > SAME_POINT)
		return fault(&interp->at, column,
			     "TOOL DEF gives T%d a radius of %.6g mm, and the setup %.6g mm: which of them the "
			     "control takes depends on whether its tool table is active; make them agree, or set "
			     "tool_def=\"ignored\" in the machine file's <controller> if the table counts",
			     number, klartext->tool.defined_radius, tool->diameter / 2);
	*radius = tool->diameter / 2 + klartext->tool.delta_radius;
	return *radius >= 0 || fault(&interp->at, column,
				     "the radius of T%d with DR is %.6g mm: compensation by a negative radius is not "
				     "supported",
				     number, *radius);
}

/* ------------------------------------------------------------------- frame */

/* While radius compensation is on, the engine converts its moves to the active coordinates. */
static void enter_frame(struct interp *interp)
{
	const struct klartext_frame *frame = &klartext_of(interp)->frame;
	const bool mirrored = (frame->mirror[0] + frame->mirror[1] + frame->mirror[2]) % 2 == 1;
	const mat3 *turn = &frame->turn;
	struct rotated_frame *rotated = &interp->state.frame;

	*rotated = (struct rotated_frame){.on = frame->any};
	if (!frame->any)
		return;
	rotated->turn = *turn;
	rotated->back = (mat3){
	    {turn->x.x, turn->y.x, turn->z.x}, {turn->x.y, turn->y.y, turn->z.y}, {turn->x.z, turn->y.z, turn->z.z}};
	rotated->distorts = rotated->mirrors = mirrored;
	rotated->growth = 1;
	rotated->origin = frame->origin;
}

static void leave(struct interp *interp)
{
	interp->comp.side = 0;
	interp->comp.entered = interp->comp.leaving = interp->comp.starting = false;
	klartext_of(interp)->crossing.looks_ahead = false;
	interp->state.frame = (struct rotated_frame){.on = false};
}

/* ------------------------------------------------------------------ switching */

static bool moves_in_plane(const struct klartext_path *path)
{
	return path->arc || math_hypot(path->end.x - path->start.x, path->end.y - path->start.y) >= SAME_POINT;
}

static bool check_start(struct interp *interp, int column)
{
	const struct klartext *klartext = klartext_of(interp);
	const struct klartext_frame *frame = &klartext->frame;

	if (interp->state.tcp == TCP_BY_MCODE)
		return fault(&interp->at, column,
			     "radius compensation while M128 is in force is not supported; post the path of the tool's "
			     "centre with R0");
	if (klartext->crossing.looks_ahead)
		return fault(
		    &interp->at, column,
		    "radius compensation with M120: it leaves out what the tool cannot reach, which is not supported; "
		    "post the path of the tool's centre with R0");
	if (klartext->stay.waits)
		return fault(&interp->at, column,
			     "radius compensation before the rotary axes stand where PLANE ... STAY needs them");
	if (fabs(frame->scale.x - 1) + fabs(frame->scale.y - 1) > 0)
		return fault(&interp->at, column,
			     "radius compensation while a scaling is in force is not supported");
	return true;
}

static void begin(struct interp *interp, int side, double radius)
{
	comp_lookahead_begin(&interp->comp, side, radius);
	interp->comp.start_type = COMP_START_A;
	interp->comp.corner_form = COMP_CORNER_CIRCULAR;
	klartext_of(interp)->crossing.open = klartext_of(interp)->open.aside = false;
	enter_frame(interp);
}

static int side_of(enum klartext_comp comp)
{
	return comp == KLARTEXT_RL ? 1 : comp == KLARTEXT_RR ? -1 : 0;
}

/*
 * "Tool radius compensation" (iTNC 530 user's manual): the first block ends beside the start of the next one,
 * perpendicular to its direction; outside corners are rounded; at inside corners the two paths intersect.
 */
static bool start(struct interp *interp, const struct klartext_words *words, const struct klartext_path *path)
{
	int column = words->comp_column;
	double radius = 0;

	if (!check_start(interp, column) || !find_radius(interp, column, &radius) ||
	    (klartext_of(interp)->open.height && !klartext_comp_check_known(interp, column, "radius compensation")))
		return false;
	/* Without a radius there is no compensation, until a TOOL CALL gives one. */
	klartext_of(interp)->crossing.on_path = !(radius > 0);
	if (!(radius > 0))
		return true;
	if (path->arc || !moves_in_plane(path))
		return fault(&interp->at, column,
			     "radius compensation starts in a straight line that moves in the plane of X and Y");
	begin(interp, side_of(words->comp), radius);
	return true;
}

bool klartext_comp_begin(struct interp *interp, enum klartext_comp comp, int column)
{
	double radius = 0;

	if (!check_start(interp, column) || !find_radius(interp, column, &radius))
		return false;
	if (!(radius > 0))
		return fault(&interp->at, column, "APPR with a tool of radius 0 is not supported");
	begin(interp, side_of(comp), radius);
	return true;
}

/*
 * R0 in a block without a move in the plane: the tool's centre goes to the programmed point now or with the next move.
 */
static bool stop_standing(struct interp *interp, int column)
{
	struct cutter_comp *comp = &interp->comp;
	bool turned = interp->state.frame.on;

	if (comp->starting)
		return fault(&interp->at, column,
			     "R0 right behind the first block of radius compensation is not supported");
	block_clear(&interp->block);
	if (cutter_comp_is_on(interp) && comp->entered) {
		if (!comp_lookahead_stop(interp))
			return false;
		comp->loose[SLOT_Z] = turned ? comp->radius : 0;
	}
	leave(interp);
	return true;
}

bool klartext_comp_leave_standing(struct interp *interp, int column)
{
	const struct plane_point centre = interp->comp.current;
	slot_values here = rotated_frame_straight(&interp->state);

	if (interp->comp.starting)
		return fault(&interp->at, column,
			     "DEP right behind the first block of radius compensation is not supported");
	if (!comp_send_to(interp, centre))
		return false;
	here.v[SLOT_X] = centre.a;
	here.v[SLOT_Y] = centre.b;
	comp_arrive(interp, &here, centre);
	leave(interp);
	klartext_of(interp)->programmed = klartext_frame_point(interp);
	return true;
}

bool klartext_comp_leave(struct interp *interp, const struct klartext_path *path, int column)
{
	struct cutter_comp *comp = &interp->comp;

	if (comp->starting || !moves_in_plane(path))
		return fault(&interp->at, column,
			     "DEP right behind the first block of radius compensation is not supported");
	comp->leaving = true;
	return true;
}

static bool stop(struct interp *interp, const struct klartext_words *words, const struct klartext_path *path)
{
	struct cutter_comp *comp = &interp->comp;

	if (!comp->entered || !cutter_comp_is_on(interp)) {
		leave(interp);
		return true;
	}
	if (path->arc)
		return fault(&interp->at, words->comp_column,
			     "radius compensation ends in a straight line, not in a circle");
	if (!moves_in_plane(path))
		return stop_standing(interp, words->comp_column);
	if (comp->starting)
		return fault(&interp->at, words->comp_column,
			     "R0 right behind the first block of radius compensation is not supported");
	comp->leaving = true;
	return true;
}

static bool check_side(struct interp *interp, const struct klartext_words *words)
{
	return interp->comp.side == side_of(words->comp) ||
	       fault(&interp->at, words->comp_column,
		     "%s while the tool is on the other side of the path: the manual wants a block with R0 between",
		     words->comp == KLARTEXT_RL ? "RL" : "RR");
}

/* Does the block begin, change or end radius compensation? R0 also ends a path that began with a radius of 0. */
static bool switches(struct interp *interp, const struct klartext_words *words)
{
	if (words->comp == KLARTEXT_R0)
		klartext_of(interp)->crossing.on_path = false;
	return words->comp != KLARTEXT_R_NONE && (words->comp != KLARTEXT_R0 || klartext_comp_is_selected(interp));
}

bool klartext_comp_switch(struct interp *interp, const struct klartext_words *words, const struct klartext_path *path)
{
	if (!switches(interp, words))
		return true;
	if (words->comp == KLARTEXT_R0)
		return stop(interp, words, path);
	return klartext_comp_is_selected(interp) ? check_side(interp, words) : start(interp, words, path);
}

bool klartext_comp_switch_standing(struct interp *interp, const struct klartext_words *words)
{
	if (!switches(interp, words))
		return true;
	if (words->comp == KLARTEXT_R0)
		return stop_standing(interp, words->comp_column);
	if (klartext_comp_is_selected(interp))
		return check_side(interp, words);
	return fault(&interp->at, words->comp_column,
		     "radius compensation starts in a straight line that moves in the plane of X and Y");
}

/* -------------------------------------------------------------------- moves */

/* The data of the block for the engine: its motion, and the column for messages. */
static void describe_block(struct interp *interp, const struct klartext_path *path)
{
	struct block *block = &interp->block;

	block_clear(block);
	block->motion = path->arc ? path->sweep > 0 ? G3 : G2 : path->rapid ? G0 : G1;
	block->g[G_MOTION] = block->motion;
	block->g_column[G_MOTION] = path->column;
}

/* "Machining small contour steps: M97": at the end of its block both paths are extended to their intersection. */
static void choose_corner(struct interp *interp, const struct klartext_path *path)
{
	struct klartext_crossing *crossing = &klartext_of(interp)->crossing;

	if (!moves_in_plane(path))
		return;
	interp->comp.corner_form = crossing->open ? COMP_CORNER_CROSSING : COMP_CORNER_CIRCULAR;
	crossing->open = path->crossing;
}

static bool check_arc_plane(struct interp *interp, const struct klartext_path *path)
{
	return !path->arc || fabs(path->normal.z) > 0.5 ||
	       fault(&interp->at, path->column,
		     "a circle outside of the plane of X and Y under radius compensation is not supported");
}

bool klartext_comp_move_bare(struct interp *interp, const struct klartext_path *path)
{
	const double *offset = interp->state.offset.v;
	struct canon_move move = {.kind = path->rapid ? CANON_RAPID : CANON_FEED, .feed = path->feed};
	slot_values straight = interp->state.position;

	straight.v[SLOT_X] = offset[SLOT_X] + path->end.x;
	straight.v[SLOT_Y] = offset[SLOT_Y] + path->end.y;
	straight.v[SLOT_Z] = offset[SLOT_Z] + klartext_of(interp)->frame.scale.z * path->end.z;
	klartext_of(interp)->tool.moved = true;
	return motion_commands_go(interp, &straight, &move);
}

static bool go_beside(struct interp *interp, const struct klartext_target *target, const struct klartext_path *path)
{
	const double *offset = interp->state.offset.v;
	struct canon_move move = {.kind = path->rapid ? CANON_RAPID : CANON_FEED, .feed = path->feed};
	slot_values straight = target->others;
	struct klartext *klartext = klartext_of(interp);
	bool good;

	if (!check_arc_plane(interp, path))
		return false;
	straight.v[SLOT_X] = offset[SLOT_X] + target->point.x;
	straight.v[SLOT_Y] = offset[SLOT_Y] + target->point.y;
	straight.v[SLOT_Z] = offset[SLOT_Z] + klartext->frame.scale.z * target->point.z;
	describe_block(interp, path);
	choose_corner(interp, path);
	klartext->tool.moved = true;
	klartext->programmed = target->point;
	if (path->arc) {
		struct plane_point centre = {offset[SLOT_X] + path->centre.x, offset[SLOT_Y] + path->centre.y};
		int turns = (int)ceil(fabs(path->sweep) / (2 * PI) - 1e-9);

		good = cutter_comp_arc(interp, &straight, centre, turns > 0 ? turns : 1, &move);
	} else {
		good = cutter_comp_line(interp, &straight, &move);
	}
	if (good && !klartext_comp_is_selected(interp))
		leave(interp);
	return good;
}

bool klartext_comp_go(struct interp *interp, const struct klartext_target *target, const struct klartext_path *path)
{
	if (cutter_comp_is_on(interp))
		return go_beside(interp, target, path);
	return path->arc ? klartext_move_arc(interp, target, path)
			 : klartext_move_line(interp, target, path->rapid, &path->feed);
}

void klartext_comp_settle(struct interp *interp, const struct klartext_words *words)
{
	const unsigned plane = 1U << SLOT_X | 1U << SLOT_Y;
	const unsigned given = words->axes & ~words->increments;
	struct klartext *klartext = klartext_of(interp);
	double *loose = interp->comp.loose;

	if (klartext->open.height && given & 1U << SLOT_Z && (!klartext->frame.tilted || (given & plane) == plane)) {
		klartext->open.height = false;
		loose[SLOT_Z] = 0;
	}
	if ((given & plane) == plane && !(klartext->open.height && klartext->frame.tilted)) {
		loose[SLOT_X] = loose[SLOT_Y] = 0;
		loose[SLOT_Z] = klartext->open.height ? loose[SLOT_Z] : 0;
		klartext->open.aside = false;
	}
}

void klartext_comp_turn_open(struct interp *interp)
{
	double *loose = interp->comp.loose;
	const double most = vec3_norm((vec3){loose[SLOT_X], loose[SLOT_Y], loose[SLOT_Z]});

	loose[SLOT_X] = loose[SLOT_Y] = loose[SLOT_Z] = most;
	klartext_of(interp)->open.aside = false;
}

bool klartext_comp_check_known(struct interp *interp, int column, const char *what)
{
	const double *loose = interp->comp.loose;

	if (klartext_of(interp)->open.height)
		return fault(&interp->at, column,
			     "%s while it is not known at which height a cycle has left the tool; move X and Y, and Z "
			     "first",
			     what);
	return !(loose[SLOT_X] + loose[SLOT_Y] > 0) || fault(&interp->at, column,
							     "%s while it is not known where the tool stands in X and "
							     "Y: behind R0 without a move in the plane, DEP, "
							     "or a cycle that mills a pocket; move X and Y first",
							     what);
}

bool klartext_comp_end(struct interp *interp, int column)
{
	struct cutter_comp *comp = &interp->comp;

	if (!klartext_comp_is_selected(interp))
		return true;
	if (comp->starting)
		return fault(&interp->at, column,
			     "the program ends right behind the first block of radius compensation: where the tool is "
			     "then is not known");
	if (comp->queue.count > 0 && !comp_send_to(interp, comp->current))
		return false;
	leave(interp);
	return true;
}
