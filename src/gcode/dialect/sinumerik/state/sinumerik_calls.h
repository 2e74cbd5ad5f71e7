/* sinumerik_calls.h - calls, loops and searches: where the program continues. */
#ifndef FIVECHECK_GCODE_DIALECT_SINUMERIK_STATE_SINUMERIK_CALLS_H
#define FIVECHECK_GCODE_DIALECT_SINUMERIK_STATE_SINUMERIK_CALLS_H

#include "gcode/dialect/sinumerik/state/sinumerik_modes.h"
#include "gcode/dialect/sinumerik/state/sinumerik_values.h"
#include "gcode/dialect/sinumerik/words/sinumerik_name.h"
#include "gcode/state.h"
#include "gcode/text/label.h"

/* Nested loops in one program: the manual allows eight, but a loop that a jump has left may remain here. */
#define SINUMERIK_LOOPS_MAX 64

enum sinumerik_loop_kind { SINUMERIK_WHILE, SINUMERIK_FOR, SINUMERIK_LOOP, SINUMERIK_REPEAT };

struct sinumerik_loop {
	enum sinumerik_loop_kind kind;
	struct position start;	/* the line that begins the loop */
	long end;	/* the line of its end; 0: not searched yet */
	int level;
	double last;	/* FOR: the value after TO */
	bool again;	/* the end was reached, and the next pass begins */
};

struct sinumerik_loops {
	struct sinumerik_loop items[SINUMERIK_LOOPS_MAX];
	size_t count;
};

#define SINUMERIK_JUMPS 256

/* The result of a search for a jump target or the end of a structure: this makes jumps in loops fast. */
struct sinumerik_jump {
	const struct source *source;
	long long from;
	char target[SINUMERIK_NAME + 2];	/* a byte for the kind of search, and the name */
	struct position to;
};

struct sinumerik_search {
	struct sinumerik_jump jumps[SINUMERIK_JUMPS];
	/* The labels of a file from this offset on; the kind counts further labels of the same name. */
	const struct source *labelled;
	long long labelled_from;
	struct labels labels;
	long last_number;	/* of a block there */
	bool numbers_repeat;	/* a block there has no larger number than the one before it */
};

/* 840D sl, NC programming: 16 levels of calls. */
#define SINUMERIK_LEVELS_MAX 16

/* A call of a subprogram, or REPEAT LABEL [LABEL] [P=n]. */
struct sinumerik_call {
	struct position back;	/* the line after the call */
	struct position entry;	/* the first line of the subprogram, or of the repeated part */
	long last_line;	/* a repeated part: its last line, after which a repetition or the call ends; 0: a subprogram */
	bool called;	/* CALL BLOCK has called the part as a subprogram */
	int left;	/* remaining repetitions */
	const char *file;	/* of the call */
	long line;
	int column;
	char title[SINUMERIK_NAME + 1];
	bool saves;	/* PROC ... SAVE: the return restores G-codes and frames */
	struct sinumerik_saved saved;
	size_t loops;	/* open loops at the call */
	size_t argument_count;	/* a repeated subprogram: each repetition starts with these arguments */
	double arguments[SINUMERIK_ARGUMENTS_MAX];
	double begun[SINUMERIK_ARGUMENTS_MAX];	/* the initial values of its parameters */
	size_t begun_count;
};

struct sinumerik_calls {
	struct sinumerik_call items[SINUMERIK_LEVELS_MAX];
	int depth;	/* of calls */
	int level;	/* the number of subprograms among them, to which variables belong; 0: the main program */
	bool entering;	/* the next line may be the PROC of the subprogram that is called */
	struct labels folders;	/* "NAME" and "NAME FOLDER" of each program that a path has named */
	struct labels programs;	/* those that calls have found; a key is the type, the name and the caller's file */
};

/*
 * A modal call: MCALL CYCLE81(...) or MCALL NAME. There is one at a time; it also acts in subprograms and repeated
 * parts.
 */
struct sinumerik_modal {
	bool on;
	bool cycle;	/* a cycle that drills or mills; else a subprogram */
	bool running;	/* the subprogram is running: it does not call itself */
	int depth;	/* the depth of calls at which the subprogram runs */
	int level;	/* the level of the program with the MCALL */
	char name[SINUMERIK_NAME + 1];
	size_t argument_count;
	double arguments[SINUMERIK_ARGUMENTS_MAX];	/* NAN: left out */
	long line;
};

/*
 * A pattern of holes at which MCALL calls a subprogram. Each return continues at the line of the pattern, with the
 * next hole.
 */
struct sinumerik_pattern {
	bool on;
	char name[SINUMERIK_NAME + 1];
	struct position line;
	int depth;	/* the depth of calls at this line */
	int column, plane;
	double scale;	/* mm per unit of length */
	slot_values from;	/* program coordinates of the tool: a row begins at the nearer end */
	long done;	/* holes */
	struct sinumerik_saved before;	/* modes that are restored after the pattern */
	size_t argument_count;
	double arguments[SINUMERIK_ARGUMENTS_MAX];
};

/* A contour that CYCLE62 has selected, and the one that CYCLE72 follows. */
struct sinumerik_contour {
	int selected;	/* the number of CYCLE62 since the last contour was milled */
	struct sinumerik_text name;	/* of the subprogram, or "FIRST:LAST", two labels */
	bool on;
	struct position line;	/* of CYCLE72 */
	int depth;	/* of calls at this line */
	int column, plane;
	bool begun;	/* the first point of the contour is known: */
	bool names_point;	/* the current block gives both coordinates of the plane */
	slot_values from, start;	/* the place before the cycle, and the first point; program coordinates, mm */
	double clear, safe, bottom;	/* heights */
	double beside, ends;	/* mm: how far the tool may be from the contour, and from its ends */
	double drawn_out;	/* mm: how far the tool may be from a corner */
	vec3 heading;	/* unit vector in the plane: the direction at the end of the last move; 0: none yet */
	double rounded;	/* mm: the distance of a rounding or chamfer from the end of the last block */
	bool stays_low;	/* between two passes the tool may return inside the material */
	bool backward;	/* the tool starts at the last point */
	double feed;	/* mm/s */
	struct sinumerik_saved before;	/* modes and the feed (mm/min) that are restored after the cycle */
	double feed_before;
};

#endif
