/* oracle_judge.h - fivecheck's answers to a job, judged by brute force over points of the blank. */
#ifndef ORACLE_JUDGE_H
#define ORACLE_JUDGE_H

#include "oracle_job.h"

/* What is wrong with fivecheck's answers. */
struct judgement {
	int jobs, arcs, guided, tolerant, bounded, split, undercut;	/* jobs that had these */
	int missed, wrong, failed;
	int violated, found;	/* moves */
	int certain, confirmed;	/* contacts that are told as certain, and of them those in which a point was found */
};

void judgement_add(struct judgement *sum, const struct judgement *some);

/* Checks the job with the program, with its files in the folder, and adds to the sums; says what is wrong. */
void judge(struct job *job, struct oracle_random *random, const char *program, const char *folder, long seed,
	   struct judgement *sum);

#endif
