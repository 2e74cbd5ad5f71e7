/* stock_clearance.h - a proven lower bound of a body's distance from the remaining stock in each block, up to a cap. */
#ifndef FIVECHECK_CHECK_MEASURE_STOCK_CLEARANCE_H
#define FIVECHECK_CHECK_MEASURE_STOCK_CLEARANCE_H

#include <stdbool.h>
#include <stddef.h>

#include "check/batch.h"
#include "check/certified/motion_budget.h"
#include "check/stock_pair.h"

/* The distance of a body from the stock in those steps of a block that are in the batch. */
struct stock_block_clearance {
	long block;
	double clearance;	/* mm: a lower bound of the distance from all possible remaining stock, or the cap */
};

/*
 * The distance is measured from the cells that are not proved to have left the stock. They enclose the true stock, so
 * the true distance is not smaller.
 */
struct stock_clearance {
	struct stock_pair *pair;	/* borrowed */
	double cap;	/* mm */
	double bound;	/* mm: proved for the block so far; 0: nothing */
	struct motion_budget budget;
	struct stock_block_clearance *blocks;	/* of the last batch */
	size_t block_count, block_capacity;
};

/* The pair must not be moved. */
void stock_clearance_init(struct stock_clearance *clearance, struct stock_pair *pair, double cap);
void stock_clearance_release(struct stock_clearance *clearance);

/*
 * Measures the batch, if the pair is checked in all of its steps: where a cutter may touch the stock, there is no
 * clearance. False: interrupted.
 */
bool stock_clearance_measure(struct stock_clearance *clearance, const struct batch *batch);

#endif
