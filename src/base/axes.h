/* axes.h - the nine axis letters of a controller, in their canonical order. */
#ifndef FIVECHECK_BASE_AXES_H
#define FIVECHECK_BASE_AXES_H

#include <stdbool.h>

#include "base/same_double.h"

/* X Y Z and U V W are linear (mm), A B C rotary (radians inside, degrees in files). */
enum axis_slot { SLOT_X, SLOT_Y, SLOT_Z, SLOT_A, SLOT_B, SLOT_C, SLOT_U, SLOT_V, SLOT_W, SLOT_COUNT };

#define AXIS_LETTERS "XYZABCUVW"

/* One value for each slot; the slots that a machine does not have stay 0. */
typedef struct axis_values {
	double v[SLOT_COUNT];
} axis_values;

static inline bool slot_is_rotary(int slot)
{
	return slot >= SLOT_A && slot <= SLOT_C;
}

/* See same_double: exactly equal. */
static inline bool axis_values_same(const axis_values *a, const axis_values *b)
{
	for (int slot = 0; slot < SLOT_COUNT; slot++) {
		if (!same_double(a->v[slot], b->v[slot]))
			return false;
	}
	return true;
}

/* The point at the share s of the straight line from a to b. */
static inline axis_values axis_values_between(const axis_values *a, const axis_values *b, double s)
{
	axis_values q;

	for (int i = 0; i < SLOT_COUNT; i++)
		q.v[i] = (1 - s) * a->v[i] + s * b->v[i];
	return q;
}

static inline axis_values axis_values_middle(const axis_values *a, const axis_values *b)
{
	return axis_values_between(a, b, 0.5);
}

/* The slot of an upper-case letter, or -1. */
static inline int slot_of_letter(char letter)
{
	static const signed char after[] = {
	    ['X' - 'A'] = SLOT_X + 1, ['Y' - 'A'] = SLOT_Y + 1, ['Z' - 'A'] = SLOT_Z + 1,
	    ['A' - 'A'] = SLOT_A + 1, ['B' - 'A'] = SLOT_B + 1, ['C' - 'A'] = SLOT_C + 1,
	    ['U' - 'A'] = SLOT_U + 1, ['V' - 'A'] = SLOT_V + 1, ['W' - 'A'] = SLOT_W + 1};

	return letter >= 'A' && letter <= 'Z' ? after[letter - 'A'] - 1 : -1;
}

#endif
