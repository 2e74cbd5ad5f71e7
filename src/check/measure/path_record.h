/* course.h - where a program takes the axes, kept on disk, so that a run with another setup can be compared with it. */
#ifndef FIVECHECK_CHECK_COURSE_H
#define FIVECHECK_CHECK_COURSE_H

#include <stdbool.h>
#include <stdint.h>
#include <stdio.h>

#include "motion/motion.h"

struct course {
	FILE *file;	/* a record a block, of the run that was recorded */
	bool compares;	/* else it records */
	bool same;	/* so far every block was the recorded one, with the same tool and the rotary axes where they were */
	double way;	/* mm: the farthest that the linear axes together were from the recorded end of a block */
	uint64_t ways[SLOT_COUNT];	/* a digest of all positions of each axis */
	bool lost;	/* the disk is full, or the like: nothing can be said */
};

/* False: there is no room for a temporary file; errno says why. */
bool course_init(struct course *course);
void course_release(struct course *course);

/* A run begins that is recorded, or compared with the record. */
void course_record(struct course *course);
void course_compare(struct course *course);

void course_step(struct course *course, const struct motion_step *step);
void course_block(struct course *course, long line, int tool, const axis_values *end);

/* The run that is compared is complete: then the recorded one must be. */
void course_end(struct course *course);

#endif
