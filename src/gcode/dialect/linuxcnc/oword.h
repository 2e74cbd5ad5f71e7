/* oword.h - a line of control flow: an o-word with its label, M98 or M99. */
#ifndef FIVECHECK_GCODE_DIALECT_LINUXCNC_OWORD_H
#define FIVECHECK_GCODE_DIALECT_LINUXCNC_OWORD_H

#include <stdbool.h>

#include "gcode/dialect/linuxcnc/control_flow_state.h"
#include "gcode/text/lexer.h"

struct oword {
	enum o_kind kind;
	int column;	/* of the O or M */
	char name[PARAM_NAME_MAX + 1];	/* the label: lower case, or a number; empty for M98 and M99 */
};

enum oword_result { OWORD_NONE, OWORD_READ, OWORD_FAULT };

/*
 * Is the line control flow? Then the lexer is moved past the label and the keyword. M99 is control flow only inside of
 * subprograms (`called`).
 */
enum oword_result oword_read(struct lexer *lexer, bool called, struct oword *oword);

/* Nothing but comments may follow. */
bool oword_end(struct lexer *lexer, const struct oword *oword);

/* "o100" or "o<name>", for messages; it is written into the buffer, which has OWORD_TITLE bytes. */
#define OWORD_TITLE (PARAM_NAME_MAX + 8)
const char *oword_title(const char *name, char *buffer);

/* "endwhile" */
const char *oword_keyword(enum o_kind kind);

#endif
