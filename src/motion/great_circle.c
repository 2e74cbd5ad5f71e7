#include "motion/great_circle.h"

#include <math.h>

#include "base/math/math_functions.h"
#include "base/units.h"
#include "geom/tolerance.h"
#include "machine/chain.h"
#include "motion/orient.h"
#include "motion/tcp.h"

/* Radians: the rounding of a rotary position. */
#define ROUNDING 1e-10

struct circle {
	vec3 a, b;	/* the axes, unit vectors */
	int slots[2];
	vec3 tool;
	mat3 to_work;	/* from the controller's directions to those of the workpiece at the zero pose */
};

static bool circle_init(struct circle *circle, const struct machine *machine, struct srcloc loc, struct diag *diag,
			const axis_values *rotary_zero)
{
	const struct kinematics_tcp state = {.on = true, .rotary_zero = *rotary_zero};
	struct chain chain;
	struct tcp tcp;
	size_t count = 0;

	if (!tcp_init(&tcp, machine, &state, loc, diag))
		return false;
	chain_init(&chain, machine, machine->workholding.link, machine->spindle.link);
	for (size_t i = 0; i < chain.count; i++) {
		if (!chain.joints[i].rotary)
			continue;
		if (count < 2) {
			*(count ? &circle->b : &circle->a) = chain.joints[i].direction;
			circle->slots[count] = chain.joints[i].slot;
		}
		count++;
	}
	if (count != 2) {
		diag_error(
		    diag, loc,
		    "turning the tool on a great circle needs two rotary axes between the workpiece and the tool; this "
		    "machine has %zu",
		    count);
		return false;
	}
	circle->tool = vec3_scale(-1, machine->spindle.direction);
	circle->to_work = mat3_mul(&tcp.table_zero_inverse.rotation, &tcp.matrix);
	return true;
}

bool great_circle_direction(const struct machine *machine, struct srcloc loc, struct diag *diag,
			    const axis_values *rotary_zero, const axis_values *rotary, vec3 *direction)
{
	struct circle circle;
	mat3 alpha, beta;

	if (!circle_init(&circle, machine, loc, diag, rotary_zero))
		return false;
	alpha = mat3_turn(circle.a, rotary->v[circle.slots[0]]);
	beta = mat3_turn(circle.b, rotary->v[circle.slots[1]]);
	*direction =
	    vec3_unit(mat3_apply_transposed(&circle.to_work, mat3_apply(&alpha, mat3_apply(&beta, circle.tool))));
	return true;
}

/* Bounds over a piece of the great circle, per unit of s. */
struct bounds {
	double first[2], second[2];	/* of alpha and beta */
	bool known;
};

/* `at` is the middle of the piece; no direction of the piece is farther from it than `half` radians; `speed` is w. */
static struct bounds find_bounds(const struct circle *circle, vec3 normal, vec3 at, double half, double speed)
{
	const double k = vec3_dot(circle->a, circle->b), p = vec3_dot(circle->b, circle->tool);
	const double lean = math_acos(fmin(fmax(vec3_dot(circle->a, at), -1), 1));
	const double least = fmax(lean - half, 0), most = fmin(lean + half, PI);
	const double sine = fmin(math_sin(least), math_sin(most)),
		     widest = least <= PI / 2 && most >= PI / 2 ? 1 : fmax(math_sin(least), math_sin(most));
	const double high = math_cos(least), low = math_cos(most), x = fmax(fabs(high), fabs(low));
	const double r2 = (1 - k * k) * (1 - p * p), off = fmax(fabs(high - k * p), fabs(low - k * p));
	const double d2 = r2 - off * off, q = fabs(k) + fabs(p) * x, m = speed * fabs(vec3_dot(circle->a, normal));
	struct bounds bounds = {.known = sine > 0 && d2 > 0};
	double d, s2 = sine * sine;

	if (!bounds.known)
		return bounds;
	d = sqrt(d2);
	bounds.first[1] = speed * widest / d;
	bounds.second[1] = speed * speed * x / d + bounds.first[1] * bounds.first[1] * sqrt(r2) / d;
	bounds.first[0] = (m + bounds.first[1] * q) / s2;
	bounds.second[0] = (bounds.second[1] * q + bounds.first[1] * fabs(p) * speed * widest) / s2 +
			   2 * bounds.first[0] * x * speed / sine;
	return bounds;
}

/* Do the axes reach this solution on the piece, and not the other one? */
static bool is_reached(const struct circle *circle, const struct kinematics_great_circle *piece,
		       const axis_values *rotary, const struct bounds *bounds)
{
	const double h = piece->s1 - piece->s0;

	for (int i = 0; i < 2; i++) {
		const int slot = circle->slots[i];

		if (fabs(rotary->v[slot] - piece->rotary.v[slot]) > bounds->first[i] * h + ROUNDING)
			return false;
	}
	return true;
}

bool great_circle_piece(const struct machine *machine, struct srcloc loc, struct diag *diag,
			struct kinematics_great_circle *piece)
{
	struct kinematics_orientation wanted = {.rotary_zero = piece->rotary_zero, .rotary = piece->rotary};
	const vec3 across = vec3_cross(piece->from, piece->to);
	const double whole = math_atan2(vec3_norm(across), vec3_dot(piece->from, piece->to));
	const vec3 axis = vec3_unit(across);
	const double h = piece->s1 - piece->s0;
	struct kinematics_solutions found;
	struct bounds bounds;
	struct circle circle;
	int reached = -1;
	mat3 turn;

	if (!circle_init(&circle, machine, loc, diag, &piece->rotary_zero))
		return false;
	turn = mat3_turn(axis, whole * piece->s1);
	wanted.direction = mat3_apply(&turn, piece->from);
	if (!orient_solutions(machine, loc, diag, &wanted, &found))
		return false;
	turn = mat3_turn(axis, whole * (piece->s0 + piece->s1) / 2);
	bounds = find_bounds(&circle, mat3_apply(&circle.to_work, axis),
			     mat3_apply(&circle.to_work, mat3_apply(&turn, piece->from)), whole * h / 2, whole);
	for (size_t i = 0; bounds.known && i < found.count; i++) {
		if (!found.items[i].within_limits || !is_reached(&circle, piece, &found.items[i].rotary, &bounds))
			continue;
		/* Both: the piece is too long to distinguish them. */
		bounds.known = reached < 0;
		reached = (int)i;
	}
	for (int slot = 0; slot < SLOT_COUNT; slot++)
		piece->beside[slot] = bounds.known && reached >= 0 ? 0 : INFINITY;
	if (!bounds.known || reached < 0)
		return true;
	for (int i = 0; i < 2; i++)
		piece->beside[circle.slots[i]] = bounds.second[i] * h * h / 8 + ROUNDING;
	piece->rotary = found.items[reached].rotary;
	return true;
}
