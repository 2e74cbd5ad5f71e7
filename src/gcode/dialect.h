/* dialect.h - how one control reads and carries out programs: its codes, its answers as data, and what only it does. */
#ifndef FIVECHECK_GCODE_DIALECT_H
#define FIVECHECK_GCODE_DIALECT_H

#include <stdbool.h>

#include "gcode/codes.h"

struct interp;

/*
 * A control is one folder of gcode/dialect with a table of this type, and one
 * row of control/dialects.h. It inherits nothing: what its table leaves out is
 * unknown, and the program that needs it is refused.
 */

/* Replaced by traits one by one. */
enum gcode_dialect { GCODE_LINUXCNC, GCODE_FANUC, GCODE_HAAS };

/* An answer of 0 is "not known of this control": trait_known refuses its use. */
enum trait_answer { TRAIT_UNKNOWN, TRAIT_YES, TRAIT_NO };

struct dialect_traits {
	enum trait_answer todo;
};

struct dialect {
	const char *name;
	enum gcode_dialect legacy;
	const struct code_set *g_codes[CODE_SETS_MAX], *m_codes[CODE_SETS_MAX];	/* looked through in this order */
	struct dialect_traits traits;
	/*
	 * Hooks; NULL: the control has no such thing. All report what is wrong
	 * before they return false.
	 */
	/* What the hooks remember of a program, in interp->dialect_state; all or none of the two. */
	void *(*state_new)(void);
	void (*state_free)(void *state);
	/* The line in hand if it is a statement and no block, such as control flow: then *done is true. */
	bool (*statement)(struct interp *interp, bool *done);
	/* Fills interp->block from the line in hand; no words: there is nothing to carry out. Never NULL. */
	bool (*read_block)(struct interp *interp);
	/* The block has been read and checked, and nothing of it has been carried out: what it assigns takes effect. */
	bool (*before_block)(struct interp *interp);
	/* The block has been carried out: calls and returns. */
	bool (*after_block)(struct interp *interp);
	/* The file in hand has ended: false if something in it is not closed. */
	bool (*end_of_file)(struct interp *interp);
	/* Adds notes to the message just reported: from where the block in hand was called. */
	void (*note_callers)(struct interp *interp);
};

#endif
