/* family_signs.h - what in a line of a program is a sign of a family of controls. */
#ifndef FIVECHECK_GCODE_DIALECT_FAMILY_SIGNS_H
#define FIVECHECK_GCODE_DIALECT_FAMILY_SIGNS_H

#include <stdbool.h>

/* Controls that read each other's programs, and the dialects for them; there may be none. */
struct family {
	const char *title;
	const char *dialects[3];
};

enum sign_match {
	/* The line has the text: */
	MATCH_START,
	MATCH_ANYWHERE,
	MATCH_ALL,	/* and nothing else */
	MATCH_G,	/* without a further digit or point */
	MATCH_ADDRESS,	/* but not as the end of a longer name */
	MATCH_CALL,	/* at the start of the line, with a parenthesis that is no comment */
	MATCH_FIRST_CALL,	/* no other parenthesis precedes it */
	MATCH_STRAIGHT_LINE,	/* in a straight move of Klartext */
	/* The line has this form: */
	MATCH_PROGRAM_NUMBER,
	MATCH_O_CALL,
	MATCH_R_PARAMETER,
	MATCH_PROC,
	MATCH_ASSIGNED_ADDRESS,
	MATCH_OKUMA_VARIABLE,
	MATCH_FRAME,
	MATCH_UNITS,
	MATCH_TOOL_EDGE
};

struct sign {
	const struct family *family;
	const char *text;	/* of a squeezed line (line_shape.h), after its number */
	const char *shown;	/* in messages */
	enum sign_match match;
	bool certain;	/* no program of another family has it */
};

/* All signs; after the last one there is one without a family. */
extern const struct sign family_signs[];

/* Has the line this sign? `block` is the squeezed line. */
bool family_signs_match(const struct sign *sign, const char *line, const char *block);

#endif
