/* klartext_calls.h - the active subprograms, programs and program section repeats. */
#ifndef FIVECHECK_GCODE_DIALECT_KLARTEXT_STATE_KLARTEXT_CALLS_H
#define FIVECHECK_GCODE_DIALECT_KLARTEXT_STATE_KLARTEXT_CALLS_H

#include <stdbool.h>

#include "base/strbuf.h"
#include "gcode/dialect/klartext/state/klartext_values.h"
#include "gcode/state.h"
#include "gcode/text/label.h"

/* The largest number of program section repeats that are active at the same time. */
#define KLARTEXT_REPEATS_MAX 100

enum klartext_call_kind { KLARTEXT_MAIN, KLARTEXT_LABEL, KLARTEXT_PROGRAM };

/* An active subprogram; the first one is the main program. */
struct klartext_call {
	enum klartext_call_kind kind;
	char title[KLARTEXT_NAME]; /* "LBL 5", "sub.h" */
	struct position back;
	const char *file; /* of the call */
	long line;
	int column;
};

/* An active CALL LBL ... REP. */
struct klartext_repeat {
	struct position at; /* of its line */
	int level; /* of calls */
	int left;
	long long start; /* offset of its label */
	bool left_by_jump; /* a jump left the section: it is not known whether the count restarts */
};

struct klartext_calls {
	struct klartext_call items[KLARTEXT_CALLS_MAX + 1];
	int level; /* nested calls */
	int programs; /* nested calls of programs among them */
	struct klartext_repeat repeats[KLARTEXT_REPEATS_MAX];
	int repeat_count;
	struct labels labels; /* of every source that was searched */
	bool jumped; /* blocks are counted from the first jump on */
	char selected[KLARTEXT_NAME]; /* by SEL PGM; empty: none */
	struct strbuf folders; /* of the files that were called */
};

#endif
