/* fault_list.h - the faults of a program that is read on after them: each message once, and not too many. */
#ifndef FIVECHECK_GCODE_FAULT_LIST_H
#define FIVECHECK_GCODE_FAULT_LIST_H

#include "base/diag.h"

/* Errors that are told; further ones are counted. */
#define FAULT_LIST_MAX 20

struct fault_list {
	struct diag diag;	/* what is reported here is passed on */
	struct diag *to;	/* borrowed */
	char *texts[FAULT_LIST_MAX];	/* owned */
	size_t count;	/* told */
	size_t again, beyond;	/* left out: the same messages at other places, and errors after the last one told */
};

void fault_list_init(struct fault_list *list, struct diag *to);

/* Says how many errors were left out, if any were. */
void fault_list_finish(struct fault_list *list, const char *file);

#endif
