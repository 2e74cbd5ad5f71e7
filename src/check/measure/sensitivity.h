/* sensitivity.h - by how much a work offset or the tool length may be off before a program's verdict turns. */
#ifndef FIVECHECK_CHECK_MEASURE_SENSITIVITY_H
#define FIVECHECK_CHECK_MEASURE_SENSITIVITY_H

#include <stdbool.h>
#include <stdio.h>

#include "check/check.h"

/* The X, Y and Z of all work offsets; the length offsets of all tools. */
enum { CHANGE_X, CHANGE_Y, CHANGE_Z, CHANGE_LENGTH, CHANGES };

enum sensitivity_state {
	SENSITIVITY_NO_EFFECT,	/* no axis goes elsewhere */
	SENSITIVITY_HOLDS,	/* the verdict is the same up to `range` */
	SENSITIVITY_TURNS,	/* at `turn` it is another one */
	SENSITIVITY_UNKNOWN	/* the program could not be checked with a change of `turn`: `why`; or it took too many runs */
};

/* One quantity, one direction. Lengths in mm, all of them amounts of change, 0 or more. */
struct sensitivity {
	int quantity;	/* CHANGE_... */
	int sign;	/* 1, -1 */
	double range;	/* what was asked for */
	enum sensitivity_state state;
	double proved;	/* the verdict is proved to be clear for every change up to this; 0 if it is not clear to begin with */
	double tried;	/* it was the same at all changes that were tried up to this */
	double turn;
	long line;	/* of the block that decides: the finding's */
	int kind;	/* enum finding_kind; -1: at `turn` nothing is found */
	const char *a, *b;	/* its bodies, the scene's; NULL: a limit, then: */
	int slot;
	char *why;	/* UNKNOWN: the error, or NULL; owned */
};

/*
 * Checks the program again and again, from where `in` stands, which must be a file that can be
 * read again, with one quantity changed at a time, by up to range[CHANGE_...] either way. Fills answers[0..],
 * at most 2 * CHANGES, and returns how many; 0: reported. `result` is the verdict without a change, not INCOMPLETE. The
 * sink's progress is called; its finding is not. `all` and what is measured in the options do not matter.
 *
 * What is proved rests on this: a change by d moves no point farther than d, seen from any other
 * body, so that d less than the clearance that is proved without it does no harm. That holds
 * if the axes' positions are affine in d, which at the values tried is compared, block by block. A limit of
 * travel needs no more than that: between two values that keep it, every value does.
 */
size_t sensitivity_run(struct scene *scene, const struct check_options *options, const double range[CHANGES],
		       enum check_result result, FILE *in, const char *name, const struct check_sink *sink,
		       struct diag *diag, struct sensitivity answers[2 * CHANGES]);

void sensitivity_release(struct sensitivity *answers, size_t count);

#endif
