/* call_chain.h - from where a subprogram was called. */
#ifndef FIVECHECK_BASE_CALL_CHAIN_H
#define FIVECHECK_BASE_CALL_CHAIN_H

#include <stddef.h>

#include "base/diag.h"

/* No control lets more calls stand inside each other. */
enum { CALLS_MAX = 20 };

/* Plain data; names of files are borrowed. */
struct call_chain {
	size_t count;	/* 0: the block stands in the program itself */
	struct srcloc calls[CALLS_MAX];	/* the call of the subprogram in hand first, the program's own call last */
};

#endif
