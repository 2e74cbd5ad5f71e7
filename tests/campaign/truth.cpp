#include "truth.h"

#include <algorithm>

#include <fcl/narrowphase/collision.h>
#include <fcl/narrowphase/distance.h>

#include "../bench/travel.h"

/* mm of motion between two samples where the bodies are near each other, and the most samples of a move. */
static const double FINEST = 0.01;
static const int LOOKS_MAX = 2000;

/* Curved paths: their motion is measured along chords, so a part of it is missed. */
static const int CHORDS = 8;
static const double CURVED = 1.25;
static const double LONGEST_CURVED = 1.0 / 32;

Truth::Truth(const Machine &machine) : machine_(machine)
{
	for (const solid &solid : machine.solids)
		models_.push_back(model_of<Volume>(solid));
}

double Truth::balls_apart(const Pair &pair, const pose *poses) const
{
	const solid &a = machine_.solids[(size_t)pair.bodies.a], &b = machine_.solids[(size_t)pair.bodies.b];

	return norm(sub(apply(&poses[a.link], a.middle), apply(&poses[b.link], b.middle))) - a.radius - b.radius;
}

/* FCL's distance is not always right where surfaces cross, so contact is asked separately. */
double Truth::distance(const Pair &pair, const Position &q) const
{
	auto a = (size_t)pair.bodies.a, b = (size_t)pair.bodies.b;
	fcl::CollisionRequest<double> meet{1, false};
	fcl::CollisionResult<double> met;
	fcl::DistanceRequest<double> ask;
	fcl::DistanceResult<double> answer;
	pose poses[AXES_MAX + 1];
	double apart = 0;

	link_poses(&machine_.world, q.data(), poses);
	fcl::Transform3<double> at = transform_of(poses[machine_.solids[a].link]);
	fcl::Transform3<double> bt = transform_of(poses[machine_.solids[b].link]);
	looks_++;
	if (!fcl::collide(models_[a].get(), at, models_[b].get(), bt, meet, met))
		apart = fcl::distance(models_[a].get(), at, models_[b].get(), bt, ask, answer);
	if (!pair.core)
		nearest_ = std::min(nearest_, apart);
	return apart;
}

bool Truth::contained(const Pair &pair, const Position &q) const
{
	const solid &a = machine_.solids[(size_t)pair.bodies.a], &b = machine_.solids[(size_t)pair.bodies.b];
	pose poses[AXES_MAX + 1];

	link_poses(&machine_.world, q.data(), poses);
	if (balls_apart(pair, poses) > 0)
		return false;
	pose back_a = inverse(&poses[a.link]), back_b = inverse(&poses[b.link]);
	vec of_b = apply(&poses[b.link], b.triangles[0].p[0]), of_a = apply(&poses[a.link], a.triangles[0].p[0]);

	return encloses(a, apply(&back_a, of_b)) || encloses(b, apply(&back_b, of_a));
}

bool Truth::violated(const Pair &pair, const Position &q, double clearance) const
{
	pose poses[AXES_MAX + 1];

	link_poses(&machine_.world, q.data(), poses);
	if (balls_apart(pair, poses) > clearance)
		return false;
	return distance(pair, q) <= clearance || contained(pair, q);
}

bool Truth::present(const Pair &pair, int tool) const
{
	return is_there(&machine_.world, &pair.bodies, tool);
}

double Truth::travel(const Pair &pair, const Move &move, double from, double to) const
{
	bool curved = move.path == Path::ARC || move.path == Path::TIP;
	/* A dogleg has corners: halving it is nearly as good as cutting it at them. */
	int chords = curved ? CHORDS : move.path == Path::DOGLEG ? 2 : 1;
	Position last = position(machine_, move, from);
	double way = 0;

	for (int k = 1; k <= chords; k++) {
		Position next = position(machine_, move, from + (to - from) * k / chords);

		way += travel_bound(&machine_.world, &pair.bodies, last.data(), next.data());
		last = next;
	}
	return curved ? CURVED * way : way;
}

double Truth::first_violation(const Pair &pair, const Move &move, double clearance) const
{
	bool curved = move.path == Path::ARC || move.path == Path::TIP;
	double longest = curved ? LONGEST_CURVED : 1, step = longest;
	double finest = std::max(FINEST, travel(pair, move, 0, 1) / LOOKS_MAX);
	pose poses[AXES_MAX + 1];

	if (contained(pair, position(machine_, move, 0)))
		return 0;
	for (double s = 0;; s += step) {
		Position q = position(machine_, move, s = std::min(s, 1.0));
		double apart, room, way;

		link_poses(&machine_.world, q.data(), poses);
		apart = balls_apart(pair, poses);
		if (apart <= clearance + finest)
			apart = distance(pair, q);
		if (apart <= clearance)
			return s;
		if (s >= 1)
			return 2;
		room = std::max(apart - clearance, finest);
		step = std::min(std::min(2 * step, longest), 1 - s);
		for (int tries = 0; (way = travel(pair, move, s, s + step)) > room && tries < 60; tries++)
			step *= std::min(0.9, 0.95 * room / way);
	}
}
