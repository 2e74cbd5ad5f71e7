#include "check/open_boxes.h"

#include "check/step.h"

int open_boxes_count(struct open_boxes *boxes, long share)
{
	if (boxes->share != share)
		*boxes = (struct open_boxes){.share = share};
	return boxes->count;
}

void open_boxes_add(struct open_boxes *boxes, const struct pair_result *result, const struct batch_step *step)
{
	if (result->answer == QUERY_UNDECIDED && result->exhausted && step_is_box(&step->motion) &&
	    boxes->count < BOX_HALVINGS_MAX)
		boxes->count++;
}
