/* macro_b_vars.h - the variables of Fanuc's and Haas's macros: local, common, and those that the control fills in. */
#ifndef FIVECHECK_GCODE_DIALECT_FANUC_MACRO_B_VARS_H
#define FIVECHECK_GCODE_DIALECT_FANUC_MACRO_B_VARS_H

#include <stdbool.h>

/* #1 to #33 are a call's own. */
#define MACRO_LOCALS 33
/* Calls inside each other (Fanuc 30i/31i/32i operator's manual, B-63944EN, call nesting: fifteen). */
#define MACRO_CALLS_MAX 15
/* Of which so many by G65 and G66 (the same; Haas's differ by version, so that only the other limit counts there). */
#define MACRO_G65_MAX 5
#define MACRO_COMMON 1000
/* Assignments in one block. */
#define MACRO_ASSIGNED_MAX 16

struct interp;

/* NAN is vacant: no value at all. Plain data, compared byte by byte. */
struct macro_b_vars {
	double local[MACRO_CALLS_MAX + 1][MACRO_LOCALS + 1];
	double common[MACRO_COMMON];	/* #100 to #199, #500 to #999; Haas: #10000 to #10999 as well */
	bool given[MACRO_COMMON];	/* a value by this program */
	int level;	/* of G65 and G66 */
};

double macro_b_vacant(void);

/* Fills everything with vacant. */
void macro_b_vars_init(struct macro_b_vars *vars);

/* The value of #number, NAN if it is vacant. False: reported at the column. */
bool macro_b_vars_read(struct interp *interp, int number, int column, double *value);

/* Gives #number a value, or NAN. False: reported at the column. */
bool macro_b_vars_write(struct interp *interp, int number, int column, double value);

/*
 * The same for #1000 and on (B-63944EN, system variables; Haas mill
 * operator's manual, system variables). What only the machine knows when it
 * runs is a fault that says so. Lengths are in the program's unit.
 */
bool macro_b_system_read(struct interp *interp, int number, int column, double *value);
bool macro_b_system_write(struct interp *interp, int number, int column, double value);

#endif
