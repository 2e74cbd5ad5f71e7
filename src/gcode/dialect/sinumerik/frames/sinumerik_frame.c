#include "gcode/dialect/sinumerik/frames/sinumerik_frame.h"

#include <math.h>
#include <string.h>

#include "base/same_double.h"
#include "base/units.h"
#include "gcode/execute/tool_length.h"
#include "geom/tolerance.h"

/* Two scale factors are equal, and two directions are perpendicular, within this tolerance. */
#define SAME_SCALE 1e-12

/* Degrees */
#define RIGHT_ANGLE 90

static vec3 apply_inverse(const mat3 *m, vec3 p)
{
	const vec3 yz = vec3_cross(m->y, m->z);
	const double determinant = vec3_dot(m->x, yz);

	return vec3_scale(1 / determinant, (vec3){vec3_dot(yz, p), vec3_dot(vec3_cross(m->z, m->x), p),
						  vec3_dot(vec3_cross(m->x, m->y), p)});
}

bool sinumerik_frame_resizes(const struct interp *interp)
{
	const struct rotated_frame *frame = &interp->state.frame;
	const vec3 rows[3] = {frame->turn.x, frame->turn.y, frame->turn.z};

	if (!frame->on || !frame->distorts)
		return false;
	/* The rows of a matrix that keeps lengths are perpendicular unit vectors. */
	for (int i = 0; i < 3; i++) {
		if (fabs(vec3_norm(rows[i]) - 1) > DIRECTION_TOLERANCE ||
		    fabs(vec3_dot(rows[i], rows[(i + 1) % 3])) > DIRECTION_TOLERANCE)
			return true;
	}
	return false;
}

struct sinumerik_frame sinumerik_frame_none(void)
{
	return (struct sinumerik_frame){.matrix = mat3_identity()};
}

struct sinumerik_frame sinumerik_frame_chain(const struct sinumerik_frame *outer, const struct sinumerik_frame *inner)
{
	struct sinumerik_frame total = {.matrix = mat3_mul(&outer->matrix, &inner->matrix), .axial = outer->axial};

	for (int slot = 0; slot < SLOT_COUNT; slot++) {
		total.shift.v[slot] = outer->shift.v[slot] + inner->shift.v[slot];
		total.fine.v[slot] = outer->fine.v[slot] + inner->fine.v[slot];
	}
	slot_values_set_linear(&total.shift,
			       vec3_add(slot_values_linear(&outer->shift),
					mat3_apply(&outer->matrix, slot_values_linear(&inner->shift))));
	return total;
}

struct sinumerik_frame sinumerik_frame_total(const struct sinumerik *sinumerik)
{
	return sinumerik_frame_chain(&sinumerik->frames.swivel, &sinumerik->frames.programmed);
}

bool sinumerik_frame_scale(const mat3 *matrix, double *factor)
{
	const double x = vec3_norm(matrix->x), y = vec3_norm(matrix->y), z = vec3_norm(matrix->z);

	*factor = x;
	return fabs(x - y) <= SAME_SCALE * x && fabs(x - z) <= SAME_SCALE * x &&
	       fabs(vec3_dot(matrix->x, matrix->y)) <= SAME_SCALE * x * x &&
	       fabs(vec3_dot(matrix->y, matrix->z)) <= SAME_SCALE * x * x &&
	       fabs(vec3_dot(matrix->z, matrix->x)) <= SAME_SCALE * x * x;
}

bool sinumerik_frame_scale_plane(const mat3 *matrix, enum axis_slot across, double *factor)
{
	const vec3 columns[3] = {matrix->x, matrix->y, matrix->z};
	const vec3 a = columns[(across + 1) % 3], b = columns[(across + 2) % 3], c = columns[across];
	const double length = vec3_norm(a), height = vec3_norm(c);

	*factor = length;
	return fabs(length - vec3_norm(b)) <= SAME_SCALE * length &&
	       fabs(vec3_dot(a, b)) <= SAME_SCALE * length * length &&
	       fabs(vec3_dot(a, c)) <= SAME_SCALE * length * height &&
	       fabs(vec3_dot(b, c)) <= SAME_SCALE * length * height;
}

static bool is_identity(const mat3 *m)
{
	const mat3 one = mat3_identity();

	return same_double(vec3_norm2(vec3_sub(m->x, one.x)), 0) && same_double(vec3_norm2(vec3_sub(m->y, one.y)), 0) &&
	       same_double(vec3_norm2(vec3_sub(m->z, one.z)), 0);
}

slot_values sinumerik_frame_straight(const struct interp *interp, const slot_values *place)
{
	slot_values straight;

	for (int slot = 0; slot < SLOT_COUNT; slot++)
		straight.v[slot] = place->v[slot] + interp->state.offset.v[slot];
	return straight;
}

const slot_values *sinumerik_frame_place(struct interp *interp)
{
	struct sinumerik *sinumerik = sinumerik_of(interp);
	const struct state *state = &interp->state;

	if (sinumerik->place.known)
		return &sinumerik->place.program;
	for (int slot = 0; slot < SLOT_COUNT; slot++)
		sinumerik->place.program.v[slot] = state->position.v[slot] - state->offset.v[slot];
	if (state->frame.on)
		slot_values_set_linear(&sinumerik->place.program,
				       apply_inverse(&state->frame.turn,
						     vec3_sub(slot_values_linear(&sinumerik->place.program),
							      state->frame.origin)));
	sinumerik->place.known = true;
	return &sinumerik->place.program;
}

void sinumerik_frame_moved(struct interp *interp)
{
	sinumerik_of(interp)->place.known = false;
	/* CT cannot continue such a motion. */
	sinumerik_of(interp)->tangent.known = false;
}

/* The data that rotated_frame.h needs of a matrix that may mirror and scale. */
static void describe_frame(struct rotated_frame *frame, const mat3 *matrix)
{
	const vec3 xyz[3] = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
	double factor;

	frame->turn = *matrix;
	frame->back =
	    (mat3){apply_inverse(matrix, xyz[0]), apply_inverse(matrix, xyz[1]), apply_inverse(matrix, xyz[2])};
	frame->mirrors = vec3_dot(matrix->x, vec3_cross(matrix->y, matrix->z)) < 0;
	frame->distorts =
	    frame->mirrors || !sinumerik_frame_scale(matrix, &factor) || fabs(factor - 1) > DIRECTION_TOLERANCE;
	frame->growth = sqrt(vec3_norm2(matrix->x) + vec3_norm2(matrix->y) + vec3_norm2(matrix->z));
}

bool sinumerik_frame_changed(struct interp *interp, int column)
{
	struct sinumerik *sinumerik = sinumerik_of(interp);
	struct state *state = &interp->state;
	const struct sinumerik_frame total = sinumerik_frame_total(sinumerik);
	const slot_values before = *sinumerik_frame_place(interp);
	double factor;

	state->shift = total.shift;
	state->frame = (struct rotated_frame){.on = !is_identity(&total.matrix)};
	if (state->frame.on) {
		describe_frame(&state->frame, &total.matrix);
		state->frame.origin = slot_values_linear(&total.shift);
		slot_values_set_linear(&state->shift, (vec3){0, 0, 0});
	}
	sinumerik->tangent.known = false;
	sinumerik->frames.even = sinumerik_frame_scale(&total.matrix, &factor);
	if (!tool_length_offsets_changed(interp, column))
		return false;
	sinumerik->place.known = false;
	sinumerik_frame_place(interp);
	for (int slot = 0; slot < SLOT_COUNT; slot++) {
		if (sinumerik->place.shifted[slot] || same_double(before.v[slot], sinumerik->place.program.v[slot]))
			continue;
		sinumerik->place.shifted[slot] = true;
		sinumerik->place.programmed.v[slot] = before.v[slot];
	}
	return true;
}

/* ------------------------------------------------------------- statements */

static vec3 words_vector(const struct sinumerik_frame_words *words, double otherwise)
{
	return (vec3){words->has[SLOT_X] ? words->value[SLOT_X] : otherwise,
		      words->has[SLOT_Y] ? words->value[SLOT_Y] : otherwise,
		      words->has[SLOT_Z] ? words->value[SLOT_Z] : otherwise};
}

static mat3 turn_about(int slot, double angle)
{
	return mat3_turn((vec3){slot == SLOT_X, slot == SLOT_Y, slot == SLOT_Z}, radians(angle));
}

/*
 * 840D sl, "Programmable rotation (ROT, AROT, RPL)": several angles in one block are executed in the order Z, Y, X by
 * RPY (the default of MD10600): about Z, then about the new Y, then about the new X. RPL rotates in the working
 * plane.
 */
static bool turn_by(struct interp *interp, const struct sinumerik_frame_words *words, mat3 *turn)
{
	const int across = interp->state.plane == G17 ? SLOT_Z : interp->state.plane == G18 ? SLOT_Y : SLOT_X;
	int angles = 0;

	*turn = mat3_identity();
	for (int slot = SLOT_Z; slot >= SLOT_X; slot--) {
		const mat3 one = turn_about(slot, words->has[slot] ? words->value[slot] : 0);

		angles += words->has[slot];
		if (words->has[slot])
			*turn = mat3_mul(turn, &one);
	}
	if (angles > 1 && interp->config->controller.rotation_order == ROTATION_ORDER_UNKNOWN)
		return fault(&interp->at, words->column,
			     "a parameter of the control (MD10600) decides in which order several angles turn the "
			     "frame: set rotation_order=\"rpy\" or \"euler\" in the machine file's <controller>");
	if (angles > 1 && interp->config->controller.rotation_order == ROTATION_ORDER_EULER)
		return fault(&interp->at, words->column,
			     "several angles in one ROT by Euler's angles are not supported; write one angle in a "
			     "block, ROT and then AROT");
	if (angles > 0 && words->has_plane_angle)
		return fault(&interp->at, words->column, "RPL stands alone in its ROT");
	if (words->has_plane_angle)
		*turn = turn_about(across, words->plane_angle);
	return true;
}

/*
 * Function manual K2, "ROTS, AROTS, CROTS": the angle named Y rotates X about Y, into the line in which the new plane
 * meets the plane of X and Z. The angle named X rotates Y about X, into the line in which the new plane meets the
 * plane of Y and Z. X stays in its old plane with Z. The same holds for Z and X, and for Y and Z.
 */
bool sinumerik_frame_solid(int third, vec3 angles, mat3 *matrix)
{
	const double degrees[3] = {angles.x, angles.y, angles.z};
	const int first = (third + 1) % 3, second = (third + 2) % 3;
	const mat3 about_first = turn_about(first, degrees[first]), about_second = turn_about(second, degrees[second]);
	const vec3 axis = mat3_apply(&about_second, (vec3){first == SLOT_X, first == SLOT_Y, first == SLOT_Z});
	const vec3 line = mat3_apply(&about_first, (vec3){second == SLOT_X, second == SLOT_Y, second == SLOT_Z});
	vec3 columns[3];

	if (!(fabs(degrees[first]) < RIGHT_ANGLE && fabs(degrees[second]) < RIGHT_ANGLE))
		return false;
	columns[first] = axis;
	columns[third] = vec3_unit(vec3_cross(axis, line));
	columns[second] = vec3_cross(columns[third], axis);
	*matrix = (mat3){columns[0], columns[1], columns[2]};
	return true;
}

static bool turn_by_solid(struct interp *interp, const struct sinumerik_frame_words *words, mat3 *turn)
{
	const vec3 angles = words_vector(words, 0);
	const int count = words->has[SLOT_X] + words->has[SLOT_Y] + words->has[SLOT_Z];
	const int third = !words->has[SLOT_Z] ? SLOT_Z : !words->has[SLOT_Y] ? SLOT_Y : SLOT_X;

	if (words->has_plane_angle || count == 3)
		return fault(&interp->at, words->column, "ROTS and AROTS have one or two solid angles: X and Y, Z and "
							 "X, or Y and Z");
	if (count < 2)
		return turn_by(interp, words, turn);
	return sinumerik_frame_solid(third, angles, turn) ||
	       fault(&interp->at, words->column, "two solid angles must lie between -90 and 90 degrees");
}

static bool scale_by(struct interp *interp, const struct sinumerik_frame_words *words, mat3 *matrix)
{
	const vec3 factor = words_vector(words, 1);

	if (!(factor.x > 0 && factor.y > 0 && factor.z > 0))
		return fault(&interp->at, words->column, "a scale must be greater than 0");
	*matrix = (mat3){{factor.x, 0, 0}, {0, factor.y, 0}, {0, 0, factor.z}};
	return true;
}

/*
 * 840D sl, machine data, MD10612: with 1, as delivered, MIRROR reverses each named axis whatever its value is, and
 * AMIRROR reverses it again. With 0 a value of 0 switches mirroring off, and others switch it on; MIRROR has then
 * switched it off before.
 */
static bool mirror_by(struct interp *interp, const struct sinumerik_frame_words *words, mat3 *matrix)
{
	const enum answer toggle = interp->config->controller.mirror_toggle;
	bool *cautioned = &sinumerik_of(interp)->cautioned_mirror, reverses[3], same = !words->added;

	for (int slot = SLOT_X; slot <= SLOT_Z; slot++) {
		const bool zero = same_double(words->value[slot], 0);

		reverses[slot] = words->has[slot] && (toggle != ANSWER_NO || !zero);
		same = same && !(words->has[slot] && zero);
	}
	if (words->added && toggle == ANSWER_NO)
		return fault(&interp->at, words->column,
			     "AMIRROR with mirror_toggle=\"no\" (MD10612=0) is not supported; use MIRROR");
	if (toggle == ANSWER_UNKNOWN && !same && !*cautioned) {
		caution(&interp->at, words->column,
			"each axis that is named is mirrored here, as on a control as delivered; with MD10612=0 a "
			"value of 0 means no mirroring: set mirror_toggle=\"yes\" or \"no\" in the machine file's "
			"<controller>");
		*cautioned = true;
	}
	*matrix = (mat3){{reverses[0] ? -1 : 1, 0, 0}, {0, reverses[1] ? -1 : 1, 0}, {0, 0, reverses[2] ? -1 : 1}};
	return true;
}

static bool frame_of(struct interp *interp, const struct sinumerik_frame_words *words, struct sinumerik_frame *frame)
{
	*frame = sinumerik_frame_none();
	for (int slot = SLOT_A; slot < SLOT_COUNT && words->code != SINUMERIK_TRANS && words->code != SINUMERIK_AXIAL;
	     slot++) {
		if (words->has[slot])
			return fault(&interp->at, words->column,
				     "only X, Y and Z can be turned, scaled and mirrored here, not %c",
				     AXIS_LETTERS[slot]);
	}
	switch (words->code) {
	case SINUMERIK_TRANS:
		for (int slot = 0; slot < SLOT_COUNT; slot++) {
			/*
			 * The table of "Axial zero offset" says that TRANS with an axis keeps what ATRANS and G59 have
			 * set; "Frame instructions" says that TRANS deletes it, as TRANS alone certainly does.
			 */
			if (words->has[slot] && !words->added && sinumerik_of(interp)->frames.programmed.axial)
				return fault(&interp->at, words->column,
					     "the manual leaves open whether TRANS with an axis deletes the shift of "
					     "G59, too; write TRANS alone before it");
			frame->shift.v[slot] = words->has[slot] ? words->value[slot] : 0;
		}
		return true;
	case SINUMERIK_ROT:
		return turn_by(interp, words, &frame->matrix);
	case SINUMERIK_SOLID:
		return turn_by_solid(interp, words, &frame->matrix);
	case SINUMERIK_SCALE:
		return scale_by(interp, words, &frame->matrix);
	default:
		return mirror_by(interp, words, &frame->matrix);
	}
}

/*
 * "Axial zero offset (G58, G59)": for the named axes, G58 replaces the shift of TRANS, and G59 the shift that ATRANS
 * has added. The other part remains.
 */
static bool set_axial(struct interp *interp, const struct sinumerik_frame_words *words)
{
	struct sinumerik_frame *frame = &sinumerik_of(interp)->frames.programmed;

	frame->axial = true;
	if (!is_identity(&frame->matrix))
		return fault(&interp->at, words->column,
			     "G58 and G59 while ROT, SCALE or MIRROR is in force are not supported");
	for (int slot = 0; slot < SLOT_COUNT; slot++) {
		const double fine = frame->fine.v[slot], coarse = frame->shift.v[slot] - fine;

		if (!words->has[slot])
			continue;
		frame->shift.v[slot] = words->value[slot] + (words->added ? coarse : fine);
		if (words->added)
			frame->fine.v[slot] = words->value[slot];
	}
	return sinumerik_frame_changed(interp, words->column);
}

/*
 * 840D sl, "Frame instructions": TRANS, ROT, SCALE and MIRROR first delete the whole programmable frame; without
 * words they do nothing else. The forms with A are added to the frame, in its own coordinates.
 */
bool sinumerik_frame_set(struct interp *interp, const struct sinumerik_frame_words *words)
{
	struct sinumerik *sinumerik = sinumerik_of(interp);
	struct sinumerik_frame frame;

	if (sinumerik->frames.programmed_unsure && (words->added || words->code == SINUMERIK_AXIAL))
		return fault(&interp->at, words->column,
			     "this adds to a frame that CYCLE800() may have deleted; write TRANS before it, with "
			     "the values that are meant, or set frames_outlive_cycle800=\"yes\" or \"no\" in the "
			     "machine file's <controller>");
	if (words->code == SINUMERIK_AXIAL)
		return set_axial(interp, words);
	if (!frame_of(interp, words, &frame))
		return false;
	if (words->code == SINUMERIK_TRANS && words->added)
		frame.fine = frame.shift;
	sinumerik->frames.programmed_unsure = false;
	sinumerik->frames.programmed =
	    words->added ? sinumerik_frame_chain(&sinumerik->frames.programmed, &frame) : frame;
	return sinumerik_frame_changed(interp, words->column);
}
