/* macro_b_state.h - the state of custom macro B for a program: variables, calls, open loops. */
#ifndef FIVECHECK_GCODE_DIALECT_FANUC_MACRO_B_STATE_H
#define FIVECHECK_GCODE_DIALECT_FANUC_MACRO_B_STATE_H

#include <stdbool.h>

#include "gcode/dialect/fanuc/macro_b_rules.h"
#include "gcode/state.h"
#include "gcode/text/label.h"

/* #1 to #33 are local to a call. */
#define MACRO_B_LOCALS 33
/* Nested calls (Fanuc 30i/31i/32i operator's manual, B-63944EN, call nesting: fifteen). */
#define MACRO_B_CALLS_MAX 15
#define MACRO_B_COMMON 1000
/* Assignments in one block. */
#define MACRO_B_ASSIGNED_MAX 16
/* DO1 to DO3 (B-63944EN, repetition; Haas mill operator's manual, looping). */
#define MACRO_B_LOOPS 3

/* NAN is vacant: no value at all. Plain data, compared byte by byte. */
struct macro_b_vars {
	double local[MACRO_B_CALLS_MAX + 1][MACRO_B_LOCALS + 1];
	double common[MACRO_B_COMMON];	/* #100 to #199, #500 to #999, and their other names */
	bool given[MACRO_B_COMMON];	/* this program has assigned a value */
	bool builder_ran;	/* a program of the machine builder that moves, and so may have set some */
	bool before_builder[MACRO_B_COMMON];	/* given, but before that program */
	int level;	/* of G65 and G66 */
};

/* An open WHILE ... DO. */
struct macro_b_loop {
	int number;
	struct position start;	/* of its line */
	struct position end;	/* of the line with its END */
};

enum macro_b_call_kind { MACRO_B_MAIN, MACRO_B_M98, MACRO_B_M97, MACRO_B_G65, MACRO_B_G66 };

/* An active program; the first one is the main program. */
struct macro_b_call {
	enum macro_b_call_kind kind;
	int number;	/* O or, of M97, N */
	struct position program;	/* where the search of GOTO starts */
	struct position entry;	/* the start of each repetition */
	struct position back;
	int left;	/* repetitions after this one */
	const char *file;	/* of the caller's block */
	long line;
	int column;
	struct macro_b_loop loops[MACRO_B_LOOPS];
	int loop_count;
};

/* A call of a program of the machine builder that is carried out as a block (builder_macro.h). */
struct builder_call {
	const struct builder_macro *macro;	/* NULL: there is none */
	double arguments[MACRO_B_LOCALS + 1];
	int column;
	int motion, path_motion;	/* active before the call */
	double feed;
};

struct macro_b {
	const struct macro_b_rules *rules;
	struct macro_b_vars vars;
	struct macro_b_call calls[MACRO_B_CALLS_MAX + 1];
	int level;
	int macro_calls;	/* by G65 and G66, of these */
	int assigned[MACRO_B_ASSIGNED_MAX];	/* variables that the current block assigns */
	int assigned_count;
	bool started;	/* a line with more than comments has been read */
	bool jumped;	/* blocks are counted from the first jump on */
	bool modal;	/* G66 is active */
	int modal_number, modal_repeats, modal_level;
	double modal_arguments[MACRO_B_LOCALS + 1];
	struct builder_call builder;
	bool cautioned_angle, cautioned_builder;
	struct labels found;	/* the results of earlier searches */
};

static inline struct macro_b *macro_b_of(const struct interp *interp)
{
	return interp->dialect_state;
}

static inline struct macro_b_call *macro_b_call_in_hand(const struct interp *interp)
{
	struct macro_b *macro = macro_b_of(interp);

	return &macro->calls[macro->level];
}

/* A variable without a value. */
double macro_b_vacant(void);

/* A struct macro_b for the start of a program; all variables are vacant. */
void *macro_b_state_new(const struct macro_b_rules *rules);
void macro_b_state_free(void *state);

#endif
