#include "gcode/dialect/sinumerik/path/sinumerik_orientation.h"

#include <math.h>

#include "base/same_double.h"
#include "base/units.h"
#include "gcode/dialect/sinumerik/frames/sinumerik_frame.h"
#include "gcode/dialect/sinumerik/frames/sinumerik_open_place.h"
#include "gcode/dialect/sinumerik/frames/sinumerik_place_check.h"
#include "gcode/execute/tool_length.h"
#include "geom/tolerance.h"

/* mm: a shorter vector has no direction. */
#define LEAST_VECTOR 1e-9

static bool has_programmable_frame(const struct interp *interp)
{
	if (interp->state.frame.on)
		return true;
	for (int slot = 0; slot < SLOT_COUNT; slot++) {
		if (!same_double(interp->state.shift.v[slot], 0))
			return true;
	}
	return false;
}

static bool has_frames(const struct interp *interp)
{
	const struct state *state = &interp->state;

	if (has_programmable_frame(interp))
		return true;
	for (int slot = 0; slot < SLOT_COUNT; slot++) {
		if (!same_double(state->work[state->system].v[slot], 0))
			return true;
	}
	return false;
}

/* MD10602: TRAORI and TRAFOOF keep the frames and the work offset, or delete them. */
static bool outlive(struct interp *interp, int column)
{
	struct sinumerik *sinumerik = sinumerik_of(interp);
	const enum answer answer = interp->config->controller.frames_outlive_traori;

	if (!has_frames(interp) || answer == ANSWER_YES)
		return true;
	if (answer == ANSWER_UNKNOWN && has_programmable_frame(interp))
		return fault(
		    &interp->at, column,
		    "a parameter of the control (MD10602) decides whether TRANS, ROT and the like outlive TRAORI "
		    "and TRAFOOF: write them behind it, or set frames_outlive_traori=\"yes\" or \"no\" in the "
		    "machine file's <controller>");
	if (answer == ANSWER_UNKNOWN) {
		sinumerik->frames.unsure = true;
		return true;
	}
	sinumerik->frames.programmed = sinumerik_frame_none();
	interp->state.system = SYSTEM_NONE;
	return sinumerik_frame_changed(interp, column);
}

static bool switch_transformation(struct interp *interp, bool on, int column)
{
	struct sinumerik *sinumerik = sinumerik_of(interp);
	struct state *state = &interp->state;

	/* There is no active transformation that TRAFOOF would end. */
	if (sinumerik->frames.swivelled && !on)
		return true;
	if (sinumerik->frames.swivelled)
		return fault(&interp->at, column, "TRAORI while CYCLE800 has swivelled; CYCLE800() first");
	if (on == (state->tcp != TCP_OFF))
		return true;
	if (sinumerik->frames.tool_frame)
		return fault(&interp->at, column, "TRAFOOF while TOROT or TOFRAME is in force; TOROTOF first");
	if (on && !sinumerik_place_check_edge(interp, column))
		return false;
	sinumerik_frame_place(interp);
	sinumerik_open_place_turned(interp);
	if (!tool_length_switch_tcp(interp, column, on ? TCP_BY_LENGTH : TCP_OFF))
		return false;
	return sinumerik_frame_changed(interp, column) && outlive(interp, column);
}

bool sinumerik_orientation_select(struct interp *interp, const struct sinumerik_block *block)
{
	struct sinumerik *sinumerik = sinumerik_of(interp);
	const int *code = block->code;

	if (code[SINUMERIK_ORI_SYSTEM] != CODE_NONE)
		sinumerik->orientation.in_machine = code[SINUMERIK_ORI_SYSTEM] == SINUMERIK_ORIMKS;
	if (code[SINUMERIK_ORI_ANGLES] != CODE_NONE)
		sinumerik->orientation.angles = code[SINUMERIK_ORI_ANGLES];
	if (code[SINUMERIK_ORI_WAY] != CODE_NONE)
		sinumerik->orientation.way =
		    code[SINUMERIK_ORI_WAY] == SINUMERIK_ORIAXES ? SINUMERIK_ORI_AXES : SINUMERIK_ORI_VECTOR;
	return code[SINUMERIK_TRANSFORM] == CODE_NONE ||
	       switch_transformation(interp, code[SINUMERIK_TRANSFORM] == SINUMERIK_TRAORI,
				     block->code_column[SINUMERIK_TRANSFORM]);
}

/* The ways of the rotary axes to a position: of the one that turns the most, and of all together. */
struct ways {
	double most, sum;
};

static struct ways ways_to(const axis_values *from, const axis_values *to)
{
	struct ways ways = {0};

	for (int slot = SLOT_A; slot <= SLOT_C; slot++) {
		const double way = fabs(to->v[slot] - from->v[slot]);

		ways.most = fmax(ways.most, way);
		ways.sum += way;
	}
	return ways;
}

/* The axis that turns less to the first position than to the second one, by the most. */
static char turns_less(const axis_values *from, const axis_values *first, const axis_values *second)
{
	double most = -INFINITY;
	char found = 'A';

	for (int slot = SLOT_A; slot <= SLOT_C; slot++) {
		const double less = fabs(second->v[slot] - from->v[slot]) - fabs(first->v[slot] - from->v[slot]);

		found = less > most ? AXIS_LETTERS[slot] : found;
		most = fmax(most, less);
	}
	return found;
}

/*
 * 840D sl, machine data, MD21180: the control takes the shortest way to one of two solutions. How it counts the ways of
 * two axes is not published. If one solution has both the smaller largest way and the smaller sum, it has the smaller
 * way in every count that is convex and treats the axes alike, such as the root of the sum of squares (majorization).
 */
static bool check_nearer(struct interp *interp, int column, const axis_values *from, const axis_values *best,
			 const axis_values *other)
{
	const struct ways near = ways_to(from, best), far = ways_to(from, other);
	const double same = radians(SAME_DEGREES);

	if (ways_to(best, other).most <= same)
		return true;
	if (near.most < far.most - same && near.sum <= far.sum + same)
		return true;
	if (fabs(near.most - far.most) <= same && near.sum < far.sum - same)
		return true;
	if (fabs(near.most - far.most) <= same && fabs(near.sum - far.sum) <= same)
		return fault(&interp->at, column,
			     "two positions of the rotary axes turn the tool into this direction, and are as near; "
			     "turn the axes towards the one that is meant, in a block before, or limit an axis in the "
			     "machine file, if the control keeps it on one side (MD21180)");
	return fault(&interp->at, column,
		     "two positions of the rotary axes turn the tool into this direction: to the one %c turns less, to "
		     "the other %c, and which one the control takes is not known; turn the axes towards the one that "
		     "is meant, in a block before, or limit an axis in the machine file, if the control keeps it on "
		     "one side (MD21180)",
		     turns_less(from, best, other), turns_less(from, other, best));
}

/*
 * 840D sl, machine data, MD21180, for directions whose nearest positions are past the limits of the axes: with 0 the
 * control stops (alarm 10720); with 1 and 2 it takes other positions, and with 11 and 12 it goes there through the
 * pole, if possible.
 */
static void caution_past_limits(struct interp *interp, int column, const axis_values *from, const axis_values *best,
				const axis_values *solution)
{
	bool *cautioned = &sinumerik_of(interp)->cautioned_limits;
	const struct ways chosen = ways_to(from, best);
	const double same = radians(SAME_DEGREES);
	axis_values nearest = *from;
	struct ways ways;

	for (int slot = SLOT_A; slot <= SLOT_C; slot++)
		nearest.v[slot] += remainder(solution->v[slot] - from->v[slot], 2 * PI);
	ways = ways_to(from, &nearest);
	if (*cautioned || (ways.most >= chosen.most - same && ways.sum >= chosen.sum - same))
		return;
	caution(&interp->at, column,
		"the nearest positions of the rotary axes for this direction are past their limits: here the axes move "
		"together to other ones; a control with MD21180=0 stops, and one with MD21180=11 or 12 moves through "
		"the pole");
	*cautioned = true;
}

static bool is_less(const struct ways *a, const struct ways *b)
{
	return fabs(a->most - b->most) <= radians(SAME_DEGREES) ? a->sum < b->sum : a->most < b->most;
}

/* Of two solutions, the nearer one is taken. An axis for which any angle is right does not move. */
static bool choose_nearest(struct interp *interp, int column, const struct kinematics_orientation *orientation,
			   axis_values *rotary)
{
	struct kinematics_solutions found;
	const struct kinematics_solution *best = NULL, *other;
	struct ways ways[2] = {{0}};

	if (!interp->kinematics->orientations(interp->kinematics->context, line_loc(&interp->at, column), orientation,
					      &found))
		return false;
	for (size_t i = 0; i < found.count; i++) {
		ways[i] = ways_to(&orientation->rotary, &found.items[i].rotary);
		if (found.items[i].within_limits && (!best || is_less(&ways[i], &ways[best - found.items])))
			best = &found.items[i];
	}
	if (!best)
		return fault(&interp->at, column,
			     "the rotary axes of this machine cannot turn the tool into this direction%s",
			     found.count ? " within their limits" : "");
	other = best == found.items ? &found.items[1] : &found.items[0];
	if (found.count == 2 && other->within_limits &&
	    !check_nearer(interp, column, &orientation->rotary, &best->rotary, &other->rotary))
		return false;
	for (size_t i = 0; i < found.count; i++)
		caution_past_limits(interp, column, &orientation->rotary, &best->rotary, &found.items[i].rotary);
	for (int slot = SLOT_A; slot <= SLOT_C; slot++) {
		if (best->tie[slot])
			return fault(
			    &interp->at, column,
			    "%c could turn either way to this direction, which is as near; turn it towards the "
			    "position "
			    "that is meant, in a block before, or give half_turn to the axis in the machine file",
			    AXIS_LETTERS[slot]);
	}
	*rotary = best->rotary;
	return true;
}

static double given_or_zero(const struct sinumerik_block *block, enum sinumerik_address address)
{
	return sinumerik_block_has_address(block, address) ? block->address_value[address] : 0;
}

/*
 * 840D sl, job planning, "Programming the tool orientation", A2= B2= C2=. With Euler angles the direction of Z is
 * rotated about Z by A2, and about the new X by B2 (C2 then turns the tool about itself). With RPY it is rotated
 * about Z by C2, about the new Y by B2, and about the new X by A2. With ORIRPY2 it is rotated about X by A2, and
 * about the new Y by B2.
 */
static bool angles_direction(struct interp *interp, const struct sinumerik_block *block, vec3 *direction)
{
	const double a = given_or_zero(block, SINUMERIK_A2), b = given_or_zero(block, SINUMERIK_B2);
	const double c = given_or_zero(block, SINUMERIK_C2);
	const vec3 x = {1, 0, 0}, y = {0, 1, 0}, z = {0, 0, 1};
	mat3 first, then, last = mat3_identity();

	switch (sinumerik_of(interp)->orientation.angles) {
	case SINUMERIK_ORIEULER:
		first = mat3_turn(z, radians(a));
		then = mat3_turn(x, radians(b));
		break;
	case SINUMERIK_ORIRPY:
		first = mat3_turn(z, radians(c));
		then = mat3_turn(y, radians(b));
		last = mat3_turn(x, radians(a));
		break;
	case SINUMERIK_ORIRPY2:
		first = mat3_turn(x, radians(a));
		then = mat3_turn(y, radians(b));
		break;
	default:
		return fault(&interp->at, sinumerik_block_axis_column(block),
			     "a parameter of the control (MD21102) decides what the angles A2= B2= C2= are: write "
			     "ORIEULER, ORIRPY or ORIRPY2 before them");
	}
	*direction = mat3_apply(&first, mat3_apply(&then, mat3_apply(&last, z)));
	return true;
}

/* The direction of A3=, B3=, C3=, or of A2= B2= C2=, as a unit vector; frames rotate it. False: reported. */
static bool find_direction(struct interp *interp, const struct sinumerik_block *block, vec3 *direction)
{
	const struct state *state = &interp->state;
	const int column = sinumerik_block_axis_column(block);
	double scale;

	*direction = (vec3){given_or_zero(block, SINUMERIK_A3), given_or_zero(block, SINUMERIK_B3),
			    given_or_zero(block, SINUMERIK_C3)};
	if ((block->addresses & SINUMERIK_ANGLE_BITS) && (block->addresses & SINUMERIK_VECTOR_BITS))
		return fault(&interp->at, column, "the block turns the tool by angles (A2= B2= C2=) and by a direction "
						  "(A3= B3= C3=)");
	if ((block->addresses & SINUMERIK_ANGLE_BITS) && !angles_direction(interp, block, direction))
		return false;
	if (!(vec3_norm(*direction) > LEAST_VECTOR))
		return fault(&interp->at, column, "the direction A3= B3= C3= has no length");
	for (int slot = SLOT_A; slot <= SLOT_C; slot++) {
		if (sinumerik_block_has(block, AXIS_LETTERS[slot]))
			return fault(&interp->at, block->column[AXIS_LETTERS[slot] - 'A'],
				     "the block turns the tool by %c and by a direction (A3= B3= C3=)",
				     AXIS_LETTERS[slot]);
	}
	if (sinumerik_of(interp)->orientation.in_machine)
		return fault(&interp->at, column,
			     "a direction A3= B3= C3= with ORIMKS is not supported; use ORIWKS");
	if (state->frame.on && !sinumerik_frame_scale(&state->frame.turn, &scale))
		return fault(&interp->at, column, "a direction where the frame scales its axes differently");
	if (state->frame.on)
		*direction = mat3_apply(&state->frame.turn, *direction);
	*direction = vec3_unit(*direction);
	return true;
}

bool sinumerik_orientation_turn_to(struct interp *interp, int column, vec3 direction, slot_values *target)
{
	const struct state *state = &interp->state;
	const struct kinematics_orientation orientation = {.direction = direction,
							   .rotary_zero = tool_length_rotary_zero(interp),
							   .rotary = state->canonical,
							   .command = "A3= B3= C3="};
	axis_values rotary;

	if (!choose_nearest(interp, column, &orientation, &rotary))
		return false;
	for (int slot = SLOT_A; slot <= SLOT_C; slot++) {
		if (interp->config->has_axis[slot])
			target->v[slot] = state_from_canonical(slot, rotary.v[slot]) - state->offset.v[slot];
	}
	return true;
}

/*
 * 840D sl, function manual F2, MD21104: with 0, ORIWKS and ORIMKS decide, and ORIAXES and ORIVECT have no effect. If
 * the machine file does not tell it, what the program says holds. *sure: it means the same with both values.
 */
static enum sinumerik_orientation_way way_in_force(const struct interp *interp, bool *sure)
{
	const enum orientation_interpolation answer = interp->config->controller.orientation_interpolation;
	const struct sinumerik *sinumerik = sinumerik_of(interp);
	const enum sinumerik_orientation_way programmed = sinumerik->orientation.way,
					     by_coordinates = sinumerik->orientation.in_machine ? SINUMERIK_ORI_AXES
												: SINUMERIK_ORI_VECTOR;

	*sure = answer != ORIENTATION_INTERPOLATION_UNKNOWN || programmed == by_coordinates;
	if (answer == ORIENTATION_INTERPOLATION_ORIWKS)
		return by_coordinates;
	if (programmed)
		return programmed;
	if (sinumerik->orientation.in_machine || answer == ORIENTATION_INTERPOLATION_AXES)
		return SINUMERIK_ORI_AXES;
	return answer == ORIENTATION_INTERPOLATION_VECTOR ? SINUMERIK_ORI_VECTOR : SINUMERIK_ORI_UNKNOWN;
}

/* Once. */
static void caution_unsure_way(struct interp *interp, int column, enum sinumerik_orientation_way way)
{
	bool *cautioned = &sinumerik_of(interp)->cautioned_orientation;

	if (!*cautioned)
		caution(&interp->at, column,
			"%s here, because the program says so; on a control with MD21104=%s: set "
			"orientation_interpolation=\"axes\", \"vector\" (MD21104=1) or \"oriwks\" (MD21104=0) in the "
			"machine file's <controller>",
			way == SINUMERIK_ORI_AXES ? "the rotary axes turn evenly" : "the tool turns on a great circle",
			sinumerik_of(interp)->orientation.way ? "0, ORIWKS and ORIMKS decide instead"
							      : "1, ORIAXES and ORIVECT decide instead of ORIMKS");
	*cautioned = true;
}

bool sinumerik_orientation_find(struct interp *interp, const struct sinumerik_block *block, slot_values *target,
				struct sinumerik_turn *turn)
{
	const slot_values *place = sinumerik_frame_place(interp);
	const int column = sinumerik_block_axis_column(block);
	bool turns, sure;
	const enum sinumerik_orientation_way way = way_in_force(interp, &sure);

	*turn = (struct sinumerik_turn){
	    .by_direction = block->addresses & SINUMERIK_DIRECTION_BITS};
	if (turn->by_direction && !find_direction(interp, block, &turn->direction))
		return false;
	if (turn->by_direction && way != SINUMERIK_ORI_VECTOR &&
	    !sinumerik_orientation_turn_to(interp, column, turn->direction, target))
		return false;
	turns = turn->by_direction && way == SINUMERIK_ORI_VECTOR;
	for (int slot = SLOT_A; slot <= SLOT_C; slot++)
		turns = turns || fabs(target->v[slot] - place->v[slot]) > SAME_DEGREES;
	if (!turns)
		return true;
	if (!sure && way != SINUMERIK_ORI_UNKNOWN)
		caution_unsure_way(interp, column, way);
	switch (way) {
	case SINUMERIK_ORI_AXES:
		return true;
	case SINUMERIK_ORI_UNKNOWN:
		return fault(
		    &interp->at, column,
		    "a parameter of the control (MD21104) decides how TRAORI turns the tool here: set "
		    "orientation_interpolation=\"axes\", \"vector\" (MD21104=1) or \"oriwks\" (MD21104=0) in the "
		    "machine file's <controller>");
	default:
		break;
	}
	if (sinumerik_of(interp)->orientation.in_machine)
		return fault(
		    &interp->at, column,
		    "a great circle (ORIVECT) in the machine's coordinates (ORIMKS) is not supported; use ORIWKS");
	turn->on_circle = true;
	return true;
}
