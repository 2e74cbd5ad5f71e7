/*
 * peer_fcl.cpp - FCL as a peer: OBB trees, `collide`, one contact, the boxes around the bodies first.
 *
 *   peer_fcl SCENE PATH STEP LIMIT [skip]
 *     TOTAL LOOKED SECONDS BUILD A B LINE TIME
 *
 * TOTAL samples are on the path, LOOKED of them were looked at before the first contact or before LIMIT seconds of
 * processor time were up; BUILD seconds made the trees. A and B are the bodies that met, or - when none did. skip: a
 * pair is not looked at again until the axes can have used up the distance that the library said last.
 * FCL: https://github.com/flexible-collision-library/fcl, 0.7, fcl/narrowphase/collision.h and distance.h.
 */
#include <fcl/math/bv/OBB.h>
#include <fcl/math/bv/RSS.h>
#include <fcl/narrowphase/collision.h>
#include <fcl/narrowphase/distance.h>

#include "fcl_model.h"
#include "peer_run.h"

using Box = fcl::OBB<double>;
using Sphere = fcl::RSS<double>;	/* swept by a rectangle: FCL's volume for distances */

/* Distances may be too large by this share of themselves, which is taken off again: exact ones cost more. */
static const double DISTANCE_SHARE = 0.2;

class Fcl : public Peer {
public:
	explicit Fcl(const scene *world)
	{
		for (int i = 0; i < world->solid_count; i++) {
			boxes.push_back(model_of<Box>(world->solids[i]));
			spheres.push_back(model_of<Sphere>(world->solids[i]));
		}
	}

	bool meets(const solid_pair &pair, const pose &a, const pose &b) override
	{
		const fcl::Transform3<double> at = transform_of(a), bt = transform_of(b);
		fcl::CollisionResult<double> result;

		return boxes_meet(pair, at, bt) && fcl::collide(boxes[(size_t)pair.a].get(), at,
								boxes[(size_t)pair.b].get(), bt, request, result);
	}

	double apart(const solid_pair &pair, const pose &a, const pose &b) override
	{
		const fcl::DistanceRequest<double> wanted(false, false, DISTANCE_SHARE, 0);
		fcl::DistanceResult<double> result;

		return fcl::distance(spheres[(size_t)pair.a].get(), transform_of(a), spheres[(size_t)pair.b].get(),
				     transform_of(b), wanted, result) / (1 + DISTANCE_SHARE);
	}

private:
	std::vector<std::unique_ptr<fcl::BVHModel<Box>>> boxes;
	std::vector<std::unique_ptr<fcl::BVHModel<Sphere>>> spheres;
	fcl::CollisionRequest<double> request{1, false};

	/* overlap takes the second box at the given place as the first one sees it; its comment has it the other way. */
	bool boxes_meet(const solid_pair &pair, const fcl::Transform3<double> &a, const fcl::Transform3<double> &b) const
	{
		const fcl::Transform3<double> b_in_a = a.inverse(Eigen::Isometry) * b;

		return fcl::overlap(b_in_a.linear(), b_in_a.translation(), boxes[(size_t)pair.a]->getBV(0).bv,
				    boxes[(size_t)pair.b]->getBV(0).bv);
	}
};

int main(int argc, char **argv)
{
	return peer_main<Fcl>(argc, argv);
}
