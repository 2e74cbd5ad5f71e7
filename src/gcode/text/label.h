/* label.h - the labels of a program that have been read so far, and their places. */
#ifndef FIVECHECK_GCODE_TEXT_LABEL_H
#define FIVECHECK_GCODE_TEXT_LABEL_H

#include <stddef.h>

#include "gcode/text/source.h"

/* The most labels: this bounds memory. */
#define LABELS_MAX 100000

struct label {
	char *key;	/* owned */
	int kind;	/* the dialect's own */
	struct position at;	/* of the label's line */
	struct position body;	/* of the next line */
	bool counting;	/* the loop that starts here has repetitions left */
};

/* Sorted by key; the address of an entry never changes. */
struct labels {
	struct label **items;
	size_t count, capacity;
};

void labels_release(struct labels *labels);

/* NULL: no such label has been read. */
struct label *labels_find(const struct labels *labels, const char *key);

/* Adds an entry for a new key. NULL: there are too many labels. */
struct label *labels_add(struct labels *labels, const char *key, int kind);

#endif
