/* error_list.h - keeps the first errors and the first warning for the reports. */
#ifndef FIVECHECK_CLI_ERROR_LIST_H
#define FIVECHECK_CLI_ERROR_LIST_H

#include <stddef.h>

#include "base/diag.h"
#include "report/report.h"

enum { ERROR_LIST_MAX = REPORT_ERRORS_MAX };

/* All zero is an empty list. */
struct error_list {
	struct report_error *items;	/* owned */
	size_t count;	/* ERROR_LIST_MAX at most */
	long warnings;
	char *first_warning;	/* with its place; owned; NULL: none */
};

/* Keeps a copy of the first ERROR_LIST_MAX errors and of the first warning, and counts the warnings. */
void error_list_add(struct error_list *errors, const struct diag_entry *entry);
void error_list_release(struct error_list *errors);

#endif
