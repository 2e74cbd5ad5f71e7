/* timing.h - how long a move takes: programmed feed, rapid, and the axes' rates, which hold both. */
#ifndef FIVECHECK_MOTION_TIMING_H
#define FIVECHECK_MOTION_TIMING_H

#include "gcode/canon.h"
#include "motion/axis_table.h"
#include "motion/span.h"

/*
 * Seconds that the program asks for: G93's own, or the G94 feed over the
 * length of X Y Z if any of them moves (under TCP, in the workpiece), else of
 * U V W, else over the degrees (the root of the sum of squares). Of a feed
 * near 0 the result may be infinite.
 */
double timing_programmed(const struct path *path, const struct canon_feed *feed);

/*
 * The least seconds, `seconds` at least, in which no axis goes faster than its
 * rate, on average over each piece of the path that is flat to `flatness`.
 * With seconds = 0 that is a rapid's time.
 */
double timing_held(const struct axis_table *axes, const struct span *whole, double flatness, double seconds);

#endif
