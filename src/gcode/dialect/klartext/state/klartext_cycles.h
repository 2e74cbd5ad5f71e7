/* klartext_cycles.h - definitions of cycles, and the contours and points that cycles use. */
#ifndef FIVECHECK_GCODE_DIALECT_KLARTEXT_STATE_KLARTEXT_CYCLES_H
#define FIVECHECK_GCODE_DIALECT_KLARTEXT_STATE_KLARTEXT_CYCLES_H

#include <stdbool.h>

#include "gcode/dialect/klartext/state/klartext_values.h"
#include "geom/vec3.h"

/* Parameters of one CYCL DEF: Q200 and the like, or the lines 7.1, 7.2 of older cycles. */
#define KLARTEXT_CYCLE_WORDS 32
/* iTNC 530 user's manual, "CONTOUR GEOMETRY (Cycle 14)": up to 12 subprograms. */
#define KLARTEXT_CONTOURS_MAX 12
/* The largest number of points of PATTERN DEF, CYCL DEF 220 and 221. */
#define KLARTEXT_POINTS_MAX 1000
/* The parameters that GLOBAL DEF gives values to. */
#define KLARTEXT_GLOBALS 18

/* A Q parameter of a cycle, or a letter of a line of an older cycle, which may have no value. */
struct klartext_cycle_word {
	char name[12]; /* "Q200", "X", "DEPTH" */
	int part; /* of an older cycle: the digit after the point in its line */
	double value;
	bool given; /* the name has a value */
	int column;
	long line;
};

struct klartext_cycle {
	int number; /* 200, 7, ...; 0: none */
	int part; /* the digit after the point in the last line of an older cycle */
	bool open; /* further lines may follow */
	bool refused; /* and reported: the rest is read, and has no effect */
	bool by_q; /* its words are Q parameters */
	bool global; /* GLOBAL DEF: it only gives values for PREDEF */
	bool continued; /* by '~' after parameters: the first line without '~' is the last one */
	bool numbered; /* CYCL DEF has a block number: lines without one continue it */
	long line; /* of CYCL DEF */
	int column;
	struct klartext_cycle_word words[KLARTEXT_CYCLE_WORDS];
	int count;
};

struct klartext_cycles {
	struct klartext_cycle definition; /* the cycle that is being read */
	struct klartext_cycle active; /* the cycle that M99 and CYCL CALL carry out */
	bool modal; /* M89: the active cycle is carried out after each move */
	char program[KLARTEXT_NAME]; /* of CYCL DEF 12 */
};

/* The values of GLOBAL DEF; klartext_global.c says for which parameters. */
struct klartext_globals {
	bool given[KLARTEXT_GLOBALS];
	double value[KLARTEXT_GLOBALS]; /* in the units of the program */
};

/* The contours of cycles 21 to 24. */
struct klartext_contour {
	int labels[KLARTEXT_CONTOURS_MAX]; /* of CYCL DEF 14 */
	int count;
	struct klartext_cycle data; /* CYCL DEF 20 */
};

/* The points at which a cycle is called; z is added to its surface. mm. */
struct klartext_points {
	vec3 items[KLARTEXT_POINTS_MAX];
	int count;
	long line; /* the last line of their definition; 0: none */
	bool any_order; /* the control's order of the points is not known */
	bool surface; /* z is the surface itself, in a point table */
	bool single; /* POS of PATTERN DEF has given the last one */
};

#endif
