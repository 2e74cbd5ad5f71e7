#include "motion/tcp.h"

#include "base/minmax.h"
#include "base/same_double.h"
#include "geom/tolerance.h"

#include <float.h>
#include <math.h>

/* The deepest link that carries both; a link has a higher number than its carrier. */
static int common_link(const struct machine *machine, int a, int b)
{
	while (a != b) {
		int *higher = a > b ? &a : &b;

		*higher = machine->axes[*higher - 1].parent;
	}
	return a;
}

/* Moves the linear joints from the chain to the columns of M and N; they must come first. */
static bool take_linear(struct tcp *tcp, struct chain *chain, double sense, bool found[SLOT_COUNT], struct srcloc loc,
			struct diag *diag)
{
	vec3 *columns[3] = {&tcp->matrix.x, &tcp->matrix.y, &tcp->matrix.z};
	size_t kept = 0;

	for (size_t i = 0; i < chain->count; i++) {
		struct joint joint = chain->joints[i];

		if (joint.rotary) {
			chain->joints[kept++] = joint;
			continue;
		}
		if (kept) {
			diag_error(diag, loc,
				   "tool centre point control is not supported for this machine: linear axis %c is "
				   "carried by rotary axis %c; every linear axis must be nearer the base than the "
				   "rotary axes",
				   AXIS_LETTERS[joint.slot], AXIS_LETTERS[chain->joints[kept - 1].slot]);
			return false;
		}
		found[joint.slot] = true;
		if (joint.slot <= SLOT_Z)
			*columns[joint.slot] = vec3_scale(sense, joint.direction);
		else
			tcp->others[joint.slot] = vec3_scale(sense, joint.direction);
		tcp->has_others |= joint.slot > SLOT_Z;
	}
	chain->count = kept;
	return true;
}

static bool invert(struct tcp *tcp, struct srcloc loc, struct diag *diag)
{
	const mat3 *m = &tcp->matrix;
	vec3 yz = vec3_cross(m->y, m->z);
	double determinant = vec3_dot(m->x, yz);

	if (!(fabs(determinant) > LEAST_DETERMINANT)) {
		diag_error(diag, loc,
			   "tool centre point control needs axes X, Y and Z that span space; on this machine their "
			   "directions are in one plane");
		return false;
	}
	tcp->rows[0] = vec3_scale(1 / determinant, yz);
	tcp->rows[1] = vec3_scale(1 / determinant, vec3_cross(m->z, m->x));
	tcp->rows[2] = vec3_scale(1 / determinant, vec3_cross(m->x, m->y));
	return true;
}

static bool derive_axes(struct tcp *tcp, const struct machine *machine, struct srcloc loc, struct diag *diag)
{
	int base = common_link(machine, machine->workholding.link, machine->spindle.link);
	bool found[SLOT_COUNT] = {false};

	chain_init(&tcp->table, machine, base, machine->workholding.link);
	chain_init(&tcp->head, machine, base, machine->spindle.link);
	if (!take_linear(tcp, &tcp->table, -1, found, loc, diag) || !take_linear(tcp, &tcp->head, 1, found, loc, diag))
		return false;
	for (int slot = SLOT_X; slot <= SLOT_Z; slot++) {
		if (found[slot])
			continue;
		diag_error(diag, loc, "tool centre point control needs linear axes X, Y and Z between the workpiece "
				      "and the tool; this machine has no such axis %c", AXIS_LETTERS[slot]);
		return false;
	}
	return invert(tcp, loc, diag);
}

/* Adds the lengths of a chain's constant vectors, twice each. */
static void add_chain_lengths(const struct chain *chain, double *lengths)
{
	for (size_t k = 0; k < chain->count; k++)
		*lengths += 2 * vec3_norm(chain->joints[k].location);
}

static void take_norms(struct tcp *tcp)
{
	const vec3 columns[3] = {tcp->matrix.x, tcp->matrix.y, tcp->matrix.z};

	tcp->lengths = vec3_norm(tcp->gauge_zero) + vec3_norm(tcp->tip);
	add_chain_lengths(&tcp->table, &tcp->lengths);
	add_chain_lengths(&tcp->head, &tcp->lengths);
	for (int slot = SLOT_X; slot <= SLOT_Z; slot++) {
		tcp->row_norms[slot] = vec3_norm(tcp->rows[slot]);
		tcp->condition += tcp->row_norms[slot];
		tcp->axis_norms[slot] = vec3_norm(columns[slot]);
	}
	for (int slot = SLOT_U; slot < SLOT_COUNT; slot++)
		tcp->axis_norms[slot] = vec3_norm(tcp->others[slot]);
}

bool tcp_init(struct tcp *tcp, const struct machine *machine, const struct kinematics_tcp *state, struct srcloc loc,
	      struct diag *diag)
{
	struct tcp made = {.state = *state};
	vec3 gauge = machine->spindle.location;
	xform head, table;

	if (!machine->spindle.present || !machine->workholding.present) {
		diag_error(diag, loc, "tool centre point control needs a <%s> in the machine file",
			   machine->spindle.present ? "workholding" : "spindle");
		return false;
	}
	if (!derive_axes(&made, machine, loc, diag))
		return false;
	table = chain_pose(&made.table, &state->rotary_zero);
	head = chain_pose(&made.head, &state->rotary_zero);
	made.table_zero_inverse = xform_inverse(&table);
	made.gauge_zero = xform_apply(&head, gauge);
	made.spindle = machine->spindle.direction;
	made.tip = vec3_mad(gauge, state->length, machine->spindle.direction);
	take_norms(&made);
	*tcp = made;
	return true;
}

/* N u, or its derivative. */
static vec3 other_axes(const struct tcp *tcp, const axis_values *q)
{
	vec3 sum = {0, 0, 0};

	for (int slot = SLOT_U; slot < SLOT_COUNT && tcp->has_others; slot++)
		sum = vec3_mad(sum, q->v[slot], tcp->others[slot]);
	return sum;
}

static vec3 linear_axes(const struct tcp *tcp, const axis_values *q)
{
	return mat3_apply(&tcp->matrix, (vec3){q->v[SLOT_X], q->v[SLOT_Y], q->v[SLOT_Z]});
}

static axis_values with_linear_axes(const struct tcp *tcp, const axis_values *q, vec3 offset)
{
	axis_values out = *q;

	for (int slot = SLOT_X; slot <= SLOT_Z; slot++)
		out.v[slot] = vec3_dot(tcp->rows[slot], offset);
	return out;
}

/* The position of the tip as the head carries it; on many machines only the table rotates. */
static vec3 carried_tip(const struct tcp *tcp, const axis_values *position)
{
	xform head;

	if (tcp->head.count == 0)
		return tcp->tip;
	head = chain_pose(&tcp->head, position);
	return xform_apply(&head, tcp->tip);
}

axis_values tcp_to_machine(const struct tcp *tcp, const axis_values *position)
{
	vec3 others = other_axes(tcp, position);
	vec3 at_zero = vec3_add(vec3_add(linear_axes(tcp, position), others), tcp->gauge_zero);
	xform table = chain_pose(&tcp->table, position);
	vec3 wanted = xform_apply(&table, xform_apply(&tcp->table_zero_inverse, at_zero));
	vec3 tip = carried_tip(tcp, position);

	return with_linear_axes(tcp, position, vec3_sub(vec3_sub(wanted, tip), others));
}

axis_values tcp_from_machine(const struct tcp *tcp, const axis_values *machine)
{
	vec3 others = other_axes(tcp, machine);
	xform table = chain_pose(&tcp->table, machine);
	xform head = chain_pose(&tcp->head, machine);
	xform table_inverse = xform_inverse(&table);
	xform table_zero = xform_inverse(&tcp->table_zero_inverse);
	vec3 tip = vec3_add(vec3_add(linear_axes(tcp, machine), others), xform_apply(&head, tcp->tip));
	vec3 at_zero = xform_apply(&table_zero, xform_apply(&table_inverse, tip));

	return with_linear_axes(tcp, machine, vec3_sub(vec3_sub(at_zero, tcp->gauge_zero), others));
}

/* A point as the innermost joint of a chain carries it, in the middle of the interval. */
struct carried {
	vec3 point;
	vec3 velocity;
	double acceleration;	/* bound over the interval */
};

/*
 * The largest effect, by the row of M^-1, of a unit vector perpendicular to `axis`, if the axis deviates by at most
 * `lean` radians from its direction in the middle.
 */
static double share(const struct tcp *tcp, int slot, vec3 axis, double lean)
{
	double whole = tcp->row_norms[slot];

	return smaller(whole, vec3_norm(vec3_cross(axis, tcp->rows[slot])) + whole * lean);
}

/*
 * Adds the contribution of the rotation about the chain's joints. From the innermost joint outward, x' and x'' of the
 * carried point follow from
 *     x -> E(theta) x:   x'' -> R (omega^2 d x (d x r) + 2 omega d x x' + x'')
 * A bound over the interval is the value in the middle plus half the interval times the bound of the next derivative.
 * The first two terms are perpendicular to the joint's axis: a row of M^-1 along the axis is not affected by them.
 */
static void add_chain_second_derivative(const struct tcp *tcp, const struct chain *chain, struct carried carried,
					const axis_values *middle, const axis_values *rate, double half,
					axis_values *second_derivative)
{
	mat3 turns[SLOT_COUNT], outer;	/* of the joints outside of k, for k > 0 */
	vec3 axes[SLOT_COUNT];
	double leans[SLOT_COUNT], lean = 0;

	for (size_t k = 0; k < chain->count; k++) {
		const struct joint *joint = &chain->joints[k];

		turns[k] = mat3_turn(joint->direction, middle->v[joint->slot]);
		axes[k] = k ? mat3_apply(&outer, joint->direction) : joint->direction;
		leans[k] = lean;
		if (k + 1 < chain->count)
			outer = k ? mat3_mul(&outer, &turns[k]) : turns[k];
		lean += half * fabs(rate->v[joint->slot]);
	}
	for (size_t k = chain->count; k-- > 0;) {
		const struct joint *joint = &chain->joints[k];
		vec3 d = joint->direction, r = vec3_sub(carried.point, joint->location);
		double omega = rate->v[joint->slot], turn = fabs(omega);
		double across = vec3_norm(vec3_cross(d, carried.velocity)) + half * carried.acceleration;
		double cancelled = POSITION_ROUNDING * (vec3_norm(carried.point) + vec3_norm(joint->location));
		double rho = vec3_norm(vec3_cross(d, r)) + half * across + cancelled;
		double own = turn * (turn * rho + 2 * across);

		for (int slot = SLOT_X; slot <= SLOT_Z; slot++)
			second_derivative->v[slot] += own * share(tcp, slot, axes[k], leans[k]);
		if (k == 0)
			break;
		carried.velocity = mat3_apply(&turns[k], vec3_mad(carried.velocity, omega, vec3_cross(d, r)));
		carried.point = vec3_add(joint->location, mat3_apply(&turns[k], r));
		carried.acceleration += own;
	}
}

/* A chain whose joints do not move adds no curvature. */
static bool is_turning(const struct chain *chain, const axis_values *rate)
{
	for (size_t k = 0; k < chain->count; k++) {
		if (!same_double(rate->v[chain->joints[k].slot], 0))
			return true;
	}
	return false;
}

axis_values tcp_bend(const struct tcp *tcp, const axis_values *middle, const axis_values *rate, double acceleration,
		     double half)
{
	axis_values second_derivative = {{0}};

	for (int slot = SLOT_X; slot <= SLOT_Z; slot++)
		second_derivative.v[slot] = tcp->row_norms[slot] * acceleration;
	if (is_turning(&tcp->table, rate)) {
		vec3 at_zero = vec3_add(vec3_add(linear_axes(tcp, middle), other_axes(tcp, middle)), tcp->gauge_zero);
		vec3 velocity = vec3_add(linear_axes(tcp, rate), other_axes(tcp, rate));
		struct carried workpiece = {xform_apply(&tcp->table_zero_inverse, at_zero),
					    mat3_apply(&tcp->table_zero_inverse.rotation, velocity), acceleration};

		add_chain_second_derivative(tcp, &tcp->table, workpiece, middle, rate, half, &second_derivative);
	}
	if (is_turning(&tcp->head, rate)) {
		struct carried tip = {tcp->tip, {0, 0, 0}, 0};

		add_chain_second_derivative(tcp, &tcp->head, tip, middle, rate, half, &second_derivative);
	}
	return second_derivative;
}

/*
 * An upper bound of the way of a point that the chain carries, if its rotary joints differ by `turn` from their
 * positions. The reach grows from joint to joint, outward.
 */
static double chain_swing(const struct chain *chain, double reach, const double turn[3])
{
	double sum = 0;

	for (size_t k = chain->count; k-- > 0;) {
		const struct joint *joint = &chain->joints[k];

		sum += joint->slot >= SLOT_A && joint->slot <= SLOT_C ? reach * turn[joint->slot - SLOT_A] : 0;
		if (k > 0)
			reach += vec3_norm(vec3_sub(joint->location, chain->joints[k - 1].location));
	}
	return sum;
}

static double reach_of(const struct chain *chain, vec3 point)
{
	return chain->count ? vec3_norm(vec3_sub(point, chain->joints[chain->count - 1].location)) : 0;
}

axis_values tcp_follow(const struct tcp *tcp, const axis_values *start, const axis_values *end, const double turn[3])
{
	const axis_values *ends[2] = {start, end};
	axis_values follow = {{0}};
	double reach = 0, swing;

	/* A distance to a fixed point is largest at an end of a straight path. */
	for (int i = 0; i < 2; i++) {
		const vec3 at_zero =
		    vec3_add(vec3_add(linear_axes(tcp, ends[i]), other_axes(tcp, ends[i])), tcp->gauge_zero);

		reach = fmax(reach, reach_of(&tcp->table, xform_apply(&tcp->table_zero_inverse, at_zero)));
	}
	swing = chain_swing(&tcp->table, reach, turn) + chain_swing(&tcp->head, reach_of(&tcp->head, tcp->tip), turn);
	for (int slot = SLOT_X; slot <= SLOT_Z; slot++)
		follow.v[slot] = vec3_norm(tcp->rows[slot]) * swing;
	return follow;
}

static bool turns_between(const struct chain *chain, const axis_values *start, const axis_values *end)
{
	for (size_t k = 0; k < chain->count; k++) {
		const int slot = chain->joints[k].slot;

		if (!same_double(start->v[slot], end->v[slot]))
			return true;
	}
	return false;
}

axis_values tcp_spread(const struct tcp *tcp, const axis_values *start, const axis_values *end, const double spread[3])
{
	const vec3 columns[3] = {tcp->matrix.x, tcp->matrix.y, tcp->matrix.z};
	const bool turns = turns_between(&tcp->table, start, end);
	const xform table = chain_pose(&tcp->table, start);
	axis_values most = {{0}};

	for (int i = 0; i < 3; i++) {
		const vec3 side = vec3_scale(spread[i], columns[i]);
		const vec3 turned =
		    mat3_apply(&table.rotation, mat3_apply(&tcp->table_zero_inverse.rotation, side));

		/* While the table rotates, the side may have any direction. */
		for (int slot = SLOT_X; slot <= SLOT_Z; slot++)
			most.v[slot] += turns ? vec3_norm(tcp->rows[slot]) * vec3_norm(side)
					      : fabs(vec3_dot(tcp->rows[slot], turned));
	}
	return most;
}

void tcp_turn(const struct tcp *tcp, struct kinematics_turn *turn)
{
	const xform table = chain_pose(&tcp->table, &turn->rotary), head = chain_pose(&tcp->head, &turn->rotary);
	const xform head_zero = chain_pose(&tcp->head, &turn->rotary_zero);
	const vec3 columns[3] = {tcp->matrix.x, tcp->matrix.y, tcp->matrix.z};
	const vec3 spindle = vec3_scale(-1, tcp->spindle);
	vec3 found[4];

	for (int i = 0; i < 4; i++) {
		/* The head carries the directions and the spindle. */
		const vec3 at_head = i < 3 ? mat3_apply_transposed(&head_zero.rotation, columns[i]) : spindle;
		const vec3 on_table = mat3_apply_transposed(&table.rotation, mat3_apply(&head.rotation, at_head));
		const vec3 on_work = mat3_apply_transposed(&tcp->table_zero_inverse.rotation, on_table);

		found[i] = (vec3){vec3_dot(tcp->rows[0], on_work), vec3_dot(tcp->rows[1], on_work),
				  vec3_dot(tcp->rows[2], on_work)};
	}
	turn->turn = (mat3){found[0], found[1], found[2]};
	turn->tool = vec3_unit(found[3]);
}

/* Adds the angles whose rounding is multiplied by the lengths. */
static void add_chain_angles(const struct tcp *tcp, const struct chain *chain, const axis_values *reach, double *angles)
{
	for (size_t k = 0; k < chain->count; k++) {
		const int slot = chain->joints[k].slot;

		*angles += reach->v[slot] + fabs(tcp->state.rotary_zero.v[slot]);
	}
}

axis_values tcp_rounding(const struct tcp *tcp, const axis_values *reach)
{
	double scale = tcp->lengths, angles = 1;
	axis_values rounding = {{0}};

	add_chain_angles(tcp, &tcp->table, reach, &angles);
	add_chain_angles(tcp, &tcp->head, reach, &angles);
	for (int slot = SLOT_X; slot <= SLOT_Z; slot++)
		scale += tcp->axis_norms[slot] * reach->v[slot];
	for (int slot = SLOT_U; slot < SLOT_COUNT; slot++)
		scale += 2 * tcp->axis_norms[slot] * reach->v[slot];
	for (int slot = SLOT_X; slot <= SLOT_Z; slot++)
		rounding.v[slot] =
		    POSITION_ROUNDING * tcp->row_norms[slot] * scale * (angles + tcp->condition);
	return rounding;
}
