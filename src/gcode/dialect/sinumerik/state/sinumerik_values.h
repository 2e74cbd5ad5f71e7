/* sinumerik_values.h - texts, variables, macros and arguments of the program. */
#ifndef FIVECHECK_GCODE_DIALECT_SINUMERIK_STATE_SINUMERIK_VALUES_H
#define FIVECHECK_GCODE_DIALECT_SINUMERIK_STATE_SINUMERIK_VALUES_H

#include "gcode/dialect/sinumerik/words/sinumerik_name.h"

/* 840D sl, NC programming: a string has at most 200 bytes. */
#define SINUMERIK_TEXT 200

struct sinumerik_text {
	char bytes[SINUMERIK_TEXT + 1];
};

/* 840D sl, NC programming: arrays have up to three dimensions; R0 to R999. */
#define SINUMERIK_DIMENSIONS 3
#define SINUMERIK_R_COUNT 1000

enum sinumerik_type { SINUMERIK_INT, SINUMERIK_REAL, SINUMERIK_BOOL, SINUMERIK_CHAR, SINUMERIK_STRING, SINUMERIK_AXIS };

/* Variables of the machine's maker and of users (GUD) belong to no program. */
#define SINUMERIK_LEVEL_OF_CONTROL (-1)

/* A variable that DEF, PROC (a parameter), or the machine file has made. */
struct sinumerik_variable {
	char name[SINUMERIK_NAME + 1];	/* upper case */
	enum sinumerik_type type;
	int dimensions;	/* 0: one value */
	int size[SINUMERIK_DIMENSIONS];
	int length;	/* of STRING[length]; 0: none was given */
	size_t count;
	double *numbers;	/* owned; NULL: texts; AXIS: slots */
	struct sinumerik_text *texts;	/* owned */
	bool *given;	/* owned: the known values of a variable of the control; NULL: all are known */
	int refers_to;	/* a VAR parameter: the variable of the caller; or -1 */
	int level;	/* the level of calls of its program */
};

struct sinumerik_variables {
	struct sinumerik_variable *items;	/* owned; variables of the control come first */
	size_t count, capacity;
	size_t elements;	/* elements of all variables */
	double r[SINUMERIK_R_COUNT];	/* NAN: the program has not assigned it */
};

/* A macro that DEFINE has made. */
struct sinumerik_macro {
	char name[SINUMERIK_NAME + 1];	/* upper case */
	char *text;	/* owned */
	int level;	/* of the call whose program has made it */
};

struct sinumerik_macros {
	struct sinumerik_macro *items;	/* owned */
	size_t count, capacity;
};

/* Which operators the current expression has; the order of comparisons and AND must be certain. */
struct sinumerik_logic {
	bool compares;	/* ==, <, and so on */
	bool joins;	/* AND, OR or XOR */
};

/* The maximum number of parameters of a subprogram or a cycle. */
#define SINUMERIK_ARGUMENTS_MAX 40

/* The arguments of the current call, as they were read. */
struct sinumerik_passed {
	size_t count;
	double numbers[SINUMERIK_ARGUMENTS_MAX];	/* NAN: left out */
	struct sinumerik_text texts[SINUMERIK_ARGUMENTS_MAX];
	bool is_text[SINUMERIK_ARGUMENTS_MAX];
	int variable[SINUMERIK_ARGUMENTS_MAX];	/* the caller's variable that stands alone as argument, or -1 */
};

#endif
