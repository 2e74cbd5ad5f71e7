/*
 * truth.h - the answer of FCL for a program: every pair of bodies, in steps that are small where the bodies are near.
 */
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

	/* Is one inside the other, without contact of the surfaces? */
	bool contained(const Pair &pair, const Position &q) const;

	/* The first place of the move, 0 to 1, at which a sample violates the pair; 2: there is none. */
	double first_violation(const Pair &pair, const Move &move, double clearance) const;

	/* Are their tools, if they have any, in the spindle? */
	bool present(const Pair &pair, int tool) const;

	long looks() const
	{
		return looks_;
	}

	/* mm: the least distance of all samples so far. */
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
