/*
 * stock_oracle.c - random jobs with stock, checked by fivecheck and by brute force.
 *
 *     stock_oracle FIVECHECK FOLDER JOBS [SEED]
 *
 * The brute force shares no code with fivecheck. It takes points of the blank, follows each through all moves, and asks
 * when it is inside the cutter and when it is inside something that must not touch it; how far a point can move bounds
 * what happens between two instants. Two questions for each job:
 *
 * missed: a point that no cutter has removed is inside the shank or the holder, or deep in the cutter at rapid, and
 *     fivecheck finds nothing in that block;
 * false: near a contact that fivecheck reports there is no point that a cutter smaller by the stock's tolerance has
 *     left and that is as near as that to the body.
 *
 * Contacts that fivecheck calls certain are confirmed by points that are found by chance; where the place is small none
 * may be found, so these are only counted.
 *
 * An error is small, and so is its place. So after most cuts the cutter goes back at rapid and is pushed into the new
 * wall, to about the depth that is allowed; at the end a feeler, a small ball on a thin stem, does the same in many
 * places. Most points lie where only these pushes reach.
 *
 * The machine moves the tool by X, Y and Z and turns the stock by B about the Y axis. Jobs have straight moves, arcs
 * and helices, or the tip is guided over the turning workpiece (TCP); cutters of all shapes; motions that may end
 * anywhere, which end at one place by chance; a path tolerance, within which each move lies beside its path by chance;
 * and some have a second program in a second setup, whose blank is what the first one leaves (--stock-out). The cutter
 * comes back at rapid in what it has cut.
 *
 * Each processor takes its share of the jobs. Exit status 1: something was missed or false; its files stay in a folder
 * below FOLDER.
 */
#include <stdio.h>
#include <stdlib.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include "oracle_judge.h"

/* Every WORKERS-th job from `first` on, until one is wrong. */
static struct judgement run_some(char **argv, const char *folder, long first, long end, long workers)
{
	struct judgement sum = {0};

	for (long seed = first; seed < end && !(sum.missed || sum.wrong || sum.failed); seed += workers) {
		struct oracle_random random = oracle_random_of(seed);
		struct job job;

		job_make(&job, &random);
		judge(&job, &random, argv[1], folder, seed, &sum);
	}
	return sum;
}

/* The same in a process of its own, which writes the sums to a pipe. */
static void start(char **argv, int worker, long seed, long jobs, long workers, int to)
{
	char folder[4096];
	struct judgement sum;

	if (fork())
		return;
	snprintf(folder, sizeof(folder), "%s/%d", argv[2], worker);
	mkdir(folder, 0777);
	sum = run_some(argv, folder, seed + worker, seed + jobs, workers);
	_exit(write(to, &sum, sizeof(sum)) != sizeof(sum));
}

int main(int argc, char **argv)
{
	const long jobs = argc > 3 ? atol(argv[3]) : 0, seed = argc > 4 ? atol(argv[4]) : 1;
	const long workers = sysconf(_SC_NPROCESSORS_ONLN);
	struct judgement sum = {0}, some;
	int ends[2];

	if (argc < 4 || pipe(ends)) {
		fprintf(stderr, "usage: stock_oracle FIVECHECK FOLDER JOBS [SEED]\n");
		return 2;
	}
	setvbuf(stdout, NULL, _IOLBF, 0);
	for (int i = 0; i < workers; i++)
		start(argv, i, seed, jobs, workers, ends[1]);
	close(ends[1]);
	for (int i = 0; i < workers; i++) {
		if (read(ends[0], &some, sizeof(some)) != sizeof(some))
			some = (struct judgement){.failed = 1};
		judgement_add(&sum, &some);
	}
	while (wait(NULL) > 0)
		;
	printf("stock_oracle: %d jobs from seed %ld (%d with arcs, %d with TCP, %d with a path tolerance, %d with motions "
	       "that may end anywhere, %d in two setups, %d with an undercut cutter); of their moves %d violate and %d are "
	       "found: %d missed, %d false, %d failed; of %d certain contacts %d are confirmed\n",
	       sum.jobs, seed, sum.arcs, sum.guided, sum.tolerant, sum.bounded, sum.split, sum.undercut, sum.violated,
	       sum.found, sum.missed, sum.wrong, sum.failed, sum.certain, sum.confirmed);
	return sum.missed || sum.wrong || sum.failed;
}
