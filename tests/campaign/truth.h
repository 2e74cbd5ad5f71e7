/* truth.h - what FCL says of a program: every pair of bodies, looked at in steps that are fine where it is near. */
#ifndef CAMPAIGN_TRUTH_H
#define CAMPAIGN_TRUTH_H

#include <memory>
#include <vector>

#include <fcl/math/bv/OBBRSS.h>

#include "../bench/fcl_model.h"
#include "program.h"

class Truth {
public:
	explicit Truth(const Machine &machine);

	/* mm; 0 where the surfaces meet. */
	double distance(const Pair &pair, const Position &q) const;

	/* Do they meet, come nearer than the clearance, or is one inside the other? */
	bool violated(const Pair &pair, const Position &q, double clearance) const;

	/* Is one inside the other, surfaces apart? */
	bool contained(const Pair &pair, const Position &q) const;

	/* The first place of the move, 0 to 1, where a look finds the pair violated; 2 if none does. */
	double first_violation(const Pair &pair, const Move &move, double clearance) const;

	/* Do their tools, if any, stand in the spindle? */
	bool present(const Pair &pair, int tool) const;

	long looks() const
	{
		return looks_;
	}

	/* mm: the least distance of any look so far. */
	double nearest() const
	{
		return nearest_;
	}

private:
	using Volume = fcl::OBBRSS<double>;

	double travel(const Pair &pair, const Move &move, double from, double to) const;
	double balls_apart(const Pair &pair, const pose *poses) const;

	const Machine &machine_;
	std::vector<std::unique_ptr<fcl::BVHModel<Volume>>> models_;
	mutable long looks_ = 0;
	mutable double nearest_ = INFINITY;
};

#endif
