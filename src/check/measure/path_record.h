/* path_record.h - keeps the path of a program on disk and compares it with the path of a run with another setup. */
#ifndef FIVECHECK_CHECK_MEASURE_PATH_RECORD_H
#define FIVECHECK_CHECK_MEASURE_PATH_RECORD_H

#include <stdbool.h>
#include <stdint.h>
#include <stdio.h>

#include "motion/events.h"

struct path_record {
	FILE *file;	/* one entry for each block of the recorded run */
	bool compares;	/* this run is compared with the record; else it is recorded */
	/*
	 * So far every block is the recorded one, has the same tool, and leaves the rotary axes at the recorded angles.
	 */
	bool same;
	double farthest;	/* mm: the largest distance of the linear axes from the recorded end of a block */
	uint64_t digests[SLOT_COUNT];	/* of all positions of each axis */
	bool failed;	/* the file could not be written or read: there is no result */
};

/* False: cannot create a temporary file; errno says why. */
bool path_record_init(struct path_record *path);
void path_record_release(struct path_record *path);

/* Begins a run: path_record_start records it, path_record_compare compares it with the record. */
void path_record_start(struct path_record *path);
void path_record_compare(struct path_record *path);

void path_record_step(struct path_record *path, const struct motion_step *step);
void path_record_block(struct path_record *path, long line, int tool, const axis_values *end);

/* The compared run is complete. Sets `same` to false if the record has more blocks. */
void path_record_end(struct path_record *path);

#endif
