/*
 * peer.cpp - the usual way: the bodies are posed every so many seconds, and FCL (OBB trees, `collide`, one contact)
 * looks at every pair that fivecheck follows, the boxes around the bodies first.
 *
 *   peer SCENE PATH STEP LIMIT
 *     TOTAL LOOKED SECONDS BUILD A B LINE TIME
 *
 * TOTAL samples are on the path, LOOKED of them were looked at before the first contact or before LIMIT seconds of
 * processor time were up; BUILD seconds made the trees. A and B are the bodies that met, or - when none did.
 * FCL: https://github.com/flexible-collision-library/fcl, 0.7, fcl/narrowphase/collision.h.
 */
#include <ctime>

#include <fcl/math/bv/OBB.h>
#include <fcl/narrowphase/collision.h>

#include "fcl_model.h"

using Volume = fcl::OBB<double>;

static double seconds()
{
	timespec t;

	clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &t);
	return (double)t.tv_sec + 1e-9 * (double)t.tv_nsec;
}

struct Peer {
	const scene *world;
	std::vector<std::unique_ptr<fcl::BVHModel<Volume>>> models;
	fcl::CollisionRequest<double> request{1, false};

	/*
	 * The oriented boxes around both bodies, before anything is set up for their trees. overlap takes the second
	 * box at the given place as the first one sees it; its comment has it the other way round.
	 */
	bool boxes_meet(const solid_pair &pair, const fcl::Transform3<double> &a, const fcl::Transform3<double> &b) const
	{
		const fcl::Transform3<double> b_in_a = a.inverse(Eigen::Isometry) * b;

		return fcl::overlap(b_in_a.linear(), b_in_a.translation(), models[(size_t)pair.a]->getBV(0).bv,
				    models[(size_t)pair.b]->getBV(0).bv);
	}

	/* The first pair that meets, or NULL. */
	const solid_pair *look(const double *q, int tool) const
	{
		pose poses[AXES_MAX + 1];
		fcl::Transform3<double> transforms[AXES_MAX + 1];

		link_poses(world, q, poses);
		for (int i = 0; i <= world->axis_count; i++)
			transforms[i] = transform_of(poses[i]);
		for (int i = 0; i < world->pair_count; i++) {
			const solid_pair &pair = world->pairs[i];
			fcl::CollisionResult<double> result;

			if (!pair.looked || !is_there(world, &pair, tool) ||
			    !boxes_meet(pair, transforms[world->solids[pair.a].link],
					transforms[world->solids[pair.b].link]))
				continue;
			if (fcl::collide(models[(size_t)pair.a].get(), transforms[world->solids[pair.a].link],
					 models[(size_t)pair.b].get(), transforms[world->solids[pair.b].link],
					 request, result))
				return &pair;
		}
		return nullptr;
	}
};

struct Outcome {
	double total = 0, looked = 0, seconds = 0;
	const solid_pair *pair = nullptr;
	long line = 0;
	double time = 0;
};

static Outcome run(const Peer &peer, const track &track, double step, double limit)
{
	Outcome outcome;
	double start = seconds(), n = 0;
	size_t row = 1;

	outcome.total = floor(track.rows[track.count - 1].time / step) + 1;
	for (; n < outcome.total && row < track.count; n++) {
		double q[AXES_MAX], t = n * step, from, span;

		while (row + 1 < track.count && track.rows[row].time < t)
			row++;
		from = track.rows[row - 1].time;
		span = track.rows[row].time - from;
		between(peer.world, &track, row, span > 0 ? fmin(1, (t - from) / span) : 1, q);
		outcome.pair = peer.look(q, track.rows[row].tool);
		if (outcome.pair) {
			outcome.line = track.rows[row].line;
			outcome.time = t;
			n++;
			break;
		}
		if (seconds() - start > limit) {
			n++;
			break;
		}
	}
	outcome.looked = n;
	outcome.seconds = seconds() - start;
	return outcome;
}

int main(int argc, char **argv)
{
	Peer peer;
	track track;
	Outcome outcome;
	double start = seconds(), build;

	if (argc != 5)
		die("usage: peer SCENE PATH STEP LIMIT", argv[0]);
	peer.world = read_scene(argv[1]);
	track = read_track(peer.world, argv[2]);
	start = seconds();
	for (int i = 0; i < peer.world->solid_count; i++)
		peer.models.push_back(model_of<Volume>(peer.world->solids[i]));
	build = seconds() - start;
	outcome = run(peer, track, atof(argv[3]), atof(argv[4]));
	printf("%.0f\t%.0f\t%.9g\t%.9g\t%s\t%s\t%ld\t%.12g\n", outcome.total, outcome.looked, outcome.seconds, build,
	       outcome.pair ? peer.world->solids[outcome.pair->a].name : "-",
	       outcome.pair ? peer.world->solids[outcome.pair->b].name : "-", outcome.line, outcome.time);
	return 0;
}
