/* family.h - finds signs that a program was written for another control. */
#ifndef FIVECHECK_GCODE_DIALECT_FAMILY_H
#define FIVECHECK_GCODE_DIALECT_FAMILY_H

#include <stdbool.h>

#include "gcode/text/reader_fault.h"

/* A sign of a family of controls. Strings are constant. */
struct family_sign {
	long line;	/* of the program, from 1; 0: there is no sign */
	const char *sign;	/* for messages */
	const char *title;	/* of the family */
	bool certain;	/* no program of another family has it */
};

/*
 * Finds the first certain sign of another family in the first lines of a program, or else the first uncertain sign.
 * The position of the reader does not change; it must read a file, of which no line was read before.
 */
struct family_sign family_find(struct reader *reader, const char *dialect);

/* The dialect of a program, as far as its first lines show it. */
struct family_guess {
	int row;	/* of control/dialects.h; -1: it is not certain */
	unsigned rows;	/* a bit for each row that agrees with all signs; 0: no dialect reads the program */
	struct family_sign sign;	/* a sign of the dialect; line 0: no sign of any control was found */
	struct family_sign against;	/* a sign of another control; line 0: there is none */
	struct reader_fault end;	/* why no more lines were read: READER_LINE if these lines were enough */
};

/*
 * Finds the dialects that agree with all signs in the first lines; nothing is guessed: a sign that several dialects
 * share (O1234 of Fanuc and Haas) does not decide between them. For the reader see family_find.
 */
struct family_guess family_guess(struct reader *reader);

#endif
