/* sensitivity.h - by how much a work offset or the tool length may be wrong before the verdict of a program changes. */
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
	SENSITIVITY_TURNS,	/* at `turn` the verdict is another one */
	SENSITIVITY_UNKNOWN	/* a change of `turn` could not be checked (`why`), or too many runs were needed */
};

/* The answer for one quantity in one direction. Lengths in mm; amounts of change are 0 or more. */
struct sensitivity {
	int quantity;	/* CHANGE_... */
	int sign;	/* 1, -1 */
	double range;	/* the largest change that was asked for */
	enum sensitivity_state state;
	/* the verdict is proved to be clear for every change up to this; 0 if it is not clear to begin with */
	double proved;
	double tried;	/* the verdict is the same at all changes that were tried up to this */
	double turn;
	long line;	/* of the block with the finding that decides */
	int kind;	/* enum finding_kind; -1: at `turn` nothing is found */
	const char *a, *b;	/* names of its bodies, owned by the scene; NULL: a limit, then: */
	int slot;
	char *why;	/* of UNKNOWN: the error, or NULL; owned */
};

/* A program that was checked, and what may be changed in its setup. Borrows everything. */
struct sensitivity_study {
	struct scene *scene;
	const struct check_options *options;	/* `all` and the measurements in them are ignored */
	const double *range;	/* mm: the largest change of each of CHANGES; 0: none */
	enum check_result result;	/* the verdict without a change, not INCOMPLETE */
	FILE *in;	/* can be read again; each run begins where it stands now */
	const char *name;	/* of the program */
};

/*
 * Checks the program again and again, each time with one quantity changed by up to its range in one direction. Fills
 * answers[0..], at most 2 * CHANGES, and returns how many; 0: a fault was reported. The sink's progress is called; its
 * finding is not.
 * Why a change is proved harmless: a change by d moves no point farther than d, as any other body sees it. So a change
 * smaller than the clearance proved without it does no harm. That holds if the axes' positions are affine in d, which
 * is compared block by block for the values that are tried. For a limit of travel this alone is enough: if two values
 * keep the limit, all values between them keep it. With stock nothing is proved but that no axis moves differently: a
 * change moves the cuts, too, and so what remains of the stock. The answers then tell what was tried.
 */
size_t sensitivity_run(const struct sensitivity_study *study, const struct check_sink *sink, struct diag *diag,
		       struct sensitivity answers[2 * CHANGES]);

void sensitivity_release(struct sensitivity *answers, size_t count);

#endif
