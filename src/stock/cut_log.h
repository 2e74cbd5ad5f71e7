/* cut_log.h - the cuts of feeding cutters so far, in the order of time; can be searched by place. */
#ifndef FIVECHECK_STOCK_CUT_LOG_H
#define FIVECHECK_STOCK_CUT_LOG_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#include "stock/cut_store.h"
#include "stock/cutter.h"

/*
 * Times are counted in steps of the program: 7.5 is the middle of step number 7. The log receives pieces of steps in
 * their order, and never forgets one.
 */
struct cut {
	int cutter;	/* index of the log's cutters */
	double from, to;	/* when */
	struct cutter_way way;
	double error;	/* mm: the largest distance of a point of the true cutter from the path */
};

/* A cutter may have been anywhere in a box: it removes nothing for certain, but possibly everything. */
struct cut_region {
	int cutter;
	double from, to;	/* when */
	vec3 low, high;
};

/* The box around the cuts of some chunks, or of one. */
struct cut_box {
	vec3 low, high;
};

/* A chunk has the boxes [0][chunk], [1][chunk / 8], and so on. */
enum { CUT_LEVELS = 10, CUT_FAN = 8 };

struct cut_log {
	const struct cutter *cutters;	/* borrowed */
	struct cut_store *store;	/* the chunks */
	double *starts;	/* of each chunk: when it begins */
	size_t start_capacity;
	struct cut_box *boxes[CUT_LEVELS];
	size_t box_count[CUT_LEVELS], box_capacity[CUT_LEVELS];
};

void cut_log_init(struct cut_log *log, const struct cutter *cutters);
void cut_log_release(struct cut_log *log);

/* Cuts and regions are added in the order of time. */
void cut_log_add(struct cut_log *log, const struct cut *cut);
void cut_log_add_region(struct cut_log *log, const struct cut_region *region);

/*
 * errno of the first failed write to or read from the temporary file; 0: none. After an error cuts are missing, and the
 * answers of the log are invalid.
 */
int cut_log_fault(const struct cut_log *log);

/* The place in the log after all cuts that begin before `time`. */
uint64_t cut_log_end(const struct cut_log *log, double time);

/*
 * The time at which the first cut at or after *place that removes the whole cube does so; INFINITY: none before `end`.
 * Then *place becomes `end`.
 */
double cut_log_search(const struct cut_log *log, const struct cube *cube, uint64_t *place, uint64_t end);

/*
 * Does one cut remove the whole part of a cell, at an instant not after `time`? `end` is cut_log_end for that time.
 * *chunk is the place to search first; it becomes the chunk with such a cut, and has no other meaning.
 */
bool cut_log_removes_part(const struct cut_log *log, const struct cell_part *part, double time, uint64_t end,
			  size_t *chunk);

/*
 * May any cut that begins before `time` have touched the ball? False is certain: until then no cutter has been at any
 * point of the ball.
 */
bool cut_log_reaches(const struct cut_log *log, vec3 centre, double radius, double time);

#endif
