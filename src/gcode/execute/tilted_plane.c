#include "gcode/execute/tilted_plane.h"

#include <math.h>

#include "base/units.h"

/* Radians: the permitted deviation of the directions of G68.2 P3 from a right angle, for the rounding of posts. */
#define SQUARE_TOLERANCE 2e-5

/* mm: points that are closer to each other, or to one line, define no plane. */
#define POINTS_APART 1e-3

static double word_or(const struct interp *interp, char letter, double otherwise)
{
	return block_has(&interp->block, letter) ? block_value(&interp->block, letter) : otherwise;
}

static vec3 words(const struct interp *interp, const char letters[3])
{
	return (vec3){word_or(interp, letters[0], 0), word_or(interp, letters[1], 0), word_or(interp, letters[2], 0)};
}

static bool has_all(const struct interp *interp, const char letters[3])
{
	return block_has(&interp->block, letters[0]) && block_has(&interp->block, letters[1]) &&
	       block_has(&interp->block, letters[2]);
}

static bool refuse(struct interp *interp, const char *why)
{
	return fault(&interp->at, interp->block.g_column[G_ROTATION], "%s", why);
}

static bool forbid(struct interp *interp, const char *letters)
{
	for (; *letters; letters++) {
		if (block_has(&interp->block, *letters))
			return fault(&interp->at, block_column(&interp->block, *letters),
				     "%c does not belong to this form of G68.2", *letters);
	}
	return true;
}

/* Fanuc B-64484EN, "Tilted Working Plane Indexing", Euler angles: about Z, about the new X, about the new Z. */
static bool by_euler(struct interp *interp, mat3 *turn)
{
	const vec3 x = {1, 0, 0}, z = {0, 0, 1}, angles = words(interp, "IJK");
	mat3 first = mat3_turn(z, radians(angles.x)), second = mat3_turn(x, radians(angles.y));
	mat3 third = mat3_turn(z, radians(angles.z)), both = mat3_mul(&first, &second);

	*turn = mat3_mul(&both, &third);
	return forbid(interp, "QR");
}

/*
 * The same section, roll, pitch and yaw: I about X, J about Y and K about Z of the work offset, in the order of Q's
 * digits. LinuxCNC's G68.2 follows this and turns about the same fixed axes.
 */
static bool by_roll_pitch_yaw(struct interp *interp, mat3 *turn)
{
	const vec3 axes[] = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}, angles = words(interp, "IJK");
	const double given[] = {angles.x, angles.y, angles.z};
	int order = 123, seen = 0;

	if (!forbid(interp, "R"))
		return false;
	if (block_has(&interp->block, 'Q') && !block_integer(&interp->block, &interp->at, 'Q', 123, 321, &order))
		return false;
	*turn = mat3_identity();
	for (int divisor = 100; divisor > 0; divisor /= 10) {
		int axis = order / divisor % 10 - 1;
		mat3 step;

		if (axis < 0 || axis > 2 || (seen & 1 << axis))
			return fault(&interp->at, block_column(&interp->block, 'Q'),
				     "Q of G68.2 P1 is the order of the axes: 123, 132, 213, 231, 312 or 321");
		seen |= 1 << axis;
		step = mat3_turn(axes[axis], radians(given[axis]));
		*turn = mat3_mul(&step, turn);
	}
	return true;
}

/* The rotation whose columns are the directions: X along x, Z along x cross y. */
static bool turn_of(struct interp *interp, vec3 x, vec3 across, const char *why, mat3 *turn)
{
	vec3 z = vec3_cross(x, across);

	if (!(vec3_norm(x) > POINTS_APART) || !(vec3_norm(z) > POINTS_APART * vec3_norm(x)))
		return refuse(interp, why);
	x = vec3_scale(1 / vec3_norm(x), x);
	z = vec3_scale(1 / vec3_norm(z), z);
	*turn = (mat3){x, vec3_cross(z, x), z};
	return true;
}

/* Three points: the first is the zero, X points to the second, the third is on the side of Y. Q0 shifts the zero. */
static bool by_points(struct interp *interp, mat3 *turn, vec3 *origin)
{
	const struct plane_parts *parts = &interp->state.plane_parts;
	const vec3 *p = parts->point;
	mat3 about_z = mat3_turn((vec3){0, 0, 1}, radians(parts->turn));
	bool shifted = vec3_norm(p[0]) > 0;

	if (shifted && parts->has_turn && fabs(parts->turn) > 0)
		return refuse(interp, "G68.2 P2 with both R and a shift in Q0 is not supported");
	if (!turn_of(interp, vec3_sub(p[2], p[1]), vec3_sub(p[3], p[1]),
		     "the three points of G68.2 P2 are on one line or coincide", turn))
		return false;
	*origin = vec3_add(p[1], mat3_apply(turn, p[0]));
	*turn = mat3_mul(turn, &about_z);
	return true;
}

/* Two directions: those of X and Z, which must be at a right angle. */
static bool by_directions(struct interp *interp, mat3 *turn, vec3 *origin)
{
	const struct plane_parts *parts = &interp->state.plane_parts;
	vec3 x = parts->direction[0], z = parts->direction[1];
	double lengths = vec3_norm(x) * vec3_norm(z);
	mat3 about_z = mat3_turn((vec3){0, 0, 1}, radians(parts->turn));

	if (!(lengths > 0))
		return refuse(interp, "a direction of G68.2 P3 has length 0");
	if (fabs(vec3_dot(x, z)) > SQUARE_TOLERANCE * lengths)
		return refuse(interp, "the two directions of G68.2 P3 are not at a right angle");
	z = vec3_scale(1 / vec3_norm(z), z);
	x = vec3_sub(x, vec3_scale(vec3_dot(x, z), z));
	x = vec3_scale(1 / vec3_norm(x), x);
	*turn = (mat3){x, vec3_cross(z, x), z};
	*turn = mat3_mul(turn, &about_z);
	*origin = parts->point[1];
	return true;
}

static bool take_turn(struct interp *interp)
{
	struct plane_parts *parts = &interp->state.plane_parts;

	if (!block_has(&interp->block, 'R'))
		return true;
	if (parts->has_turn)
		return fault(&interp->at, block_column(&interp->block, 'R'), "R occurs twice in one plane of G68.2");
	parts->has_turn = true;
	parts->turn = block_value(&interp->block, 'R');
	return true;
}

static bool take_point(struct interp *interp, int q)
{
	struct plane_parts *parts = &interp->state.plane_parts;

	if (!forbid(interp, "IJK"))
		return false;
	if (q > 0 && !has_all(interp, "XYZ"))
		return refuse(interp, "a point of G68.2 P2 needs X, Y and Z");
	parts->point[q] = vec3_scale(interp->state.scale, words(interp, "XYZ"));
	return take_turn(interp);
}

static bool take_direction(struct interp *interp, int q)
{
	struct plane_parts *parts = &interp->state.plane_parts;

	if (!has_all(interp, "IJK"))
		return refuse(interp, "a direction of G68.2 P3 needs I, J and K");
	parts->direction[q - 1] = words(interp, "IJK");
	if (q == 2)
		return forbid(interp, "XYZR");
	parts->point[1] = vec3_scale(interp->state.scale, words(interp, "XYZ"));
	return take_turn(interp);
}

/* One block of P2 (Q1 to Q3, and Q0 before them) or of P3 (Q1 and Q2). */
static bool take_part(struct interp *interp, int form, bool *complete, mat3 *turn, vec3 *origin)
{
	struct plane_parts *parts = &interp->state.plane_parts;
	int q = 0, last = form == 2 ? 3 : 2;

	if (!block_has(&interp->block, 'Q'))
		return refuse(interp, "G68.2 P2 and P3 need Q (which part of the plane the block gives)");
	if (!block_integer(&interp->block, &interp->at, 'Q', form == 2 ? 0 : 1, last, &q))
		return false;
	if (parts->form != 0 && parts->form != form)
		return refuse(interp, "another form of G68.2 before the plane is complete");
	if (q > 1 ? parts->next != q : parts->form != 0 && parts->next != q)
		return fault(&interp->at, block_column(&interp->block, 'Q'),
			     "Q%d of G68.2 P%d, but Q%d must come next", q, form, parts->form == 0 ? 1 : parts->next);
	if (parts->form == 0)
		*parts = (struct plane_parts){.form = form};
	parts->next = q + 1;
	if (form == 2 ? !take_point(interp, q) : !take_direction(interp, q))
		return false;
	*complete = q == last;
	if (!*complete)
		return true;
	parts->form = 0;
	return form == 2 ? by_points(interp, turn, origin) : by_directions(interp, turn, origin);
}

bool tilted_plane_take(struct interp *interp, bool *complete, mat3 *turn, vec3 *origin)
{
	const struct block *block = &interp->block;
	int form = 0;

	*complete = true;
	if (block_has(block, 'P') && !block_integer(block, &interp->at, 'P', 0, 4, &form))
		return false;
	/* Only a figure of the manual shows the sign of its angle about Y. */
	if (form == 4)
		return refuse(
		    interp, "G68.2 P4 (projection angles) is not supported; use P1 or Euler angles");
	if (form >= 2 && block->g[G_ROTATION] == G68_4)
		return refuse(interp, "G68.4 with P2 or P3 is not supported; use Euler angles or P1");
	if (form >= 2)
		return take_part(interp, form, complete, turn, origin);
	if (interp->state.plane_parts.form != 0)
		return refuse(interp, "another form of G68.2 before the plane is complete");
	*origin = vec3_scale(interp->state.scale, words(interp, "XYZ"));
	return form == 0 ? by_euler(interp, turn) : by_roll_pitch_yaw(interp, turn);
}

bool tilted_plane_check_block(struct interp *interp)
{
	const struct plane_parts *parts = &interp->state.plane_parts;

	if (parts->form == 0 || interp->block.g[G_ROTATION] == G68_2 || interp->block.words == 0)
		return true;
	return fault(&interp->at, 1, "the plane of G68.2 P%d is not complete: Q%d must come next", parts->form,
		     parts->next);
}
