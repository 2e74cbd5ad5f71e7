/* family.h - does a program look as if it were written for another control than the one that is to read it? */
#ifndef FIVECHECK_GCODE_DIALECT_FAMILY_H
#define FIVECHECK_GCODE_DIALECT_FAMILY_H

#include <stdbool.h>

#include "gcode/text/reader.h"

/* A sign of a family of controls. Strings are constant. */
struct family_sign {
	long line;	/* of the program, from 1; 0: there is no sign */
	const char *sign;	/* as messages write it */
	const char *title;	/* of the family */
	bool certain;	/* no program of another family has it */
};

/*
 * The first certain sign of another family in the first lines of a program, or else the first sign that is not
 * certain. The reader is left where it was; it reads a file, and no line was read of it before.
 */
struct family_sign family_find(struct reader *reader, const char *dialect);

/* Which dialect reads a program, as far as its first lines show it. */
struct family_guess {
	int row;	/* of control/dialects.h; -1: it is not certain */
	unsigned rows;	/* a bit for each row that the signs leave open; 0 where no dialect reads the program */
	struct family_sign sign;	/* what shows it; line 0: no sign of any control was found */
	struct family_sign against;	/* a sign of another control; line 0: there is none */
	const char *advice;	/* what to do with a file that is no text (base/file_signature.h), or NULL */
};

/*
 * Takes what all signs in the first lines have in common; nothing is guessed: a sign that several dialects share
 * (O1234 of Fanuc and Haas) leaves it open. The reader as in family_find.
 */
struct family_guess family_guess(struct reader *reader);

#endif
