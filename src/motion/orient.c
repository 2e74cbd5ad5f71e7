#include "motion/orient.h"

#include <math.h>

#include "base/strbuf.h"
#include "base/units.h"
#include "machine/chain.h"
#include "motion/tcp.h"

/* Directions that are unit vectors but for rounding are good to this, and so are their projections. */
#define DIRECTION_TOLERANCE 1e-9
/* The same for what machine files and programs write with a few decimals: a plane so nearly reached is reached. */
#define REACH_TOLERANCE 1e-6
/* Radians: ways that differ by less are equally long. */
#define TIE_TOLERANCE 1e-6
/* A position this near to a limit, in radians, is inside: as for moves. */
#define LIMIT_TOLERANCE (1e-6 * PI / 180)

struct problem {
	const struct machine *machine;
	const axis_values *here;
	struct chain chain;	/* rotary joints from the workpiece to the spindle */
	vec3 tool;	/* from the tip to the spindle at the zero pose */
	vec3 wanted;	/* the same in the workpiece's frame */
};

struct solution {
	bool found;	/* some turn of it lies within the limits */
	double angle[2];	/* of the chain's joints, radians */
	bool free[2];	/* any angle would do */
	double way;	/* sum of the ways from here */
};

/* The angle about the unit axis that turns `from` to `to`, both with the same part along the axis. */
static double angle_about(vec3 axis, vec3 from, vec3 to)
{
	vec3 a = vec3_mad(from, -vec3_dot(axis, from), axis), b = vec3_mad(to, -vec3_dot(axis, to), axis);

	return atan2(vec3_dot(axis, vec3_cross(a, b)), vec3_dot(a, b));
}

static bool is_along(vec3 axis, vec3 direction)
{
	return vec3_norm(vec3_cross(axis, direction)) < REACH_TOLERANCE;
}

/* Whole turns away, the position within the limits that is the nearest to `here`. */
static bool nearest_turn(const struct axis *axis, double angle, double here, double *nearest)
{
	double best = INFINITY, low, high, k;

	low = ceil((axis->limit_min - LIMIT_TOLERANCE - angle) / (2 * PI));
	high = floor((axis->limit_max + LIMIT_TOLERANCE - angle) / (2 * PI));
	k = round((here - angle) / (2 * PI));
	if (low > high)
		return false;
	k = fmin(fmax(k, low), high);
	best = angle + 2 * PI * k;
	/* What the limits take off by rounding. */
	*nearest = fmin(fmax(best, axis->limit_min), axis->limit_max);
	return true;
}

static void settle(const struct problem *problem, struct solution *solution)
{
	solution->found = true;
	solution->way = 0;
	for (size_t i = 0; i < problem->chain.count; i++) {
		int slot = problem->chain.joints[i].slot;
		double here = problem->here->v[slot];

		if (solution->free[i])
			solution->angle[i] = here;
		else if (!nearest_turn(machine_axis(problem->machine, slot), solution->angle[i], here,
				       &solution->angle[i]))
			solution->found = false;
		solution->way += fabs(solution->angle[i] - here);
	}
}

/* One rotary axis: the direction must lie on the cone that the tool describes. */
static size_t solve_one(const struct problem *problem, struct solution solutions[2])
{
	vec3 axis = problem->chain.joints[0].direction;

	if (fabs(vec3_dot(axis, problem->tool) - vec3_dot(axis, problem->wanted)) > REACH_TOLERANCE)
		return 0;
	solutions[0].free[0] = is_along(axis, problem->tool);
	solutions[0].angle[0] = angle_about(axis, problem->tool, problem->wanted);
	settle(problem, &solutions[0]);
	return 1;
}

/*
 * wanted = turn(a, alpha) turn(b, beta) tool. Half way stands
 * c = turn(b, beta) tool = turn(a, -alpha) wanted, a unit vector with
 * b.c = b.tool and a.c = a.wanted: c = x a + y b +- z (a x b). (Paden and Kahan's
 * second subproblem: Murray, Li, Sastry, "A Mathematical Introduction to
 * Robotic Manipulation", 3.3.2.)
 */
static size_t solve_two(const struct problem *problem, struct solution solutions[2])
{
	vec3 a = problem->chain.joints[0].direction, b = problem->chain.joints[1].direction;
	double k = vec3_dot(a, b), s = 1 - k * k;
	double along_a = vec3_dot(a, problem->wanted), along_b = vec3_dot(b, problem->tool), x, y, zz, z;
	size_t count;

	if (s < DIRECTION_TOLERANCE)
		return 0;
	x = (along_a - k * along_b) / s;
	y = (along_b - k * along_a) / s;
	zz = (1 - x * x - y * y - 2 * k * x * y) / s;
	if (zz < -REACH_TOLERANCE)
		return 0;
	z = sqrt(fmax(zz, 0));
	count = z * sqrt(s) < REACH_TOLERANCE ? 1 : 2;
	for (size_t i = 0; i < count; i++) {
		vec3 half = vec3_add(vec3_scale(x, a), vec3_scale(y, b));

		half = vec3_mad(half, count == 1 ? 0 : i ? -z : z, vec3_cross(a, b));
		solutions[i] = (struct solution){.free = {is_along(a, problem->wanted), is_along(b, problem->tool)}};
		solutions[i].angle[0] = angle_about(a, half, problem->wanted);
		solutions[i].angle[1] = angle_about(b, problem->tool, half);
		settle(problem, &solutions[i]);
	}
	return count;
}

static void add_solution(struct strbuf *text, const struct problem *problem, const struct solution *solution)
{
	for (size_t i = 0; i < problem->chain.count; i++)
		strbuf_addf(text, "%s%c%.6g", i ? " " : "", AXIS_LETTERS[problem->chain.joints[i].slot],
			    degrees(solution->angle[i]) + 0.0);
}

static void tell(const struct problem *problem, const struct solution solutions[2], size_t count, size_t chosen,
		 struct srcloc loc, struct diag *diag)
{
	const struct solution *other = count == 2 ? &solutions[1 - chosen] : NULL;
	bool tie = other && other->found && fabs(other->way - solutions[chosen].way) < TIE_TOLERANCE;
	struct strbuf text = {0};

	strbuf_addf(&text, "G53.1 turns to ");
	add_solution(&text, problem, &solutions[chosen]);
	if (other) {
		strbuf_addf(&text, "; the other solution, ");
		add_solution(&text, problem, other);
		strbuf_addf(&text, "%s", !other->found ? ", lies outside the limits"
					 : tie	      ? ", is as near, and the control may take that one"
						      : ", is farther");
	}
	if (tie)
		diag_warning(diag, loc, "%s", strbuf_text(&text));
	else
		diag_note(diag, loc, "%s", strbuf_text(&text));
	strbuf_release(&text);
}

/* Keeps the chain's rotary joints. */
static void drop_linear(struct chain *chain)
{
	size_t kept = 0;

	for (size_t i = 0; i < chain->count; i++) {
		if (chain->joints[i].rotary)
			chain->joints[kept++] = chain->joints[i];
	}
	chain->count = kept;
}

static bool is_orthonormal(const mat3 *m)
{
	return fabs(vec3_dot(m->x, m->y)) < REACH_TOLERANCE && fabs(vec3_dot(m->y, m->z)) < REACH_TOLERANCE &&
	       fabs(vec3_dot(m->z, m->x)) < REACH_TOLERANCE;
}

static bool set_problem(struct problem *problem, const struct machine *machine,
			const struct canon_orientation *orientation, struct srcloc loc, struct diag *diag)
{
	const struct canon_tcp state = {.on = true, .rotary_zero = orientation->rotary_zero};
	struct tcp tcp;

	if (!tcp_init(&tcp, machine, &state, loc, diag))
		return false;
	if (!is_orthonormal(&tcp.matrix)) {
		diag_error(diag, loc, "a tilted plane needs axes X, Y and Z at right angles");
		return false;
	}
	*problem = (struct problem){.machine = machine, .here = &orientation->rotary};
	chain_init(&problem->chain, machine, machine->workholding.link, machine->spindle.link);
	drop_linear(&problem->chain);
	problem->tool = vec3_scale(-1, machine->spindle.direction);
	problem->wanted = mat3_apply(&tcp.table_zero_inverse.rotation,
				     mat3_apply(&tcp.matrix, orientation->direction));
	if (problem->chain.count == 1 || problem->chain.count == 2)
		return true;
	diag_error(diag, loc, "G53.1 needs one or two rotary axes between the workpiece and the tool; this machine "
			      "has %zu", problem->chain.count);
	return false;
}

bool orient_tool(const struct machine *machine, struct srcloc loc, struct diag *diag,
		 struct canon_orientation *orientation)
{
	struct solution solutions[2] = {{0}};
	struct problem problem;
	size_t count, chosen = 0;

	if (!set_problem(&problem, machine, orientation, loc, diag))
		return false;
	count = problem.chain.count == 1 ? solve_one(&problem, solutions) : solve_two(&problem, solutions);
	if (count == 2 && solutions[1].found &&
	    (!solutions[0].found || solutions[1].way < solutions[0].way - TIE_TOLERANCE))
		chosen = 1;
	if (count == 0 || !solutions[chosen].found) {
		diag_error(diag, loc, count == 0 ? "the rotary axes of this machine cannot stand the tool on this plane"
						 : "within the limits of their travel, the rotary axes cannot stand "
						   "the tool on this plane");
		return false;
	}
	tell(&problem, solutions, count, chosen, loc, diag);
	for (size_t i = 0; i < problem.chain.count; i++)
		orientation->rotary.v[problem.chain.joints[i].slot] = solutions[chosen].angle[i];
	return true;
}
