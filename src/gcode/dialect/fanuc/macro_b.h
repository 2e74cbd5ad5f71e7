/* macro_b.h - control flow of Fanuc and Haas: IF, WHILE, GOTO, G65, G66, M97 to M99. */
#ifndef FIVECHECK_GCODE_DIALECT_FANUC_MACRO_B_H
#define FIVECHECK_GCODE_DIALECT_FANUC_MACRO_B_H

#include <stdbool.h>

#include "base/strbuf.h"
#include "gcode/dialect/fanuc/macro_b_vars.h"
#include "gcode/text/source.h"

/* DO1 to DO3 (B-63944EN, repetition; Haas mill operator's manual, looping). */
#define MACRO_LOOPS 3

struct interp;

/* An open WHILE ... DO. */
struct macro_b_loop {
	int number;
	struct position start;	/* of its line */
	struct position end;	/* of the line with its END */
};

enum macro_b_call_kind { MACRO_MAIN, MACRO_M98, MACRO_M97, MACRO_G65, MACRO_G66 };

/* A program under way; the first one is the program itself. */
struct macro_b_call {
	enum macro_b_call_kind kind;
	int number;	/* O or, of M97, N */
	struct position program;	/* where GOTO starts to search */
	struct position entry;	/* where each repetition starts */
	struct position back;
	int left;	/* repetitions after this one */
	const char *file;	/* of the caller's block */
	long line;
	int column;
	struct macro_b_loop loops[MACRO_LOOPS];
	int loop_count;
};

struct macro_b {
	struct macro_b_vars vars;
	struct macro_b_call calls[MACRO_CALLS_MAX + 1];
	int level;
	int macro_calls;	/* by G65 and G66, of these */
	int assigned[MACRO_ASSIGNED_MAX];	/* variables, by the block in hand */
	int assigned_count;
	bool started;	/* a line with more than comments has been met */
	bool jumped;	/* blocks are counted from the first jump on */
	bool modal;	/* G66 is in force */
	int modal_number, modal_repeats, modal_level;
	double modal_arguments[MACRO_LOCALS + 1];
	bool work_stale;	/* the work offset in force was assigned to, and not selected since */
	bool cautioned_angle;
	struct strbuf line;	/* the line in hand, while others are read */
};

void macro_b_init(struct macro_b *macro);
void macro_b_release(struct macro_b *macro);

/*
 * Carries out the line in hand if it is a macro statement: then *done is true.
 * The rest (M97, M98, M99 among it) is a block's. False: reported.
 */
bool macro_b_line(struct interp *interp, bool *done);

/* M97, M98 and M99 of a block that has been carried out. False: reported. */
bool macro_b_end_block(struct interp *interp);

/* After the block's selection of a work offset: is the one in force what the control has? False: reported. */
bool macro_b_check_work(struct interp *interp);

/* The call that G66 makes after a block. False: reported. */
bool macro_b_after_block(struct interp *interp);

/* The file in hand has ended. False: inside of a subprogram, which was reported. */
bool macro_b_end_of_file(struct interp *interp);

/* Notes below what has just been reported: from where the block in hand was called. */
void macro_b_note_callers(struct interp *interp);

#endif
