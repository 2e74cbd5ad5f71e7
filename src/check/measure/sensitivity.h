/* sensitivity.h - how far a work offset or the tool length may be wrong before the verdict of a program changes. */
#ifndef FIVECHECK_CHECK_MEASURE_SENSITIVITY_H
#define FIVECHECK_CHECK_MEASURE_SENSITIVITY_H

#include <stdbool.h>
#include <stdio.h>

#include "check/check.h"

/* The X, Y and Z of all work offsets; the length offsets of all tools. */
enum { CHANGE_X, CHANGE_Y, CHANGE_Z, CHANGE_LENGTH, CHANGES };

enum sensitivity_state {
	SENSITIVITY_NO_EFFECT,	/* the change moves no axis */
	SENSITIVITY_HOLDS,	/* the verdict is the same up to `range` */
	SENSITIVITY_TURNS,	/* at `turn` the verdict is different */
	SENSITIVITY_UNKNOWN	/* a change of `turn` could not be checked (`why`), or there were too many runs */
};

/* The answer for one quantity in one direction. Lengths in mm; amounts of change are 0 or more. */
struct sensitivity {
	int quantity;	/* CHANGE_... */
	int sign;	/* 1, -1 */
	double range;	/* the largest change to try */
	enum sensitivity_state state;
	/* the verdict is proved to be clear for every change up to this; 0 if it is not clear without a change */
	double proved;
	double tried;	/* the verdict is the same for all changes tried up to this */
	double turn;
	long line;	/* the block of the decisive finding */
	int kind;	/* enum finding_kind; -1: no finding at `turn` */
	const char *a, *b;	/* names of its bodies, owned by the scene; NULL: a limit, then: */
	int slot;
	char *why;	/* of UNKNOWN: the error, or NULL; owned */
};

/* A checked program, and the allowed changes of its setup. Borrows everything. */
struct sensitivity_study {
	struct scene *scene;
	const struct check_options *options;	/* `all` and the measurements in them are ignored */
	const double *range;	/* mm: the largest change of each of CHANGES; 0: none */
	enum check_result result;	/* the verdict without a change, not INCOMPLETE */
	FILE *in;	/* can be read again; each run begins at its present position */
	const char *name;	/* of the program */
};

/*
 * Checks the program again and again, each time with one quantity changed by up to its range in one direction. Fills
 * answers[0..], at most 2 * CHANGES, and returns their number; 0: an error was reported. The sink's progress is called;
 * its finding is not.
 * Why a change can be proved harmless: a change by d moves no point farther than d relative to any other body. So a
 * change smaller than the clearance proved without it is harmless. This holds if the positions of the axes are affine
 * in d, which is compared block by block for the values that are tried. For a limit of travel this alone is enough: if
 * two values keep the limit, all values between them keep it. With stock the only proof is that no axis moves
 * differently, because a change also moves the cuts and changes the remaining stock; other answers are only tried.
 */
size_t sensitivity_run(const struct sensitivity_study *study, const struct check_sink *sink, struct diag *diag,
		       struct sensitivity answers[2 * CHANGES]);

void sensitivity_release(struct sensitivity *answers, size_t count);

#endif
