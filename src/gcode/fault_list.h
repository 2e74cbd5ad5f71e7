/* fault_list.h - the faults of a program that is read on after a fault: each message once, up to a limit. */
#ifndef FIVECHECK_GCODE_FAULT_LIST_H
#define FIVECHECK_GCODE_FAULT_LIST_H

#include <stdbool.h>
#include <stddef.h>

#include "base/diag.h"

/* The errors that are reported; further ones are only counted. */
#define FAULT_LIST_MAX 20

struct fault_list {
	struct diag diag;	/* messages reported here are passed on to `to` */
	struct diag *to;	/* borrowed */
	char *texts[FAULT_LIST_MAX];	/* owned */
	size_t count;	/* reported */
	size_t again, beyond;	/* left out: the same messages at other places, and errors beyond the limit */
	bool left_out;	/* the last error was left out, and so are the notes that belong to it */
};

void fault_list_init(struct fault_list *list, struct diag *to);

/* Reports the number of errors that were left out, if any. */
void fault_list_finish(struct fault_list *list, const char *file);

#endif
