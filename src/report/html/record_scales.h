/* record_scales.h - the units in which a report's tables hold times, lengths and angles as whole numbers. */
#ifndef FIVECHECK_REPORT_HTML_RECORD_SCALES_H
#define FIVECHECK_REPORT_HTML_RECORD_SCALES_H

#include <math.h>
#include <stdint.h>

#include "machine/machine.h"

#define RECORD_TIME 1e-5	/* s */
#define RECORD_LENGTH 0.01	/* mm */
#define RECORD_ANGLE 0.001	/* degrees */
#define RECORD_CLEARANCE 0.001	/* mm */
#define RECORD_FEED 0.1	/* mm/min */
#define RECORD_NORMAL 1e-6

/* The nearest whole number of units; of two, the even one. */
static inline int64_t record_whole(double value, double scale)
{
	return llrint(value / scale);
}

/* The scale of the column of this axis of the machine. */
static inline double record_axis_scale(const struct axis *axis)
{
	return axis->rotary ? RECORD_ANGLE : RECORD_LENGTH;
}

#endif
