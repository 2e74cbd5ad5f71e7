/* path_record.h - where a program takes the axes, kept on disk, so that a run with another setup can be compared with it. */
#ifndef FIVECHECK_CHECK_MEASURE_PATH_RECORD_H
#define FIVECHECK_CHECK_MEASURE_PATH_RECORD_H

#include <stdbool.h>
#include <stdint.h>
#include <stdio.h>

#include "motion/events.h"

struct path_record {
	FILE *file;	/* a record a block, of the run that was recorded */
	bool compares;	/* else it records */
	bool same;	/* so far every block was the recorded one, with the same tool and the rotary axes where they were */
	double way;	/* mm: the farthest that the linear axes together were from the recorded end of a block */
	uint64_t ways[SLOT_COUNT];	/* a digest of all positions of each axis */
	bool lost;	/* the disk is full, or the like: nothing can be said */
};

/* False: there is no room for a temporary file; errno says why. */
bool path_record_init(struct path_record *path);
void path_record_release(struct path_record *path);

/* A run begins that is recorded, or compared with the record. */
void path_record_start(struct path_record *path);
void path_record_compare(struct path_record *path);

void path_record_step(struct path_record *path, const struct motion_step *step);
void path_record_block(struct path_record *path, long line, int tool, const axis_values *end);

/* The run that is compared is complete: then the recorded one must be. */
void path_record_end(struct path_record *path);

#endif
