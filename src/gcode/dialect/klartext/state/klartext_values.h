/* klartext_values.h - Q parameters, string parameters, and the data that the program has read from the control. */
#ifndef FIVECHECK_GCODE_DIALECT_KLARTEXT_STATE_KLARTEXT_VALUES_H
#define FIVECHECK_GCODE_DIALECT_KLARTEXT_STATE_KLARTEXT_VALUES_H

#include <stdbool.h>

#include "base/axes.h"
#include "gcode/state.h"

/* Q0 to Q1999; QL0 to QL499 of each program; QR0 to QR499. */
#define KLARTEXT_Q_COUNT 2000
#define KLARTEXT_QL_COUNT 500
/* TNC 640 user's manual, "Nesting": 19 nested calls. */
#define KLARTEXT_CALLS_MAX 19
/* The longest name of a label or a program, and the longest string. */
#define KLARTEXT_NAME 128
#define KLARTEXT_STRINGS_MAX 64

/* The query of FN 18: ID, NR and IDX. */
struct klartext_query {
	int id, number, index;
	bool has_index;
};

/* One of Q, QL and QR. */
struct klartext_q {
	double value;
	bool given; /* by this program, or by the control */
	bool read; /* from the control, by FN 18 or FN 28: its value is not known here */
	bool undefined; /* by SET UNDEFINED */
	bool global; /* GLOBAL DEF has another value: whether the parameter has it, too, is not known */
	bool pole; /* read, of an axis whose angle is arbitrary: swivel_pole of the machine would give it */
	struct klartext_query query; /* of FN 18, if FN 18 read it; else the ID is 0 */
};

struct klartext_values {
	struct klartext_q q[KLARTEXT_Q_COUNT], qr[KLARTEXT_QL_COUNT];
	struct klartext_q ql[KLARTEXT_CALLS_MAX + 1][KLARTEXT_QL_COUNT]; /* of each active program */
};

/* QS<number>. */
struct klartext_string {
	int number;
	bool unknown;	/* the control alone has the text */
	char text[KLARTEXT_NAME];
};

struct klartext_strings {
	struct klartext_string items[KLARTEXT_STRINGS_MAX];
	int count;
	bool forgotten; /* FN 28 has read texts that are not known here */
};

/* FN 20: WAIT FOR SYNC. */
struct klartext_sync {
	bool holds; /* no block has moved since FN 20 */
	slot_values position; /* of the axes at FN 20 */
};

#endif
