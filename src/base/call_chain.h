/* call_chain.h - the calls that led into a subprogram. */
#ifndef FIVECHECK_BASE_CALL_CHAIN_H
#define FIVECHECK_BASE_CALL_CHAIN_H

#include <stddef.h>

#include "base/diag.h"

/* No control allows more nested calls. */
enum { CALLS_MAX = 20 };

/* Plain data; names of files are borrowed. */
struct call_chain {
	size_t count;	/* 0: the block is in the program itself */
	struct srcloc calls[CALLS_MAX];	/* the call of the current subprogram first, the call in the program last */
};

#endif
