/* cutting.h - logs the material that a feeding cutter certainly removes along a step. */
#ifndef FIVECHECK_STOCK_CUTTING_H
#define FIVECHECK_STOCK_CUTTING_H

#include "scene/motion_interval.h"
#include "stock/cut_log.h"

/* A step, or a piece of one, along which a turning cutter feeds. */
struct cutting {
	const struct body_pair *bodies;	/* the stock is a, the cutter b */
	int cutter;	/* index of the log's cutters */
	struct chord chord;
	double from, to;	/* the times, as in the log */
	/* mm: the largest distance of a curved path from the chords of its pieces */
	double chord_error;
	vec3 low, high;	/* the box around the blank: cuts outside it are left out */
};

void cutting_log(const struct cutting *cutting, struct cut_log *log);

/*
 * The same for a step of which only the set of positions is known: everything between the chord's ends, axis by axis.
 * It removes nothing for certain. Only the cutter's mesh is used.
 */
void cutting_log_region(const struct cutting *cutting, struct cut_log *log);

#endif
