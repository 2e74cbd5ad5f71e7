/* has_ending.h - the ending of a file name. */
#ifndef FIVECHECK_BASE_HAS_ENDING_H
#define FIVECHECK_BASE_HAS_ENDING_H

#include <stdbool.h>
#include <string.h>

#include "base/ascii.h"

/* Does the name end in this (".stl"), in upper or lower case? */
static inline bool has_ending(const char *path, const char *ending)
{
	const size_t length = strlen(path), tail = strlen(ending);

	return length >= tail && ascii_same(path + length - tail, ending);
}

#endif
