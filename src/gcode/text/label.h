/* label.h - the labels of a program that have been met so far, and where they stand. */
#ifndef FIVECHECK_GCODE_TEXT_LABEL_H
#define FIVECHECK_GCODE_TEXT_LABEL_H

#include <stddef.h>

#include "gcode/text/source.h"

/* The limit that bounds memory. */
#define LABELS_MAX 100000

struct label {
	char *key;	/* owned */
	int kind;	/* the dialect's own */
	struct position at;	/* of its line */
	struct position body;	/* of the line after it */
	bool counting;	/* the loop that starts here has not counted down to its end */
};

/* Sorted by key; entries stay where they are. */
struct labels {
	struct label **items;
	size_t count, capacity;
};

void labels_release(struct labels *labels);

/* NULL: no such label was met. */
struct label *labels_find(const struct labels *labels, const char *key);

/* A new entry; the key is new. NULL: there are too many. */
struct label *labels_add(struct labels *labels, const char *key, int kind);

#endif
