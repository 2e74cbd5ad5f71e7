/* events.h - the events of a program, which motion_run sends one by one in the order of time. */
#ifndef FIVECHECK_MOTION_EVENTS_H
#define FIVECHECK_MOTION_EVENTS_H

#include <stdbool.h>

#include "base/axes.h"
#include "base/call_chain.h"
#include "control/step_class.h"
#include "motion/span.h"

/* A straight piece of a move. */
struct motion_step {
	struct span span;
	const char *file;	/* of the block: the program's or a subprogram's (motion_options.names) */
	long line;	/* of the block */
	int move;	/* of the block, from 1 */
	int tool;	/* in the spindle; 0: none */
	double time;	/* s from the start of the program to the start of the span, dwells included */
	double block_time;	/* s of motion in this block before the span, dwells excluded */
	double seconds;	/* the span's own duration */
	/* mm, radians: how far the axes may be from the path (G64, canon_move.spread); not part of the chord error */
	axis_values tolerance;
	bool outside;	/* a part of the move is past an axis limit */
	bool bounded;	/* known only as a set of paths, or may end early: it cuts nothing for certain */
	enum step_class step_class;
};

/* An axis leaves, or may leave, its travel. Values of the axis are in mm or radians. */
struct travel_excess {
	int slot;
	double bound;	/* the limit */
	double target;	/* the position to which the move takes the axis */
	double excess;	/* the largest distance past the limit that the axis has, or may have */
	double path_tolerance;	/* how far the axis may be from its path, which is inside; 0: the path is outside */
	const char *work_offset;	/* in force, a constant: "G54"; NULL: the block commands machine coordinates */
	double work, shift;	/* its value for the axis, and the sum of G52 and G92 */
	bool length_acts;	/* the tool's length moves this axis: Z, and all linear ones under TCP */
	double length;	/* mm: of the tool, in force */
};

/* The first instant in a move at which an axis leaves, or may leave, its travel. Sent before the steps of the move. */
struct motion_limit {
	struct travel_excess travel;
	axis_values position;	/* the axis positions at that instant */
	double time;
	double block_time;
	const char *file;
	long line;
	int move;
	int tool;
};

/* A new tool is in the spindle. */
struct motion_tool {
	int tool;
	axis_values position;	/* where the axes are */
};

/* The spindle was turning and stops here. */
struct motion_spindle_stop {
	axis_values position;	/* where the axes are */
	double time;	/* s since the start of the program */
	int move;	/* the last move of the block before the stop; 0: none */
};

/*
 * The modes of the following steps: sent before the first step and whenever they change, if motion_options.modes asks
 * for it.
 */
struct motion_modes {
	const char *work_offset;	/* in force, a constant: "G54"; NULL: machine coordinates are commanded */
	axis_values work, shift;	/* its values, and the sums of G52 and G92; mm and radians */
	double length;	/* mm: of the tool, in force */
	bool tcp;
	bool turned;	/* as in canon_origin */
	double feed;	/* programmed feed, mm/s; 0: a rapid, feed of rotary axes alone, or time (G93) */
	double spindle_speed;	/* as in canon_move */
};

/* A block is complete. */
struct motion_block {
	const char *file;
	long line;
	const char *text;	/* the line of the file */
	double seconds;	/* of motion, dwells excluded */
	int moves;
	const struct srcloc *callers;	/* of its subprogram: call_chain.h */
	size_t caller_count;	/* 0: the block is in the program itself */
};

/* Totals of a run so far, or of the whole run. */
struct motion_summary {
	long lines;
	long blocks;	/* executed blocks */
	long moves;	/* of nonzero length */
	long spans;
	double seconds;	/* machining time, dwells included */
	bool blend_unbounded;	/* G64 was in force with no tolerance from program or machine */
	bool straight_rapids;	/* a rapid of several axes was considered straight, as the machine says */
};

enum motion_event_kind { MOTION_STEP, MOTION_LIMIT, MOTION_TOOL, MOTION_SPINDLE_STOP, MOTION_MODES, MOTION_BLOCK };

/*
 * Plain data that can be copied. Three pointers are valid only during the call: step.span.path with its tcp, block.text
 * and block.callers. To keep the event, copy what they point to (path_copies.h does that for paths). File names live as
 * long as the table that contains them.
 */
struct motion_event {
	enum motion_event_kind kind;
	union {
		struct motion_step step;
		struct motion_limit limit;
		struct motion_tool tool;
		struct motion_spindle_stop spindle_stop;
		struct motion_modes modes;
		struct motion_block block;
	} of;
};

/* Where the events go. */
struct motion_sink {
	void *context;
	/* False: stop the program. */
	bool (*event)(void *context, const struct motion_event *event);
};

#endif
