/* diag.h - errors, warnings and notes about the input, with their places: every layer reports here, only cli prints. */
#ifndef FIVECHECK_BASE_DIAG_H
#define FIVECHECK_BASE_DIAG_H

#include <stdarg.h>
#include <stddef.h>

#include "base/strbuf.h"

/* A place in a file. Lines and columns count from 1; 0 means not known. */
struct srcloc {
	const char *file;	/* as the user named it; NULL: no file */
	long line;
	int column;	/* in bytes */
};

enum diag_severity { DIAG_NOTE, DIAG_WARNING, DIAG_ERROR };

struct diag_entry {
	enum diag_severity severity;
	struct srcloc loc;
	const char *text;	/* one line, no final newline */
	const char *excerpt;	/* the faulty line, for a caret under loc.column; or NULL */
	long block;	/* its block, counted from 1 in the order of execution; 0: not in a block */
};

/*
 * Counts the entries and passes each one on immediately, so that nothing accumulates while a long program streams. An
 * entry is valid only during the call.
 */
struct diag {
	void (*handle)(void *context, const struct diag_entry *entry);	/* NULL: only count */
	void *context;
	size_t errors;
	size_t warnings;
};

/* Errors are rare: code that only reports one stays out of the code that runs for every block. */
#define DIAG_REPORTS __attribute__((cold, format(printf, 3, 4)))

void diag_error(struct diag *diag, struct srcloc loc, const char *format, ...) DIAG_REPORTS;
void diag_warning(struct diag *diag, struct srcloc loc, const char *format, ...) DIAG_REPORTS;
void diag_note(struct diag *diag, struct srcloc loc, const char *format, ...) DIAG_REPORTS;

/* The general form; excerpt may be NULL. */
void diag_report(struct diag *diag, enum diag_severity severity, struct srcloc loc, const char *excerpt,
		 const char *format, va_list args) __attribute__((format(printf, 5, 0)));

/* Passes on an entry as if it had been reported to `diag`. */
void diag_pass(struct diag *diag, const struct diag_entry *entry);

/*
 * Appends the entry in the GNU form, one line and then the excerpt with its
 * caret:  file:line:column: error: text
 */
void diag_format(struct strbuf *out, const struct diag_entry *entry);

#endif
