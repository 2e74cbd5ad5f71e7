/* clearance_accuracy.h - how near the bound of a block's clearance must come to the smallest distance. */
#ifndef FIVECHECK_CHECK_MEASURE_CLEARANCE_ACCURACY_H
#define FIVECHECK_CHECK_MEASURE_CLEARANCE_ACCURACY_H

/* Where bodies slide along each other, each step costs time. */
enum clearance_accuracy {
	CLEARANCE_SHARP,
	CLEARANCE_COARSE,	/* as exact as the curve of a report can show */
	CLEARANCE_ROUGH
};

/*
 * mm: the smallest allowed bound, minus the tolerance, for a block whose bodies are `distance` apart where they are
 * nearest; or the cap. If the path of a rapid is not known (PATH_BOX), any lower bound is allowed.
 */
double clearance_accuracy_promised(enum clearance_accuracy accuracy, double distance);

/*
 * mm: the search may end when this is proved and the bodies are no farther apart than `distance` mm; `most` is the cap.
 * It is a little above the promised bound, to allow for rounding and the queries.
 */
double clearance_accuracy_enough(enum clearance_accuracy accuracy, double distance, double most);

/* mm: the distance for which `proved` is just enough. */
double clearance_accuracy_distance(enum clearance_accuracy accuracy, double proved);

#endif
