/* stock_certainty.h - does a body meet the stock for certain, or only as far as is known? */
#ifndef FIVECHECK_CHECK_STOCK_CERTAINTY_H
#define FIVECHECK_CHECK_STOCK_CERTAINTY_H

#include <stdbool.h>
#include <stddef.h>

#include "check/batch.h"
#include "check/stock_pair.h"

/*
 * A contact is told where the stock that is not proved to be gone begins. It is certain if later in the same block, and
 * among the batch's steps before `to`, the body is at a place that no cutter can have touched. Cutters count as they
 * feed; what a rapid breaks out does not. `first` is the step of the contact, `s` its time in it. False: not proved.
 */
bool stock_certainty_from(struct stock_pair *check, const struct batch *batch, size_t first, double s, size_t to);

/* The same with the axes standing at q, before the step `number`. */
bool stock_certainty_at(struct stock_pair *check, const axis_values *q, double number);

#endif
