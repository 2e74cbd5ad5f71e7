/* step_class.h - what axes and spindle do in a step of a program, as far as it decides whether a cutter cuts there. */
#ifndef FIVECHECK_CONTROL_STEP_CLASS_H
#define FIVECHECK_CONTROL_STEP_CLASS_H

/* Bits, so that sets of classes can be named. */
enum step_class {
	STEP_RAPID = 1,	/* at the axes' rates; and where a program starts and tools are changed */
	STEP_FEED_TURNING = 2,	/* at a programmed feed, and the spindle turns */
	STEP_FEED_STANDING = 4,	/* at a programmed feed, but the spindle stands; or a probe measures */
	STEP_PROBE_TRAVEL = 8,	/* a probe moves at a programmed feed, but does not measure */
	STEP_FEED_REVERSED = 16,	/* at a programmed feed, but the spindle turns against the cutter's hand */
	STEP_ANY = 31
};

#endif
