/* motion.h - runs a program: turns the interpreter's moves into spans, watches the axis limits, keeps the clock. */
#ifndef FIVECHECK_MOTION_MOTION_H
#define FIVECHECK_MOTION_MOTION_H

#include <stdbool.h>
#include <stdio.h>

#include "base/axes.h"
#include "base/diag.h"
#include "gcode/read_options.h"
#include "machine/machine.h"
#include "machine/setup.h"
#include "motion/span.h"

/* One span of the program, in the order of time. */
struct motion_step {
	struct span span;	/* its path is borrowed during the call */
	const char *file;	/* of the block, the program's or a subprogram's; lives as long as the run */
	long line;	/* of the block */
	int move;	/* of the block, from 1 */
	int tool;	/* in the spindle; 0: none */
	double time;	/* s since the start of the program, dwells included, where the span starts */
	double block_time;	/* s of motion in this block before the span, dwells excluded */
	double seconds;	/* the span's own duration */
	axis_values tolerance;	/* how far the control may leave the path (G64), mm and radians; not in the deviation */
	bool outside;	/* some part of the move is past an axis limit */
	bool rapid;	/* at the axes' rates, else at a programmed feed */
	bool spindle_turns;
};

/* An axis leaves its travel: the first instant of it in one move. */
struct motion_limit {
	int slot;
	double bound;	/* the limit, mm or radians */
	axis_values position;	/* where the axes are at that instant */
	double time;
	double block_time;
	const char *file;
	long line;
	int move;
	int tool;
};

/* Where the steps go. Each returns false to stop the program. */
struct motion_sink {
	void *context;
	/* Comes before the steps of the move that it speaks of. */
	bool (*limit)(void *context, const struct motion_limit *limit);
	bool (*step)(void *context, const struct motion_step *step);
	/* A new tool is in the spindle, with the axes at `position`. */
	bool (*tool)(void *context, int tool, const axis_values *position);
	/* A block is complete: its file, its text, its motion time in s (dwells excluded), its number of moves. */
	bool (*block)(void *context, const char *file, long line, const char *text, double seconds, int moves);
};

/* By how much the setup is taken to differ from what was given: mm, added to the control's values. */
struct setup_change {
	vec3 work;	/* every work offset, X Y Z */
	double length;	/* every tool's length offset; the tool's body stays */
};

struct motion_options {
	double flatness;	/* mm: no axis of a step's chord deviates by more */
	struct read_options read;
	const struct setup_change *change;	/* or NULL */
};

/* What a run was. */
struct motion_summary {
	long lines;
	long blocks;	/* blocks carried out */
	long moves;	/* of nonzero length */
	long spans;
	double seconds;	/* machining time, dwells included */
	bool blend_unbounded;	/* G64 was in force with no tolerance from program or machine */
};

/*
 * Runs the program from home to its end; setup may be NULL. Memory does not
 * grow with the program. False: a fault was reported to diag, or the sink
 * stopped. *summary is filled in either case, and up to date whenever the sink is called.
 */
bool motion_run(const struct machine *machine, const struct setup *setup, const struct motion_options *options,
		FILE *in, const char *name, const struct motion_sink *sink, struct diag *diag,
		struct motion_summary *summary);

#endif
