#include "compare.h"

#include <algorithm>
#include <cstdio>

#include "../bench/travel.h"

/* mm: the rounding of FCL's distances, and of twelve digits in a report. */
static const double ROUNDING = 1e-6;

/* A position this near to an end of the travel is at the end, as for fivecheck; mm or degrees. */
static const double ON_THE_LIMIT = 1e-6;

/* Samples along a curved move for the axis limits. */
static const int LIMIT_LOOKS = 400;

class Judge {
public:
	Judge(const Machine &machine, const Program &program, const Truth &truth, const Verdict &all,
	      const Terms &terms)
		: machine_(machine), program_(program), truth_(truth), all_(all), terms_(terms)
	{
	}

	Comparison judge();

private:
	void object(const char *what, const std::string &where, double figure);
	const Move *move_at(int line) const;
	const Pair *pair_of(const Finding &finding) const;
	double slack(const Pair &pair) const;
	double excess(const Move &move, int axis, double s) const;
	double largest_excess(const Move &move, int axis) const;
	void judge_limit(const Finding &finding, const Move &move);
	void judge_finding(const Finding &finding);
	void look_for_limits(const Move &move);
	void look_for_contact(const Move &move, const Pair &pair);

	const Machine &machine_;
	const Program &program_;
	const Truth &truth_;
	const Verdict &all_;
	const Terms &terms_;
	Comparison out_;
};

void Judge::object(const char *what, const std::string &where, double figure)
{
	char text[64];

	std::snprintf(text, sizeof(text), ": %.9g: ", figure);
	out_.disagreements.push_back(what + std::string(text) + where);
}

const Move *Judge::move_at(int line) const
{
	for (const Move &move : program_.moves)
		if (move.line == line)
			return &move;
	return nullptr;
}

static bool names(const Machine &machine, const Pair &pair, const Finding &finding)
{
	const std::string &a = machine.bodies[(size_t)pair.bodies.a].name;
	const std::string &b = machine.bodies[(size_t)pair.bodies.b].name;

	return (a == finding.a && b == finding.b) || (a == finding.b && b == finding.a);
}

const Pair *Judge::pair_of(const Finding &finding) const
{
	for (const Pair &pair : machine_.pairs)
		if (pair.required && names(machine_, pair, finding))
			return &pair;
	return nullptr;
}

double Judge::slack(const Pair &pair) const
{
	return machine_.bodies[(size_t)pair.bodies.a].slack + machine_.bodies[(size_t)pair.bodies.b].slack;
}

/* -------------------------------------------------------------- axis limits */

/* How far an axis is outside its travel; negative: inside. */
double Judge::excess(const Move &move, int axis, double s) const
{
	double value = position(machine_, move, s)[(size_t)axis];

	return std::max(machine_.travels[(size_t)axis].low - value, value - machine_.travels[(size_t)axis].high);
}

double Judge::largest_excess(const Move &move, int axis) const
{
	int looks = move.path == Path::ARC || move.path == Path::TIP ? LIMIT_LOOKS : 1;
	double most = excess(move, axis, 0);

	for (int k = 1; k <= looks; k++)
		most = std::max(most, excess(move, axis, (double)k / looks));
	return most;
}

void Judge::judge_limit(const Finding &finding, const Move &move)
{
	int axis = machine_.axis(finding.axis[0]);
	double here = excess(move, axis, finding.fraction), most = largest_excess(move, axis);

	if (std::fabs(here) > terms_.tolerance + ROUNDING && finding.fraction > 0)
		object("limit at the wrong place", finding.text, here);
	/* Between two samples of a curve, its crest can be higher than both by little more than this. */
	if (most < 0.9 * ON_THE_LIMIT - (move.path == Path::ARC || move.path == Path::TIP ? 0.01 : 0))
		object("FALSE ALARM, limit", finding.text, most);
}

void Judge::look_for_limits(const Move &move)
{
	for (int axis = 0; axis < machine_.world.axis_count; axis++) {
		const char letter = machine_.world.axes[axis].letter;
		double most = largest_excess(move, axis);
		bool said = false;

		if (most < 1.1 * ON_THE_LIMIT + ROUNDING)
			continue;
		for (const Finding &finding : all_.findings)
			said |= finding.kind == "limit" && finding.line == move.line && finding.axis[0] == letter;
		if (!said)
			object("MISS, limit", "line " + std::to_string(move.line) + ", axis " + letter, most);
		if (!out_.first_line)
			out_.first_line = move.line;
	}
}

/* ----------------------------------------------------------------- contacts */

void Judge::judge_finding(const Finding &finding)
{
	const Move *move = move_at(finding.line);
	const Pair *pair = pair_of(finding);
	bool curved = move && (move->path == Path::ARC || move->path == Path::TIP);
	Position q = move ? position(machine_, *move, finding.fraction) : finding.at;
	double apart;

	if (finding.kind == "limit" && move) {
		judge_limit(finding, *move);
		return;
	}
	if (!pair) {
		object("FALSE ALARM, no such pair", finding.text, 0);
		return;
	}
	for (size_t i = 0; i < machine_.travels.size(); i++)
		if (std::fabs(q[i] - finding.at[i]) > (curved ? 1.2 * terms_.tolerance : 0) + 2 * ROUNDING)
			object("axes elsewhere", finding.text, q[i] - finding.at[i]);
	apart = truth_.distance(*pair, q);
	if (apart > (pair->core ? 0 : terms_.clearance) + terms_.tolerance + slack(*pair) + ROUNDING &&
	    !truth_.contained(*pair, q))
		object("FALSE ALARM", finding.text, apart);
}

void Judge::look_for_contact(const Move &move, const Pair &pair)
{
	double s = truth_.first_violation(pair, move, pair.core ? 0 : terms_.clearance), motion;
	std::string where = "line " + std::to_string(move.line) + " at " + decimal(s, 12) + ", " +
			    machine_.bodies[(size_t)pair.bodies.a].name + " and " +
			    machine_.bodies[(size_t)pair.bodies.b].name;
	const Finding *found = nullptr;

	for (const Finding &finding : all_.findings)
		if (finding.line == move.line && finding.kind != "limit" && names(machine_, pair, finding))
			found = &finding;
	if (s > 1) {
		out_.between += found != nullptr;
		return;
	}
	out_.contacts++;
	if (!out_.first_line)
		out_.first_line = move.line;
	if (!found) {
		object("MISS", where, truth_.distance(pair, position(machine_, move, s)));
		return;
	}
	if (found->fraction <= s)
		return;
	motion = travel_seen(&machine_.world, &pair.bodies, position(machine_, move, s).data(),
			     position(machine_, move, found->fraction).data());
	if (motion > 1.02 * terms_.tolerance)
		object("LATE", where + ": " + found->text, motion);
}

Comparison Judge::judge()
{
	for (const Finding &finding : all_.findings)
		judge_finding(finding);
	for (const Move &move : program_.moves) {
		look_for_limits(move);
		for (const Pair &pair : machine_.pairs)
			if (pair.required && !(pair.core && move.cuts) && truth_.present(pair, move.tool))
				look_for_contact(move, pair);
	}
	return out_;
}

Comparison compare(const Machine &machine, const Program &program, const Truth &truth, const Verdict &all,
		   const Terms &terms)
{
	return Judge(machine, program, truth, all, terms).judge();
}
