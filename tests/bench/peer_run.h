/*
 * peer_run.h - the usual way to check a program: the bodies are posed every so many seconds, and a library looks at
 * every pair that fivecheck follows. A peer brings two answers for one pair at one pose, peer_main all the rest.
 */
#ifndef BENCH_PEER_RUN_H
#define BENCH_PEER_RUN_H

#include <ctime>
#include <vector>

#include "plain_scene.h"
#include "travel.h"

/* A library with its models of the scene's solids. */
class Peer {
public:
	virtual ~Peer() = default;

	/* Do they meet? Boxes around both bodies come first, as a user of the library would have it. */
	virtual bool meets(const solid_pair &pair, const pose &a, const pose &b) = 0;

	/* mm: the bodies are that far apart at least; 0 or less: nothing is known, or they meet. */
	virtual double apart(const solid_pair &pair, const pose &a, const pose &b) = 0;
};

/* At the position `at` the bodies were so many mm apart. */
struct Room {
	double distance = 0;
	double at[AXES_MAX];
};

struct Looker {
	const scene *world;
	Peer *peer;
	std::vector<Room> rooms;	/* by pair; none: no sample is skipped */

	/* Can the bodies not have come together since their distance was known? */
	bool skips(size_t i, const double *q) const
	{
		const Room &room = rooms[i];

		return room.distance > 0 && travel_bound(world, &world->pairs[i], room.at, q) < room.distance;
	}

	bool meets(size_t i, const double *q, const pose *poses)
	{
		const solid_pair &pair = world->pairs[i];
		const pose &a = poses[world->solids[pair.a].link], &b = poses[world->solids[pair.b].link];

		if (rooms.empty())
			return peer->meets(pair, a, b);
		if (skips(i, q))
			return false;
		rooms[i].distance = peer->apart(pair, a, b);
		memcpy(rooms[i].at, q, sizeof(rooms[i].at));
		return rooms[i].distance <= 0 && peer->meets(pair, a, b);
	}

	/* The first pair that meets, or NULL. */
	const solid_pair *look(const double *q, int tool)
	{
		pose poses[AXES_MAX + 1];

		link_poses(world, q, poses);
		for (int i = 0; i < world->pair_count; i++) {
			const solid_pair &pair = world->pairs[i];

			if (pair.looked && is_there(world, &pair, tool) && meets((size_t)i, q, poses))
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

inline double processor_seconds()
{
	timespec t;

	clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &t);
	return (double)t.tv_sec + 1e-9 * (double)t.tv_nsec;
}

/* Windows of the path that share the time: what they cost together stands for the whole where that is cut short. */
enum { WINDOWS = 20 };

/* Looks at samples from n on, before `end`; false: the time was up, or a pair meets. */
inline bool run_window(Looker &looker, const track &track, double step, double n, double end, double limit,
		       Outcome &outcome)
{
	double start = processor_seconds(), q[AXES_MAX];
	size_t row = 1, high = track.count - 1;

	/* The first row that is not before the window. */
	while (row < high) {
		size_t middle = (row + high) / 2;

		if (track.rows[middle].time < n * step)
			row = middle + 1;
		else
			high = middle;
	}
	for (; n < end; n++) {
		double t = n * step, from, span;

		while (row + 1 < track.count && track.rows[row].time < t)
			row++;
		from = track.rows[row - 1].time;
		span = track.rows[row].time - from;
		between(looker.world, &track, row, span > 0 ? fmin(1, (t - from) / span) : 1, q);
		outcome.pair = looker.look(q, track.rows[row].tool);
		outcome.looked++;
		if (outcome.pair) {
			outcome.line = track.rows[row].line;
			outcome.time = t;
			return false;
		}
		if (processor_seconds() - start > limit)
			return n + 1 >= end;
	}
	return true;
}

inline Outcome run_peer(Looker &looker, const track &track, double step, double limit)
{
	Outcome outcome;
	double start = processor_seconds();
	bool whole = true;

	outcome.total = floor(track.rows[track.count - 1].time / step) + 1;
	for (int w = 0; w < WINDOWS && !outcome.pair; w++) {
		bool finished = run_window(looker, track, step, floor(outcome.total * w / WINDOWS),
					   floor(outcome.total * (w + 1) / WINDOWS), limit / WINDOWS, outcome);

		/* Behind a window that was cut short nobody knows whether a contact is the first one. */
		if (outcome.pair && !whole) {
			outcome.pair = nullptr;
			break;
		}
		whole = whole && finished;
	}
	outcome.seconds = processor_seconds() - start;
	return outcome;
}

/* The program `NAME SCENE PATH STEP LIMIT [skip]` for a library; peer_fcl.cpp tells what it prints. */
template <class Library> int peer_main(int argc, char **argv)
{
	double start, build;
	Outcome outcome;
	Looker looker;
	track track;

	if (argc != 5 && (argc != 6 || strcmp(argv[5], "skip")))
		die("usage: peer SCENE PATH STEP LIMIT [skip]", argv[0]);
	looker.world = read_scene(argv[1]);
	track = read_track(looker.world, argv[2]);
	start = processor_seconds();
	Library library(looker.world);
	build = processor_seconds() - start;
	looker.peer = &library;
	if (argc == 6)
		looker.rooms.resize((size_t)looker.world->pair_count);
	outcome = run_peer(looker, track, atof(argv[3]), atof(argv[4]));
	printf("%.0f\t%.0f\t%.9g\t%.9g\t%s\t%s\t%ld\t%.12g\n", outcome.total, outcome.looked, outcome.seconds, build,
	       outcome.pair ? looker.world->solids[outcome.pair->a].name : "-",
	       outcome.pair ? looker.world->solids[outcome.pair->b].name : "-", outcome.line, outcome.time);
	return 0;
}

#endif
