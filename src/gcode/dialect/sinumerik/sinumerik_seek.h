/* sinumerik_seek.h - finds labels and the ends of loops and conditions in the file in hand, and jumps there. */
#ifndef FIVECHECK_GCODE_DIALECT_SINUMERIK_SINUMERIK_SEEK_H
#define FIVECHECK_GCODE_DIALECT_SINUMERIK_SINUMERIK_SEEK_H

#include "gcode/dialect/sinumerik/sinumerik_state.h"

/* What stands before the words of a line. */
struct sinumerik_head {
	bool skipped;	/* '/' */
	char number[SINUMERIK_NAME + 1];	/* "N100", or "" */
	char label[SINUMERIK_NAME + 1];	/* in upper case, or "" */
	size_t rest;	/* where the words begin */
};

struct sinumerik_head sinumerik_seek_head(const char *text);

enum sinumerik_direction { SINUMERIK_FORWARD, SINUMERIK_BACKWARD, SINUMERIK_ANYWHERE };

/*
 * Where the label or block number stands, seen from the line in hand. *found tells whether there is one. False: the
 * file could not be read, which was reported at the column.
 */
bool sinumerik_seek_label(struct interp *interp, const char *name, enum sinumerik_direction direction, int column,
			  struct position *to, bool *found);

/* The first one from the line `start` on, up to the line `last`, or to the end of the program if that is 0. */
bool sinumerik_seek_label_behind(struct interp *interp, const char *name, const struct position *start, long last,
				 int column, struct position *to, bool *found);

/* What closes a structure. */
enum sinumerik_close {
	SINUMERIK_ENDIF,
	SINUMERIK_ELSE,	/* or ENDIF, whichever comes first */
	SINUMERIK_ENDWHILE,
	SINUMERIK_ENDFOR,
	SINUMERIK_ENDLOOP,
	SINUMERIK_UNTIL
};

/*
 * The line behind the one that closes the structure of the line in hand. False: there is none, which was reported at
 * the column.
 */
bool sinumerik_seek_close(struct interp *interp, enum sinumerik_close close, int column, struct position *behind);

/* The same for a structure that starts elsewhere in this file. */
bool sinumerik_seek_close_of(struct interp *interp, enum sinumerik_close close, const struct position *start,
			     int column, struct position *behind);

/*
 * Finds the program of this upper-case name among others in the file in hand; *to is the line behind its head. False:
 * reported, or cancelled.
 */
bool sinumerik_seek_program(struct interp *interp, const char *name, int column, struct position *to, bool *found);

/*
 * An archive may have subprograms before its main program: where the head in hand is that of a subprogram
 * (%_N_NAME_SPF), the program begins behind the first head of a main program (_MPF), if there is one. False: reported.
 */
bool sinumerik_seek_main(struct interp *interp);

/* Is this line the head of a main program, %_N_NAME_MPF? */
bool sinumerik_seek_heads_main(const char *text);

/* Is there an M6 behind the line in hand, up to the end of the program? False: the file could not be read: reported. */
bool sinumerik_seek_tool_change(struct interp *interp, int column, bool *found);

/* The first line of the program in hand. */
struct position sinumerik_seek_top(struct interp *interp);

#endif
