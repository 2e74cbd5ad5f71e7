/* stock_certainty.h - does a body meet the stock for certain, or only as far as is known? */
#ifndef FIVECHECK_CHECK_STOCK_CERTAINTY_H
#define FIVECHECK_CHECK_STOCK_CERTAINTY_H

#include <stdbool.h>
#include <stddef.h>

#include "check/batch.h"
#include "check/stock_pair.h"

/*
 * The sweep reports a contact where the body meets stock that is not proved to be gone. The contact is certain if later
 * in the same block, and among the batch's steps before `to`, the body comes to a place that no cutter can have
 * touched. Only cutters that feed touch anything here; what a rapid breaks out is not counted. `first` is the step of
 * the contact, `s` the share of that step at which it happens. False: not proved.
 */
bool stock_certainty_from(struct stock_pair *check, const struct batch *batch, size_t first, double s, size_t to);

/* The same with the axes standing at q, before the step `number`. */
bool stock_certainty_at(struct stock_pair *check, const axis_values *q, double number);

#endif
