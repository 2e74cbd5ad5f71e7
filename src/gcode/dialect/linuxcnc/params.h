/* params.h - parameters that a program sets: numbered ones, and named ones, global or local to a subprogram call. */
#ifndef FIVECHECK_GCODE_DIALECT_LINUXCNC_PARAMS_H
#define FIVECHECK_GCODE_DIALECT_LINUXCNC_PARAMS_H

#include <stdbool.h>
#include <stddef.h>

/* Numbered parameters are #1 to #5601 (LinuxCNC's RS274NGC_MAX_PARAMETERS). */
#define PARAM_NUMBERS 5602
/* #1 to #30 are local to a call. */
#define PARAM_ARGUMENTS 30
/* Levels of calls; the main program is level 0 (LinuxCNC's INTERP_SUB_ROUTINE_LEVELS). */
#define PARAM_LEVELS 10
/* LinuxCNC takes lines of 255 bytes. */
#define PARAM_NAME_MAX 255
/* The most names of a level: this bounds memory. */
#define PARAM_NAMES_MAX 100000

struct named_param {
	char *name;	/* lower case, without blanks; owned */
	double value;
};

/* Sorted by name. */
struct named_params {
	struct named_param *items;
	size_t count, capacity;
};

/* An assignment, which takes effect after its block has been read. */
struct assignment {
	int number;	/* 0: a named parameter */
	char name[PARAM_NAME_MAX + 1];
	int column;
	double value;
};

struct params {
	double numbered[PARAM_NUMBERS];
	struct named_params global;
	struct named_params local[PARAM_LEVELS];
	int level;
	struct assignment *pending;
	size_t pending_count, pending_capacity;
	double returned;	/* #<_value> */
	bool value_returned;
	bool value_unclear;	/* LinuxCNC computed `returned` while it skipped a sub */
};

void params_release(struct params *params);

/* The parameter of this name at the current level; "_..." is global. NULL: there is none. */
struct named_param *params_find(struct params *params, const char *name);

/* The same; a missing parameter is created with the value 0. NULL: there are too many. */
struct named_param *params_make(struct params *params, const char *name);

/* Call at the start and the end of a call: named parameters are local to the call. */
void params_enter(struct params *params);
void params_leave(struct params *params);

/* Adds an entry at the end of the pending assignments. */
struct assignment *params_assign(struct params *params);

#endif
