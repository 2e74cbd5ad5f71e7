/* open_boxes.h - counts the rapids whose path is not known and that were not decided. */
#ifndef FIVECHECK_CHECK_OPEN_BOXES_H
#define FIVECHECK_CHECK_OPEN_BOXES_H

#include "check/pair_result.h"

/*
 * The rapids whose path is not known (PATH_BOX) and that were not decided in this share of the program. Each of them
 * halves the effort for the next one of the same pair, so that a program with many of them ends in a reasonable time.
 * They are counted anew in each share: the result must not depend on which shard checks which share.
 */
struct open_boxes {
	long share;
	int count;	/* at most BOX_HALVINGS_MAX */
};

enum { BOX_HALVINGS_MAX = 16 };

/* Their number in this share. */
int open_boxes_count(struct open_boxes *boxes, long share);

/* Counts the result of this step, if it is one of them. Call open_boxes_count before. */
void open_boxes_add(struct open_boxes *boxes, const struct pair_result *result, const struct batch_step *step);

#endif
