/* timing.h - the duration of a move: programmed feed, rapid, and the rates of the axes, which limit both. */
#ifndef FIVECHECK_MOTION_TIMING_H
#define FIVECHECK_MOTION_TIMING_H

#include "gcode/canon.h"
#include "motion/axis_table.h"
#include "motion/span.h"

/*
 * The programmed seconds: those of G93, or the G94 feed over the length of X Y Z if any of them moves (under TCP, in
 * the workpiece), else of U V W, else over the degrees (the root of the sum of squares). For a feed near 0 the result
 * may be infinite.
 */
double timing_programmed(const struct path *path, const struct canon_feed *feed);

/*
 * The least seconds, at least `seconds`, in which no axis exceeds its rate, on average over each piece of the path that
 * is flat to `flatness`. With seconds = 0 this is the time of a rapid.
 */
double timing_held(const struct axis_table *axes, const struct span *whole, double flatness, double seconds);

#endif
