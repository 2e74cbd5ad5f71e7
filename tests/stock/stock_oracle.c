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
 * The machine moves the tool by X, Y and Z and turns the stock by B about the Y axis. Exit status 1: something was missed
 * or false; its files stay in FOLDER.
 */
#include <stdio.h>
#include <stdlib.h>

#include "oracle_judge.h"

int main(int argc, char **argv)
{
	const int jobs = argc > 3 ? atoi(argv[3]) : 0;
	const long seed = argc > 4 ? atol(argv[4]) : 1;
	struct judgement sum = {0};
	int done = 0;

	if (argc < 4) {
		fprintf(stderr, "usage: stock_oracle FIVECHECK FOLDER JOBS [SEED]\n");
		return 2;
	}
	setvbuf(stdout, NULL, _IOLBF, 0);
	while (done < jobs && !(sum.missed || sum.wrong || sum.failed)) {
		struct oracle_random random = oracle_random_of(seed + done);
		struct job job;

		job_make(&job, &random);
		judge(&job, &random, argv[1], argv[2], seed + done, &sum);
		done++;
	}
	printf("stock_oracle: %d jobs from seed %ld; of their moves %d violate and %d are found: %d missed, %d false, "
	       "%d failed; of %d certain contacts %d are confirmed\n", done, seed, sum.violated, sum.found, sum.missed,
	       sum.wrong, sum.failed, sum.certain, sum.confirmed);
	return sum.missed || sum.wrong || sum.failed;
}
