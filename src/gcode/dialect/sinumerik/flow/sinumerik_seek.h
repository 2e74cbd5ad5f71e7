/* sinumerik_seek.h - finds labels and the ends of loops and conditions in the current file, and jumps there. */
#ifndef FIVECHECK_GCODE_DIALECT_SINUMERIK_FLOW_SINUMERIK_SEEK_H
#define FIVECHECK_GCODE_DIALECT_SINUMERIK_FLOW_SINUMERIK_SEEK_H

#include "gcode/dialect/sinumerik/state/sinumerik_state.h"

/* The part of a line before its words. */
struct sinumerik_head {
	bool skipped;	/* '/' */
	char number[SINUMERIK_NAME + 1];	/* "N100", or "" */
	char label[SINUMERIK_NAME + 1];	/* in upper case, or "" */
	size_t rest;	/* the index at which the words begin */
};

struct sinumerik_head sinumerik_seek_head(const char *text);

enum sinumerik_direction { SINUMERIK_FORWARD, SINUMERIK_BACKWARD, SINUMERIK_ANYWHERE };

/*
 * Finds the label or block number, seen from the current line. *found: there is one. False: the file could not be
 * read, or there are several in this direction, which was reported at the column. SINUMERIK_ANYWHERE looks backward
 * only if there is none forward. On a pipe, the search ends READER_WINDOW after the current line with an error.
 */
bool sinumerik_seek_label(struct interp *interp, const char *name, enum sinumerik_direction direction, int column,
			  struct position *to, bool *found);

/*
 * The same from the line `start` on, up to the line `last`; 0: up to the end of the program. only: there must not be
 * a second one; else the first one counts.
 */
bool sinumerik_seek_label_behind(struct interp *interp, const char *name, const struct position *start, long last,
				 bool only, int column, struct position *to, bool *found);

/* The statement that closes a structure. */
enum sinumerik_close {
	SINUMERIK_ENDIF,
	SINUMERIK_ELSE,	/* or ENDIF, if it comes first */
	SINUMERIK_ENDWHILE,
	SINUMERIK_ENDFOR,
	SINUMERIK_ENDLOOP,
	SINUMERIK_UNTIL
};

/*
 * Finds the line after the statement that closes the structure of the current line. False: there is none, which was
 * reported at the column.
 */
bool sinumerik_seek_close(struct interp *interp, enum sinumerik_close close, int column, struct position *behind);

/* The same for a structure that begins elsewhere in this file. */
bool sinumerik_seek_close_of(struct interp *interp, enum sinumerik_close close, const struct position *start,
			     int column, struct position *behind);

/*
 * Finds the head of the program with this upper-case name, and of the type 'M' or 'S' if it is not 0, in a file with
 * several programs. False: there are two, or the file could not be read, which was reported; or cancelled.
 */
bool sinumerik_seek_program(struct interp *interp, struct source *source, const char *name, char type, int column,
			    struct position *head, bool *found);

/*
 * An archive may have subprograms before its main program. If the current head is that of a subprogram
 * (%_N_NAME_SPF), the program begins after the first head of a main program (_MPF), if there is one. False: reported.
 */
bool sinumerik_seek_main(struct interp *interp);

/* Is this line the head of a main program, %_N_NAME_MPF? */
bool sinumerik_seek_heads_main(const char *text);

/*
 * Does an M6 follow the current line, up to the end of the program? False: the file could not be read, which was
 * reported.
 */
bool sinumerik_seek_tool_change(struct interp *interp, int column, bool *found);

/* The first line of the current program. */
struct position sinumerik_seek_top(struct interp *interp);

#endif
