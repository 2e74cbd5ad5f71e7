/* error_list.h - the first errors that were reported, and the first warning, kept for the reports. */
#ifndef FIVECHECK_CLI_ERROR_LIST_H
#define FIVECHECK_CLI_ERROR_LIST_H

#include <stddef.h>

#include "base/diag.h"
#include "report/report.h"

enum { FAULTS_MAX = 10 };

/* All zero is none. */
struct faults {
	struct report_fault *items;	/* owned */
	size_t count;	/* FAULTS_MAX at most */
	long warnings;
	char *first_warning;	/* with its place; owned; NULL: none */
};

/* Keeps a copy of an error or of the first warning; what is neither, or one too many, is let go. */
void faults_keep(struct faults *faults, const struct diag_entry *entry);
void faults_release(struct faults *faults);

/* Give `diag` to whom reports: all goes on to `out`, and errors are kept. */
struct tap {
	struct diag diag;
	struct diag *out;	/* borrowed */
	struct faults faults;
};

/* Not to be moved afterwards: its diag points back at it. */
void tap_init(struct tap *tap, struct diag *out);
void tap_release(struct tap *tap);

#endif
