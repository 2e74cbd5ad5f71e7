#include "gcode/execute/coordinate_rotation.h"

#include <math.h>

#include "base/same_double.h"
#include "base/units.h"
#include "gcode/execute/coordinate_conversion.h"
#include "gcode/execute/mirror_image.h"
#include "gcode/execute/motion_commands.h"
#include "gcode/execute/rotated_frame.h"
#include "gcode/execute/scaling.h"
#include "gcode/execute/tilted_plane.h"
#include "gcode/execute/tool_length.h"
#include "geom/tolerance.h"

static vec3 plane_normal(int plane)
{
	return plane == G17 ? (vec3){0, 0, 1} : plane == G18 ? (vec3){0, 1, 0} : (vec3){1, 0, 0};
}

static int across_of(int plane)
{
	return plane == G17 ? SLOT_Z : plane == G18 ? SLOT_Y : SLOT_X;
}

/* The centre is given by words; without words it is the present position of the tool. */
static bool find_centre(struct interp *interp, vec3 *centre)
{
	const struct state *state = &interp->state;
	int across = across_of(state->plane);
	double at[3];
	int words = 0;

	for (int slot = SLOT_X; slot < SLOT_COUNT; slot++) {
		bool given = block_has(&interp->block, AXIS_LETTERS[slot]);

		if (given && (slot > SLOT_Z || slot == across))
			return fault(&interp->at, block_column(&interp->block, AXIS_LETTERS[slot]),
				     "%c does not belong to the centre of G68 in the plane of G%d", AXIS_LETTERS[slot],
				     state->plane / 10);
		words += given;
		if (slot <= SLOT_Z)
			at[slot] = given ? block_value(&interp->block, AXIS_LETTERS[slot]) * state->scale
					 : state->position.v[slot] - state->offset.v[slot];
	}
	*centre = (vec3){at[0], at[1], at[2]};
	if (words != 1)
		return true;
	return fault(&interp->at, interp->block.g_column[G_ROTATION],
		     "G68 needs both words of its centre, or none for the present position");
}

/*
 * Fanuc 30i-B operator's manual (B-64484EN), coordinate system rotation (G68, G69); Haas mill operator's manual, "G68
 * Rotation": a rotation by R degrees about a centre in the plane, counter-clockwise.
 */
static bool turn_in_plane(struct interp *interp)
{
	struct state *state = &interp->state;
	int column = interp->block.g_column[G_ROTATION];
	struct rotated_frame frame = {.on = true};
	slot_values before = state->position;
	vec3 centre = {0, 0, 0};

	if (state->tcp != TCP_OFF)
		return fault(&interp->at, column,
			     "G68 under tool centre point control; cancel tool centre point control first");
	if (coordinate_conversion_is(&interp->block) && traits_of(interp)->g68_in_space != ANSWER_YES)
		return fault(&interp->at, column,
			     "G68 with I, J, K: this control has no three-dimensional coordinate conversion");
	if (coordinate_conversion_is(&interp->block))
		return coordinate_conversion_turn(interp);
	if (!block_has(&interp->block, 'R'))
		return fault(&interp->at, column,
			     "G68 needs R (angle); without R, the control takes the angle from a parameter or setting");
	if (!find_centre(interp, &centre))
		return false;
	frame.turn = mat3_turn(plane_normal(state->plane), radians(block_value(&interp->block, 'R')));
	frame.origin = vec3_sub(centre, mat3_apply(&frame.turn, centre));
	state->frame = frame;
	rotated_frame_mark_unsure(state, &before, G68);
	return true;
}

/* Fanuc 30i-B operator's manual, tilted working plane indexing: G68.2, and G68.4 relative to the active plane. */
static bool tilt(struct interp *interp)
{
	struct state *state = &interp->state;
	const struct block *block = &interp->block;
	struct rotated_frame frame = {.on = true, .waits_for_tool = true};
	bool complete = false;

	if (state->tcp != TCP_OFF)
		return fault(&interp->at, block->g_column[G_ROTATION],
			     "G68.2 under tool centre point control; cancel tool centre point control first");
	for (int slot = SLOT_A; slot < SLOT_COUNT; slot++) {
		if (block_has(block, AXIS_LETTERS[slot]))
			return fault(&interp->at, block_column(block, AXIS_LETTERS[slot]),
				     "%c does not belong to G68.2, whose origin is given by X, Y and Z",
				     AXIS_LETTERS[slot]);
	}
	if (!tilted_plane_take(interp, &complete, &frame.turn, &frame.origin))
		return false;
	if (complete && block->g[G_ROTATION] == G68_4) {
		frame.origin = vec3_add(state->frame.origin, mat3_apply(&state->frame.turn, frame.origin));
		frame.turn = mat3_mul(&state->frame.turn, &frame.turn);
	}
	if (complete)
		state->frame = frame;
	return true;
}

static bool turn_back(struct interp *interp)
{
	struct state *state = &interp->state;
	slot_values before = rotated_frame_straight(state);

	state->frame = (struct rotated_frame){0};
	state->cycle.turned = true;
	if (state->tcp == TCP_BY_PLANE && !tool_length_switch_tcp(interp, interp->block.g_column[G_ROTATION], TCP_OFF))
		return false;
	rotated_frame_mark_unsure(state, &before, G69);
	return true;
}

/* After G68, a single absolute word does not determine whether the other coordinate counts as turned. */
static bool check_both_words(struct interp *interp)
{
	const struct state *state = &interp->state;
	const struct block *block = &interp->block;
	int across = across_of(state->plane);

	for (int slot = SLOT_X; slot <= SLOT_Z; slot++) {
		int other = SLOT_X + SLOT_Y + SLOT_Z - across - slot;

		if (slot == across || !block_has(block, AXIS_LETTERS[slot]) || block_has(block, AXIS_LETTERS[other]) ||
		    !state->unsure[other])
			continue;
		return fault(&interp->at, block_column(block, AXIS_LETTERS[slot]),
			     "%c without %c in the first absolute move after G68: controls differ in whether %c keeps "
			     "its programmed or its rotated coordinate; write both",
			     AXIS_LETTERS[slot], AXIS_LETTERS[other], AXIS_LETTERS[other]);
	}
	return true;
}

/*
 * Fanuc 16-C operator's manual (B-62764EN), "Coordinate system rotation": the
 * first move after G69 must be absolute. After G68 increments are turned about
 * the tool (15i, B-63324EN, the same section).
 */
bool coordinate_rotation_check_words(struct interp *interp, bool machine)
{
	struct state *state = &interp->state;
	const struct block *block = &interp->block;
	bool absolute = machine || !state->incremental, left = false;

	if (state->unsure_code == CODE_NONE)
		return true;
	if (state->unsure_code == G68 && !machine && !coordinate_conversion_check_words(interp, absolute))
		return false;
	if (state->unsure_code == G68 && absolute && !machine && !check_both_words(interp))
		return false;
	for (int slot = 0; slot < SLOT_COUNT; slot++) {
		bool named = block_has(block, AXIS_LETTERS[slot]);
		double value = named ? block_value(block, AXIS_LETTERS[slot]) : 0;

		if (state->unsure[slot] && state->unsure_code != G68 && !absolute && !same_double(value, 0))
			return fault(&interp->at, block_column(block, AXIS_LETTERS[slot]),
				     "increment in %c after G%g: the first move must be absolute",
				     AXIS_LETTERS[slot], state->unsure_code / 10.0);
		state->unsure[slot] = state->unsure[slot] && !(named && absolute);
		left = left || state->unsure[slot];
	}
	if (!left)
		state->unsure_code = CODE_NONE;
	return true;
}

bool coordinate_rotation_turn(struct interp *interp)
{
	struct state *state = &interp->state;
	int code = interp->block.g[G_ROTATION], column = interp->block.g_column[G_ROTATION];

	if (code == CODE_NONE || code == G69)
		return true;
	state->cycle.turned = true;
	if (code == G68_4 && !(state->frame.on && state->frame.waits_for_tool))
		return fault(&interp->at, column, "G68.4 needs an active G68.2 that is not followed by G53.1");
	if (state->frame.on && code != G68_4 && !coordinate_conversion_goes_on(interp))
		return fault(&interp->at, column, "the coordinates are already rotated; cancel this by G69 first");
	/* In G91, parameters decide whether R adds to the former angle and whether X Y Z are relative to the tool. */
	if (state->incremental)
		return fault(&interp->at, column, "%s in incremental mode (G91) is not supported",
			     code == G68 ? "G68" : "G68.2");
	return code == G68 ? turn_in_plane(interp) : tilt(interp);
}

/* G53.6: TCP keeps the tool's tip at its place on the workpiece while the rotary axes turn. */
static bool turn_about_tip(struct interp *interp, int column, slot_values target)
{
	struct state *state = &interp->state;
	struct canon_move move = {.kind = CANON_RAPID};

	if (state->length_code != G43 || state->length_doubt != CODE_NONE)
		return fault(&interp->at, column,
			     "G53.6 needs a tool length, because it keeps the tool tip in place; write G43 first");
	if (!tool_length_switch_tcp(interp, column, TCP_BY_LENGTH))
		return false;
	for (int slot = SLOT_X; slot <= SLOT_Z; slot++)
		target.v[slot] = state->position.v[slot];
	return motion_commands_go(interp, &target, &move);
}

/* P selects the solution. If the axes can reach only one solution, P is not needed. */
static bool check_choice(struct interp *interp, const struct kinematics_orientation *orientation)
{
	const int column = block_has(&interp->block, 'P') ? block_column(&interp->block, 'P') : 0;
	struct kinematics_solutions solutions = {.count = 0};
	int reached = 0;
	bool free = false;

	if (column == 0)
		return true;
	if (!interp->kinematics->orientations(interp->kinematics->context, line_loc(&interp->at, column), orientation,
					      &solutions))
		return false;
	for (size_t i = 0; i < solutions.count; i++) {
		reached += solutions.items[i].within_limits;
		for (int slot = SLOT_A; slot <= SLOT_C; slot++)
			free = free || solutions.items[i].free[slot];
	}
	return (reached < 2 && !free) ||
	       fault(&interp->at, column,
		     "P of %s, which selects one of several positions of the rotary axes, is not supported: remove P, "
		     "and turn the axes towards the intended position in a block before",
		     orientation->command);
}

/*
 * Fanuc 30i-B operator's manual (B-64484EN), tool axis direction control (G53.1): the rotary axes turn at the rapid
 * rate while the linear axes stand still, or, with G53.6, while the tip stands still. From then on coordinates are
 * those of the tool point on the workpiece, which may have turned with its table.
 */
bool coordinate_rotation_orient_tool(struct interp *interp)
{
	struct state *state = &interp->state;
	const struct block *block = &interp->block;
	int column = block->g_column[G_NONMODAL];
	bool keeps_tip = block->g[G_NONMODAL] == G53_6, good;
	const char *name = keeps_tip ? "G53.6" : "G53.1";
	struct kinematics_orientation orientation = {.rotary = state->canonical, .command = name};
	slot_values target = state->position;

	if (!state->frame.on || !state->frame.waits_for_tool)
		return fault(&interp->at, column, "%s needs a plane of G68.2 directly before it", name);
	orientation.direction = mat3_apply(&state->frame.turn, (vec3){0, 0, 1});
	orientation.rotary_zero = tool_length_rotary_zero(interp);
	if (!check_choice(interp, &orientation))
		return false;
	if (!interp->kinematics->orient(interp->kinematics->context, line_loc(&interp->at, column), &orientation))
		return false;
	for (int slot = SLOT_A; slot <= SLOT_C; slot++) {
		if (interp->config->has_axis[slot])
			target.v[slot] = state_from_canonical(slot, orientation.rotary.v[slot]);
	}
	/* The target is a position of the machine's axes. */
	state->frame.on = false;
	good = keeps_tip ? turn_about_tip(interp, column, target)
			 : motion_commands_go(interp, &target, &(struct canon_move){.kind = CANON_RAPID});
	state->frame.on = true;
	state->frame.waits_for_tool = false;
	return good && tool_length_switch_tcp(interp, column, TCP_BY_PLANE);
}

static bool changes_offsets(const struct block *block)
{
	int code = block->g[G_NONMODAL];

	return code == G10 || code == G52 || code == G92 || block->g[G_SYSTEM] != CODE_NONE;
}

/* G28, G30, G53 while G68 is active: the rotation has no effect on the axis perpendicular to the plane. */
static bool check_by_machine(struct interp *interp)
{
	const struct block *block = &interp->block;
	int code = block->g[G_NONMODAL], across = across_of(interp->state.plane);

	if (code != G28 && code != G30 && code != G53)
		return true;
	if (!is_answered(interp, block->g_column[G_NONMODAL], traits_of(interp)->turned_by_machine,
			 "where G28, G30 and G53 move while G68 is active"))
		return false;
	if (traits_of(interp)->turned_by_machine == TURNED_BY_MACHINE_REFUSED)
		return fault(&interp->at, block->g_column[G_NONMODAL], "G%d while G68 is active; write G69 first",
			     code / 10);
	for (int slot = SLOT_X; slot <= SLOT_Z; slot++) {
		if (slot != across &&
		    (block_has(block, AXIS_LETTERS[slot]) || (code != G53 && !(block->letters & AXIS_BITS))))
			return fault(&interp->at, block->g_column[G_NONMODAL],
				     "G%d with %c while G68 is active: controls differ in whether the path and the "
				     "coordinates after it are rotated; write G69 first",
				     code / 10, AXIS_LETTERS[slot]);
	}
	return true;
}

bool coordinate_rotation_start_block(struct interp *interp)
{
	const struct rotated_frame *frame = &interp->state.frame;
	const struct block *block = &interp->block;
	const bool tilted = interp->state.tcp == TCP_BY_PLANE || frame->waits_for_tool;
	const char *name = tilted ? "G68.2" : "G68";
	int column = block->g_column[G_NONMODAL];

	if (!tilted_plane_check_block(interp))
		return false;
	if (!frame->on)
		return true;
	if (frame->distorts)
		return frame->scales ? scaling_start_block(interp) : mirror_image_start_block(interp);
	if (block->g[G_ROTATION] == G69)
		return turn_back(interp);
	if (changes_offsets(block))
		return fault(&interp->at, block->g[G_SYSTEM] != CODE_NONE ? block->g_column[G_SYSTEM] : column,
			     "a change of offsets while %s is active is not supported; write G69 first", name);
	if (block->g[G_LENGTH] == G43_4 || block->g[G_LENGTH] == G43_5 || block->g[G_LENGTH] == G234)
		return fault(&interp->at, block->g_column[G_LENGTH],
			     "G%g (tool centre point control) while %s is active is not supported; %swrite G69 first",
			     block->g[G_LENGTH] / 10.0, name,
			     tilted ? "for moves without rotary axes write G43 instead, else " : "");
	if (block->m[M_TCP] == MCODE_TCP_ON || (block->m[M_TCP] != CODE_NONE && interp->state.tcp == TCP_BY_PLANE))
		return fault(&interp->at, block->m_column[M_TCP],
			     "tool centre point control while %s is active; write G69 first", name);
	if (!tilted) {
		if (!check_by_machine(interp))
			return false;
		if (block->g[G_PLANE] != CODE_NONE && block->g[G_PLANE] != interp->state.plane)
			return fault(&interp->at, block->g_column[G_PLANE],
				     "a change of the plane while G68 is active; write G69 first");
		return true;
	}
	for (int slot = SLOT_A; slot <= SLOT_C; slot++) {
		if (block_has(block, AXIS_LETTERS[slot]) && block->g[G_ROTATION] == CODE_NONE)
			return fault(&interp->at, block_column(block, AXIS_LETTERS[slot]),
				     "%c while G68.2 is active: the tool would leave the direction of the tilted plane",
				     AXIS_LETTERS[slot]);
	}
	return true;
}
