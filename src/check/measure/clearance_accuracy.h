/* clearance_accuracy.h - how near the bound of a block's clearance must come to the smallest distance. */
#ifndef FIVECHECK_CHECK_MEASURE_CLEARANCE_ACCURACY_H
#define FIVECHECK_CHECK_MEASURE_CLEARANCE_ACCURACY_H

/* Where bodies slide along each other each step costs time. */
enum clearance_accuracy {
	CLEARANCE_SHARP,
	CLEARANCE_COARSE,	/* what can be seen in the curve of a report */
	CLEARANCE_ROUGH
};

/*
 * mm: the bound that a block has at least whose bodies are `distance` apart where they are nearest, less the tolerance;
 * or it is what was asked for. Where the way of a rapid is not known (PATH_BOX) it may be any lower bound.
 */
double clearance_accuracy_promised(enum clearance_accuracy accuracy, double distance);

/*
 * mm: the search is done once as much is proved and the bodies are no farther apart than `distance` mm, where `most` is
 * of interest. A little above what is promised, for what rounding and the queries take.
 */
double clearance_accuracy_enough(enum clearance_accuracy accuracy, double distance, double most);

/* mm: the distance of which `proved` is just enough. */
double clearance_accuracy_distance(enum clearance_accuracy accuracy, double proved);

#endif
