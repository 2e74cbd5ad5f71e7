/* label.h - where the o-words of a program stand that have been met so far. */
#ifndef FIVECHECK_GCODE_TEXT_LABEL_H
#define FIVECHECK_GCODE_TEXT_LABEL_H

#include <stddef.h>

#include "gcode/text/source.h"

/* So many, so that memory is bounded. */
#define LABELS_MAX 100000

/* Kinds of o-words; O_PROGRAM is an O-word alone, which names a subprogram for M98. */
enum o_kind {
	O_SUB, O_ENDSUB, O_CALL, O_DO, O_WHILE, O_REPEAT, O_IF, O_ELSEIF, O_ELSE, O_ENDIF, O_BREAK, O_CONTINUE,
	O_ENDWHILE, O_ENDREPEAT, O_RETURN, O_PROGRAM, O_M98, O_M99
};

struct label {
	char *key;	/* of a subprogram its name, of others "subprogram#name"; owned */
	enum o_kind kind;
	struct position at;	/* of its line */
	struct position body;	/* of the line after it */
	bool counting;	/* a repeat that has not counted down to its end */
};

/* Sorted by key; entries stay where they are. */
struct labels {
	struct label **items;
	size_t count, capacity;
};

void labels_release(struct labels *labels);

/* NULL: not met. */
struct label *labels_find(const struct labels *labels, const char *key);

/* A new entry; the key is new. NULL: there are too many. */
struct label *labels_add(struct labels *labels, const char *key, enum o_kind kind);

#endif
