/* motion.cpp - the motion of the axes in a move. */
#include <algorithm>

#include "program.h"

/* The shift of the head minus that of the table, for 1 mm of X, Y and Z: the columns. */
static void shifts(const Machine &machine, vec columns[3])
{
	for (int k = 0; k < 3; k++) {
		int i = machine.axis("XYZ"[k]);
		int link = machine.spindle;

		while (link && link != i + 1)
			link = machine.world.axes[link - 1].parent;
		columns[k] = times(link ? 1 : -1, machine.world.axes[i].direction);
	}
}

/* Only the rotary axes of a chain: the linear axes are nearer to the base, and their motions are added. */
static pose turned(const Machine &machine, int link, const Position &q)
{
	Position only = q;
	pose poses[AXES_MAX + 1];

	for (int i = 0; i < machine.world.axis_count; i++)
		if (!machine.world.axes[i].rotary)
			only[(size_t)i] = 0;
	link_poses(&machine.world, only.data(), poses);
	return poses[link];
}

static vec shift_of(const Machine &machine, const Position &q)
{
	vec columns[3], sum = {0, 0, 0};

	shifts(machine, columns);
	for (int k = 0; k < 3; k++)
		sum = add(sum, times(q[(size_t)machine.axis("XYZ"[k])], columns[k]));
	return sum;
}

/* Cramer's rule. */
static vec solve(const vec columns[3], vec b)
{
	double whole = dot(columns[0], cross(columns[1], columns[2]));

	return vec_of(dot(b, cross(columns[1], columns[2])) / whole, dot(columns[0], cross(b, columns[2])) / whole,
		      dot(columns[0], cross(columns[1], b)) / whole);
}

bool tip_can_follow(const Machine &machine)
{
	vec columns[3];

	if (!machine.follows_tip)
		return false;
	shifts(machine, columns);
	return std::fabs(dot(columns[0], cross(columns[1], columns[2]))) > 0.3;
}

static vec tip_of(const Machine &machine, double length)
{
	return add(machine.gauge, times(length, machine.tool_direction));
}

vec tip_at(const Machine &machine, const Position &q, double length)
{
	pose head = turned(machine, machine.spindle, q), table = turned(machine, machine.table, q);
	pose back = inverse(&table);

	return apply(&back, add(shift_of(machine, q), apply(&head, tip_of(machine, length))));
}

Position follow_tip(const Machine &machine, const Position &q, vec tip, double length)
{
	pose head = turned(machine, machine.spindle, q), table = turned(machine, machine.table, q);
	vec columns[3], xyz;
	Position out = q;

	shifts(machine, columns);
	xyz = solve(columns, sub(apply(&table, tip), apply(&head, tip_of(machine, length))));
	out[(size_t)machine.axis('X')] = xyz.x;
	out[(size_t)machine.axis('Y')] = xyz.y;
	out[(size_t)machine.axis('Z')] = xyz.z;
	return out;
}

vec commanded_for(const Machine &machine, vec tip)
{
	vec columns[3];

	shifts(machine, columns);
	return solve(columns, sub(tip, machine.gauge));
}

vec tip_for(const Machine &machine, vec commanded)
{
	vec columns[3];

	shifts(machine, columns);
	return add(machine.gauge, add(times(commanded.x, columns[0]),
				      add(times(commanded.y, columns[1]), times(commanded.z, columns[2]))));
}

static void on_arc(const Move &move, double s, Position &q)
{
	auto i = (size_t)move.first, j = (size_t)move.second;
	double x = move.from[i] - move.centre[0], y = move.from[j] - move.centre[1];
	/* With rounded words, start and end are on circles that differ a little. */
	double start = std::hypot(x, y), end = std::hypot(move.to[i] - move.centre[0], move.to[j] - move.centre[1]);
	double radius = (1 - s) * start + s * end, angle = std::atan2(y, x) + s * move.sweep;

	q[i] = move.centre[0] + radius * std::cos(angle);
	q[j] = move.centre[1] + radius * std::sin(angle);
}

static void on_dogleg(const Machine &machine, const Move &move, double s, Position &q)
{
	double longest = 0;

	for (size_t i = 0; i < machine.travels.size(); i++)
		longest = std::max(longest, std::fabs(move.to[i] - move.from[i]) / machine.travels[i].rate);
	for (size_t i = 0; i < machine.travels.size(); i++) {
		double own = std::fabs(move.to[i] - move.from[i]) / machine.travels[i].rate;
		double share = own > 0 ? std::min(1.0, s * longest / own) : 0;

		q[i] = move.from[i] + share * (move.to[i] - move.from[i]);
	}
}

Position position(const Machine &machine, const Move &move, double s)
{
	Position q = {};

	if (move.path == Path::DOGLEG) {
		on_dogleg(machine, move, s, q);
		return q;
	}
	for (size_t i = 0; i < machine.travels.size(); i++)
		q[i] = (1 - s) * move.from[i] + s * move.to[i];
	if (move.path == Path::ARC)
		on_arc(move, s, q);
	if (move.path == Path::TIP)
		return follow_tip(machine, q, add(times(1 - s, move.tip_from), times(s, move.tip_to)), move.length);
	return q;
}
