#include "gcode/travel.h"

#include <limits.h>
#include <math.h>

#include "base/units.h"
#include "gcode/arc.h"
#include "gcode/target.h"
#include "gcode/tooling.h"

/* mm and radians: ends of an arc that are so close are the same point, and the arc a full circle. */
#define SAME_POINT 1e-9
/* LinuxCNC's min_arc_angle (emccanon.cc). */
#define SAME_ANGLE 1e-12

bool travel_emit(struct interp *interp, const struct canon_move *move)
{
	const struct state *state = &interp->state;
	struct canon_move full = *move;

	full.line = interp->at.line;
	full.number = ++interp->moves;
	full.tcp = state->tcp != TCP_OFF;
	full.blend = state->blend;
	full.blend_tolerance = state->blend_tolerance;
	return interp->sink->move(interp->sink->context, &full);
}

/* Goes there, and emits the move that its end completes. */
static bool go(struct interp *interp, const slot_values *target, struct canon_move *move)
{
	struct state *state = &interp->state;

	for (int slot = 0; slot < SLOT_COUNT; slot++) {
		double here = state->position.v[slot], there = target->v[slot];

		if (here < there || here > there)
			state_set_position(state, slot, there);
	}
	move->end = state->canonical;
	return travel_emit(interp, move);
}

static bool go_rapid(struct interp *interp, const slot_values *target)
{
	return go(interp, target, &(struct canon_move){.kind = CANON_RAPID});
}

/*
 * Milliseconds without a decimal point, in P only, on Fanuc and Haas controls
 * (Haas mill operator's manual, "G04 Dwell"); LinuxCNC's P is in seconds.
 */
bool travel_dwell(struct interp *interp)
{
	const struct block *block = &interp->block;
	char letter = block_has(block, 'P') ? 'P' : block_has(block, 'X') ? 'X' : 'U';
	double seconds = block_value(block, letter);

	if (seconds < 0)
		return fault(&interp->at, block_column(block, letter), "a dwell cannot be negative");
	if (interp->config->dialect != GCODE_LINUXCNC && letter == 'P' && !(block->points & letter_bit('P')))
		seconds /= 1000;
	return travel_emit(interp, &(struct canon_move){.kind = CANON_DWELL, .seconds = seconds});
}

/* To the reference position with the axes that the block names, or all. */
static bool go_home(struct interp *interp, int index)
{
	const struct block *block = &interp->block;
	struct state *state = &interp->state;
	slot_values target = state->position;
	bool all = !(block->letters & AXIS_BITS);

	for (int slot = 0; slot < SLOT_COUNT; slot++) {
		if (!interp->config->has_axis[slot] || !(all || block_has(block, AXIS_LETTERS[slot])))
			continue;
		if (!target_absolute(interp, slot, state->reference[index].v[slot], 0, block->g_column[G_NONMODAL],
				     &target.v[slot]))
			return false;
	}
	return go_rapid(interp, &target);
}

/* LinuxCNC's manual, "G28, G28.1": by way of the point that the axis words name, which is a rapid of its own. */
bool travel_reference(struct interp *interp)
{
	const struct block *block = &interp->block;
	int column = block->g_column[G_NONMODAL], index = block->g[G_NONMODAL] == G30;
	enum tcp_source source;
	slot_values target;

	if (block->letters & AXIS_BITS) {
		if (!target_find(interp, false, &target) || !go_rapid(interp, &target))
			return false;
	}
	return tooling_suspend_tcp(interp, column, &source) && go_home(interp, index) &&
	       tooling_resume_tcp(interp, column, source);
}

bool travel_remember(struct interp *interp)
{
	const struct block *block = &interp->block;
	int column = block->g_column[G_NONMODAL], index = block->g[G_NONMODAL] == G30_1;
	enum tcp_source source;

	if (!tooling_suspend_tcp(interp, column, &source))
		return false;
	interp->state.reference[index] = interp->state.position;
	/* LinuxCNC keeps the reference of a wrapped axis within one turn. */
	for (int slot = SLOT_A; slot <= SLOT_C; slot++) {
		double *angle = &interp->state.reference[index].v[slot];

		if (interp->config->wrap[slot] != GCODE_WRAP_NONE)
			*angle -= 360 * floor(*angle / 360);
	}
	return tooling_resume_tcp(interp, column, source);
}

/* LinuxCNC's manual, "Feed Rate" and "G93, G94, G95". */
static bool find_feed(struct interp *interp, struct canon_feed *feed)
{
	const struct block *block = &interp->block;
	const struct state *state = &interp->state;
	int column = block_motion_column(block), code = block->motion / 10;
	double per_second = 1 / SECONDS_PER_MINUTE;

	*feed = (struct canon_feed){0};
	if (state->feed_mode == FEED_INVERSE_TIME) {
		if (!block_has(block, 'F'))
			return fault(&interp->at, column, "G%d without F in inverse time mode (G93)", code);
		feed->inverse_time = true;
		feed->seconds = SECONDS_PER_MINUTE / block_value(block, 'F');
		if (!(block_value(block, 'F') > 0) || !isfinite(feed->seconds))
			return fault(&interp->at, block_column(block, 'F'),
				     "F must be greater than 0 in inverse time mode (G93)");
		return true;
	}
	if (!(state->feed_linear > 0))
		return fault(&interp->at, column, "G%d without a feed rate (F)", code);
	if (state->feed_mode == FEED_PER_REVOLUTION) {
		if (!(state->speed > 0))
			return fault(&interp->at, column,
				     "G%d in feed per revolution (G95) without a spindle speed (S)", code);
		per_second *= state->speed;
	}
	feed->linear = state->feed_linear * per_second;
	feed->angular = radians(state->feed_angular) * per_second;
	return true;
}

/* G53 suspends work offsets, length compensation and TCP for one block. */
static bool go_straight(struct interp *interp, bool machine)
{
	const struct block *block = &interp->block;
	struct canon_move move = {.kind = block->motion == G0 ? CANON_RAPID : CANON_FEED};
	enum tcp_source source = TCP_OFF;
	slot_values target;
	int column;

	/* Fanuc 30i-B operator's manual, "Machine coordinate system (G53)": always at the rapid rate. */
	if (machine && interp->config->dialect == GCODE_FANUC)
		move.kind = CANON_RAPID;
	/* Only LinuxCNC minds a G1 without a feed that moves nothing. */
	if (move.kind == CANON_FEED && !(block->letters & AXIS_BITS) && interp->config->dialect != GCODE_LINUXCNC)
		return true;
	if (move.kind == CANON_FEED && !find_feed(interp, &move.feed))
		return false;
	if (!machine)
		return target_find(interp, false, &target) && go(interp, &target, &move);
	column = block->g_column[G_NONMODAL];
	return tooling_suspend_tcp(interp, column, &source) && target_find(interp, true, &target) &&
	       go(interp, &target, &move) && tooling_resume_tcp(interp, column, source);
}

/* The axes of an arc's plane, and the letters of its centre. */
struct arc_plane {
	int code;
	enum axis_slot a, b;
	char centre_a, centre_b, not_used;
	vec3 normal;
};

static const struct arc_plane *find_plane(int code)
{
	static const struct arc_plane planes[] = {{G17, SLOT_X, SLOT_Y, 'I', 'J', 'K', {0, 0, 1}},
						  {G18, SLOT_Z, SLOT_X, 'K', 'I', 'J', {0, 1, 0}},
						  {G19, SLOT_Y, SLOT_Z, 'J', 'K', 'I', {1, 0, 0}}};

	return &planes[code == G17 ? 0 : code == G18 ? 1 : 2];
}

/* One coordinate of the centre: as an offset from the start (G91.1), or in program coordinates (G90.1). */
static bool centre_word(struct interp *interp, char letter, enum axis_slot slot, double *value)
{
	const struct block *block = &interp->block;
	const struct state *state = &interp->state;

	if (state->arc_absolute && !block_has(block, letter))
		return fault(&interp->at, block_motion_column(block),
			     "an arc with an absolute centre (G90.1) needs both its words; %c is missing", letter);
	*value = block_has(block, letter) ? block_value(block, letter) * state->scale : 0;
	*value += state->arc_absolute ? state->offset.v[slot] : state->position.v[slot];
	return true;
}

static bool find_arc_by_centre(struct interp *interp, const struct arc_plane *plane, struct plane_point start,
			       struct plane_point end, struct plane_point *centre)
{
	const struct state *state = &interp->state;
	const struct arc_tolerance *tolerance = state->scale > 1 ? &arc_tolerance_inch : &arc_tolerance_mm;
	int column = block_motion_column(&interp->block);
	double r0, r1;

	if (block_has(&interp->block, plane->not_used))
		return fault(&interp->at, block_column(&interp->block, plane->not_used),
			     "%c does not belong to the centre of an arc in the plane of G%d", plane->not_used,
			     plane->code / 10);
	if (!centre_word(interp, plane->centre_a, plane->a, &centre->a) ||
	    !centre_word(interp, plane->centre_b, plane->b, &centre->b))
		return false;
	switch (arc_check_centre(start, end, *centre, tolerance, &r0, &r1)) {
	case ARC_ZERO_RADIUS:
		return fault(&interp->at, column, "an arc of radius 0: %.6g mm at its start, %.6g mm at its end", r0,
			     r1);
	case ARC_RADII_DIFFER:
		return fault(&interp->at, column,
			     "the radius of the arc is %.6g mm at its start and %.6g mm at its end", r0, r1);
	default:
		return true;
	}
}

static bool find_arc_by_radius(struct interp *interp, const struct arc_plane *plane, struct plane_point start,
			       struct plane_point end, struct plane_point *centre)
{
	const struct block *block = &interp->block;
	const struct arc_tolerance *tolerance = interp->state.scale > 1 ? &arc_tolerance_inch : &arc_tolerance_mm;
	double radius = block_value(block, 'R') * interp->state.scale;
	int column = block_column(block, 'R');
	char a = AXIS_LETTERS[plane->a], b = AXIS_LETTERS[plane->b];

	if (block->letters & (letter_bit('I') | letter_bit('J') | letter_bit('K')))
		return fault(&interp->at, column, "an arc has a radius (R) or a centre (I, J, K), not both");
	if (!block_has(block, a) && !block_has(block, b))
		return fault(&interp->at, column, "an arc by its radius needs %c or %c", a, b);
	switch (arc_find_centre(start, end, radius, block->motion == G2, tolerance, centre)) {
	case ARC_NO_CHORD:
		return fault(&interp->at, column, "an arc by its radius (R) cannot end where it starts");
	case ARC_RADIUS_TOO_SMALL:
		return fault(&interp->at, column,
			     "a radius of %.6g mm does not reach from the start of the arc to its end", fabs(radius));
	default:
		return true;
	}
}

static vec3 centre_in_space(const struct state *state, const struct arc_plane *plane, struct plane_point centre)
{
	double xyz[3] = {state->position.v[SLOT_X], state->position.v[SLOT_Y], state->position.v[SLOT_Z]};

	xyz[plane->a] = centre.a;
	xyz[plane->b] = centre.b;
	return (vec3){xyz[0], xyz[1], xyz[2]};
}

/* LinuxCNC's manual, "G2, G3 Arc Move". */
static bool go_arc(struct interp *interp)
{
	const struct block *block = &interp->block;
	const struct state *state = &interp->state;
	const struct arc_plane *plane = find_plane(state->plane);
	const uint32_t offsets = letter_bit('I') | letter_bit('J') | letter_bit('K');
	const bool *has_axis = interp->config->has_axis;
	struct canon_move move = {.kind = CANON_ARC};
	struct plane_point start, end, centre;
	slot_values target;
	int turns = 1;

	if (!has_axis[plane->a] || !has_axis[plane->b])
		return fault(&interp->at, block_motion_column(block),
			     "the machine has no %c axis, which an arc in the plane of G%d needs",
			     AXIS_LETTERS[has_axis[plane->a] ? plane->b : plane->a], plane->code / 10);
	if (!block_has(block, 'R') && !(block->letters & offsets))
		return fault(&interp->at, block_motion_column(block),
			     "an arc needs a centre (I, J, K) or a radius (R)");
	if (!find_feed(interp, &move.feed) || !target_find(interp, false, &target))
		return false;
	/* A G64 in the block claims P as well; LinuxCNC gives it to both. */
	if (block_has(block, 'P') && !block_integer(block, &interp->at, 'P', 1, INT_MAX, &turns))
		return false;
	start = (struct plane_point){state->position.v[plane->a], state->position.v[plane->b]};
	end = (struct plane_point){target.v[plane->a], target.v[plane->b]};
	if (block_has(block, 'R') ? !find_arc_by_radius(interp, plane, start, end, &centre)
				  : !find_arc_by_centre(interp, plane, start, end, &centre))
		return false;
	move.arc.centre = centre_in_space(state, plane, centre);
	move.arc.normal = plane->normal;
	move.arc.sweep = arc_sweep(start, end, centre, block->motion == G2, turns,
				   fmax(SAME_ANGLE, SAME_POINT / hypot(start.a - centre.a, start.b - centre.b)));
	return go(interp, &target, &move);
}

bool travel_motion(struct interp *interp)
{
	const struct block *block = &interp->block;

	switch (block->motion) {
	case CODE_NONE:
		return true;
	case G80:
		interp->state.motion = CODE_NONE;
		return true;
	case G0:
	case G1:
		interp->state.motion = block->motion;
		return go_straight(interp, block->g[G_NONMODAL] == G53);
	default:
		interp->state.motion = block->motion;
		return go_arc(interp);
	}
}
