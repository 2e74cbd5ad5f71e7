/* stock_certainty.h - decides whether a contact with the stock is certain or only possible. */
#ifndef FIVECHECK_CHECK_STOCK_CERTAINTY_H
#define FIVECHECK_CHECK_STOCK_CERTAINTY_H

#include <stdbool.h>
#include <stddef.h>

#include "check/batch.h"
#include "check/stock_pair.h"

/*
 * The sweep reports a contact where the body meets stock that is not proved to be gone. The contact is certain if the
 * body later comes to a place that no cutter can have touched: in the same block, and in the same batch.
 * Only feeding cutters touch the stock here; material that a rapid breaks out is not counted. `first` is the step of
 * the contact, `s` the fraction of that step at which it happens. False: not proved.
 */
bool stock_certainty_from(struct stock_pair *check, const struct batch *batch, size_t first, double s);

/* The same with the axes at rest at q, before the step `number`. */
bool stock_certainty_at(struct stock_pair *check, const axis_values *q, double number);

#endif
