#include "motion/orient.h"

#include <math.h>

#include "base/math/math_functions.h"
#include "base/strbuf.h"
#include "base/units.h"
#include "geom/tolerance.h"
#include "machine/chain.h"
#include "motion/tcp.h"

struct problem {
	const struct machine *machine;
	const axis_values *here;
	struct chain chain;	/* rotary joints from the workpiece to the spindle */
	size_t first;	/* the joint whose way counts first */
	vec3 tool;	/* from the tip to the spindle at the zero pose */
	vec3 wanted;	/* the same in the workpiece's frame */
	const char *command;	/* for messages */
};

struct solution {
	double angle[2];	/* of the chain's joints, radians */
	double way[2];	/* of each joint from here */
	int half_turn;	/* the joint that could as well rotate the other way, or -1 */
	bool tie[2];
	bool found;	/* some turn of it is within the limits */
	bool free[2];	/* every angle is a solution */
};

/* The angle about the unit axis that rotates `from` to `to`; both have the same component along the axis. */
static double angle_about(vec3 axis, vec3 from, vec3 to)
{
	vec3 a = vec3_mad(from, -vec3_dot(axis, from), axis), b = vec3_mad(to, -vec3_dot(axis, to), axis);

	return math_atan2(vec3_dot(axis, vec3_cross(a, b)), vec3_dot(a, b));
}

static bool is_along(vec3 axis, vec3 direction)
{
	return vec3_norm(vec3_cross(axis, direction)) < DIRECTION_REACHED;
}

/*
 * The position within the limits that is nearest to `here`, whole turns from the angle. *tie: another one is equally
 * near, and which one the control takes is unknown.
 */
static bool nearest_turn(const struct axis *axis, double angle, double here, double *nearest, bool *tie)
{
	double low = ceil((axis->limit_min - radians(LIMIT_TOLERANCE) - angle) / (2 * PI));
	double high = floor((axis->limit_max + radians(LIMIT_TOLERANCE) - angle) / (2 * PI));
	double turns = (here - angle) / (2 * PI), best = round(turns), k, other;
	bool equal;

	if (low > high)
		return false;
	other = turns > best ? best + 1 : best - 1;
	equal = best >= low && best <= high && other >= low && other <= high &&
		2 * PI * fabs(fabs(turns - best) - fabs(turns - other)) < TIE_TOLERANCE;
	*tie = equal && !axis->half_turn;
	if (equal && axis->half_turn)
		best = axis->half_turn > 0 ? fmax(best, other) : fmin(best, other);
	k = fmin(fmax(best, low), high);
	/* Removes an excess over the limits by rounding. */
	*nearest = fmin(fmax(angle + 2 * PI * k, axis->limit_min), axis->limit_max);
	return true;
}

static void settle(const struct problem *problem, struct solution *solution)
{
	solution->found = true;
	solution->half_turn = -1;
	for (size_t i = 0; i < problem->chain.count; i++) {
		int slot = problem->chain.joints[i].slot;
		double here = problem->here->v[slot];
		bool tie = false;

		if (solution->free[i])
			solution->angle[i] = here;
		else if (!nearest_turn(machine_axis(problem->machine, slot), solution->angle[i], here,
				       &solution->angle[i], &tie))
			solution->found = false;
		solution->way[i] = fabs(solution->angle[i] - here);
		solution->tie[i] = tie;
		if (tie)
			solution->half_turn = (int)i;
	}
}

/* -1: a is smaller; 1: b is; 0: equal. */
static int compare(double a, double b)
{
	return fabs(a - b) < TIE_TOLERANCE ? 0 : a < b ? -1 : 1;
}

/*
 * Fanuc 16i/18i-B operator's manual (B-63534EN) and 30i-B (B-64484EN), tool axis direction control, "Angle of rotation
 * axis". The shorter way of the first axis decides, then that of the second, then the position of the first axis nearer
 * to a whole turn, then that of the second. The first axis is the one that carries the other; with one in the table and
 * one in the head, the one in the table. Negative: the control takes a.
 */
static int prefer(const struct problem *problem, const struct solution *a, const struct solution *b)
{
	size_t order[2] = {problem->first, 1 - problem->first};

	if (a->found != b->found)
		return a->found ? -1 : 1;
	for (size_t i = 0; i < 2; i++) {
		int by = compare(a->way[order[i]], b->way[order[i]]);

		if (by)
			return by;
	}
	for (size_t i = 0; i < 2; i++) {
		int by = compare(fabs(remainder(a->angle[order[i]], 2 * PI)),
				 fabs(remainder(b->angle[order[i]], 2 * PI)));

		if (by)
			return by;
	}
	return 0;
}

/* One rotary axis: the direction must lie on the cone that the tool describes. */
static size_t solve_one(const struct problem *problem, struct solution solutions[2])
{
	vec3 axis = problem->chain.joints[0].direction;

	if (fabs(vec3_dot(axis, problem->tool) - vec3_dot(axis, problem->wanted)) > DIRECTION_REACHED)
		return 0;
	solutions[0].free[0] = is_along(axis, problem->tool);
	solutions[0].angle[0] = angle_about(axis, problem->tool, problem->wanted);
	settle(problem, &solutions[0]);
	return 1;
}

/*
 * wanted = turn(a, alpha) turn(b, beta) tool. Let c = turn(b, beta) tool = turn(a, -alpha) wanted. It is a unit vector
 * with b.c = b.tool and a.c = a.wanted: c = x a + y b +- z (a x b). (Paden and Kahan's second subproblem: Murray, Li,
 * Sastry, "A Mathematical Introduction to Robotic Manipulation", 3.3.2.)
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
	if (zz < -DIRECTION_REACHED)
		return 0;
	z = sqrt(fmax(zz, 0));
	count = z * sqrt(s) < DIRECTION_REACHED ? 1 : 2;
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
	for (size_t i = 0; i < problem->chain.count; i++) {
		const double angle = degrees(solution->angle[i]);

		strbuf_addf(text, "%s%c%.6g", i ? " " : "", AXIS_LETTERS[problem->chain.joints[i].slot],
			    fabs(angle) < SAME_DEGREES ? 0 : angle);
	}
}

/* Adds why the other solution was not taken. */
static void add_reason(struct strbuf *text, const struct problem *problem, const struct solution *chosen,
		       const struct solution *other)
{
	size_t order[2] = {problem->first, 1 - problem->first};

	if (!other->found) {
		strbuf_addf(text, ", is outside the limits");
		return;
	}
	for (size_t i = 0; i < 2; i++) {
		if (compare(chosen->way[order[i]], other->way[order[i]])) {
			strbuf_addf(text,
				    ", needs a longer move of %c", AXIS_LETTERS[problem->chain.joints[order[i]].slot]);
			return;
		}
	}
	strbuf_addf(text, ", needs equal moves, but is farther from 0");
}

static void tell_solution(const struct problem *problem, const struct solution solutions[2], size_t count,
			  size_t chosen, struct srcloc loc, struct diag *diag)
{
	const struct solution *other = count == 2 ? &solutions[1 - chosen] : NULL;
	struct strbuf text = {0};

	strbuf_addf(&text, "%s turns to ", problem->command);
	add_solution(&text, problem, &solutions[chosen]);
	if (other) {
		strbuf_addf(&text, "; the other solution, ");
		add_solution(&text, problem, other);
		add_reason(&text, problem, &solutions[chosen], other);
	}
	diag_note(diag, loc, "%s", strbuf_text(&text));
	strbuf_release(&text);
}

/* Which solution the control would take is unknown, so this is an error. Returns false. */
static bool fault_tie(const struct problem *problem, const struct solution *one, const struct solution *other,
		      struct srcloc loc, struct diag *diag)
{
	struct solution turned = *one;
	struct strbuf text = {0};

	if (!other) {
		double here = problem->here->v[problem->chain.joints[one->half_turn].slot];

		turned.angle[one->half_turn] = 2 * here - one->angle[one->half_turn];
		other = &turned;
	}
	strbuf_addf(&text, "G53.1 could turn to ");
	add_solution(&text, problem, one);
	strbuf_addf(&text, " or to ");
	add_solution(&text, problem, other);
	strbuf_addf(&text,
		    ", which are equally near: turn the rotary axes towards the intended position in a block before");
	if (other == &turned)
		strbuf_addf(&text, ", or give half_turn to axis %c in the machine file",
			    AXIS_LETTERS[problem->chain.joints[one->half_turn].slot]);
	diag_error(diag, loc, "%s", strbuf_text(&text));
	strbuf_release(&text);
	return false;
}

/* Keeps only the chain's rotary joints. */
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
	return fabs(vec3_dot(m->x, m->y)) < DIRECTION_REACHED && fabs(vec3_dot(m->y, m->z)) < DIRECTION_REACHED &&
	       fabs(vec3_dot(m->z, m->x)) < DIRECTION_REACHED && vec3_dot(vec3_cross(m->x, m->y), m->z) > 0;
}

static bool set_problem(struct problem *problem, const struct machine *machine,
			const struct kinematics_orientation *orientation, struct srcloc loc, struct diag *diag)
{
	const struct kinematics_tcp state = {.on = true, .rotary_zero = orientation->rotary_zero};
	struct tcp tcp;

	if (!tcp_init(&tcp, machine, &state, loc, diag))
		return false;
	if (!is_orthonormal(&tcp.matrix)) {
		diag_error(diag, loc, "a tilted plane needs a right-handed system of perpendicular axes X, Y and Z");
		return false;
	}
	*problem = (struct problem){.machine = machine,
				    .here = &orientation->rotary,
				    .command = orientation->command ? orientation->command : "G53.1"};
	chain_init(&problem->chain, machine, machine->workholding.link, machine->spindle.link);
	drop_linear(&problem->chain);
	problem->first = tcp.table.count == 2 ? 1 : 0;
	problem->tool = vec3_scale(-1, machine->spindle.direction);
	problem->wanted = mat3_apply(&tcp.table_zero_inverse.rotation,
				     mat3_apply(&tcp.matrix, orientation->direction));
	if (problem->chain.count == 1 || problem->chain.count == 2)
		return true;
	diag_error(diag, loc, "%s needs one or two rotary axes between the workpiece and the tool; this machine "
			      "has %zu", problem->command, problem->chain.count);
	return false;
}

bool orient_tool(const struct machine *machine, struct srcloc loc, struct diag *diag,
		 struct kinematics_orientation *orientation)
{
	struct solution solutions[2] = {{.found = false}};
	struct problem problem;
	size_t count, chosen = 0;

	if (!set_problem(&problem, machine, orientation, loc, diag))
		return false;
	count = problem.chain.count == 1 ? solve_one(&problem, solutions) : solve_two(&problem, solutions);
	if (count == 2 && prefer(&problem, &solutions[1], &solutions[0]) < 0)
		chosen = 1;
	if (count == 0 || !solutions[chosen].found) {
		diag_error(diag, loc, count == 0 ? "the rotary axes of this machine cannot turn the tool perpendicular "
						   "to this plane"
						 : "within their limits, the rotary axes cannot turn the tool "
						   "perpendicular to this plane");
		return false;
	}
	if (count == 2 && prefer(&problem, &solutions[0], &solutions[1]) == 0)
		return fault_tie(&problem, &solutions[0], &solutions[1], loc, diag);
	if (solutions[chosen].half_turn >= 0)
		return fault_tie(&problem, &solutions[chosen], NULL, loc, diag);
	tell_solution(&problem, solutions, count, chosen, loc, diag);
	for (size_t i = 0; i < problem.chain.count; i++)
		orientation->rotary.v[problem.chain.joints[i].slot] = solutions[chosen].angle[i];
	return true;
}

bool orient_solutions(const struct machine *machine, struct srcloc loc, struct diag *diag,
		      const struct kinematics_orientation *orientation, struct kinematics_solutions *solutions)
{
	struct kinematics_solutions made = {0};
	struct solution found[2] = {{.found = false}};
	struct problem problem;

	if (!set_problem(&problem, machine, orientation, loc, diag))
		return false;
	made.count = problem.chain.count == 1 ? solve_one(&problem, found) : solve_two(&problem, found);
	made.primary = problem.chain.joints[problem.chain.count - 1].slot;
	for (size_t i = 0; i < made.count; i++) {
		struct kinematics_solution *item = &made.items[i];

		item->rotary = orientation->rotary;
		item->within_limits = found[i].found;
		for (size_t k = 0; k < problem.chain.count; k++) {
			int slot = problem.chain.joints[k].slot;

			item->rotary.v[slot] = found[i].angle[k];
			item->free[slot] = found[i].free[k];
			item->tie[slot] = found[i].tie[k];
		}
	}
	*solutions = made;
	return true;
}
