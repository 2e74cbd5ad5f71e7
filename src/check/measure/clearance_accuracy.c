#include "check/measure/clearance_accuracy.h"

#include <math.h>

/*
 * For a sharp bound, proving this share of the distance is enough. Measured: 0.9 takes a sixth longer. If the distance
 * is more than SHARP_BEYOND times the block's bound so far, the whole bound must be proved: a report shows where the
 * whole cap holds.
 */
#define SHARP_ENOUGH 0.87
#define SHARP_BEYOND 1.1

double clearance_accuracy_promised(enum clearance_accuracy accuracy, double distance)
{
	switch (accuracy) {
	case CLEARANCE_SHARP:
		break;
	case CLEARANCE_COARSE:
		return fmin(0.6 * distance, fmax(distance - 0.3, 0.25 * distance));
	case CLEARANCE_ROUGH:
		return 0.1 * distance;
	}
	return 0.85 * distance;
}

double clearance_accuracy_enough(enum clearance_accuracy accuracy, double distance, double most)
{
	switch (accuracy) {
	case CLEARANCE_SHARP:
		break;
	case CLEARANCE_COARSE:
		return fmin(0.65 * distance, fmax(distance - 0.25, 0.3 * distance));
	case CLEARANCE_ROUGH:
		return 0.12 * distance;
	}
	return fmax(SHARP_ENOUGH * distance, distance > SHARP_BEYOND * most ? most : 0);
}

double clearance_accuracy_distance(enum clearance_accuracy accuracy, double proved)
{
	switch (accuracy) {
	case CLEARANCE_SHARP:
		break;
	case CLEARANCE_COARSE:
		return fmax(proved / 0.65, fmin(proved + 0.25, proved / 0.3));
	case CLEARANCE_ROUGH:
		return proved / 0.12;
	}
	return proved / SHARP_ENOUGH;
}
