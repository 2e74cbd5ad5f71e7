/* index_page.h - the page that lists the reports of several programs. */
#ifndef FIVECHECK_REPORT_HTML_INDEX_PAGE_H
#define FIVECHECK_REPORT_HTML_INDEX_PAGE_H

#include <stdbool.h>
#include <stddef.h>

#include "base/diag.h"

/* All pointers are borrowed. */
struct index_page_row {
	const char *program, *link, *word, *sentence;	/* link: the file name of its report; NULL: there is none */
};

/*
 * Writes the file, which gets its name when it is complete. False, reported: an existing file with this name is not
 * changed.
 */
bool index_page_write(const char *path, const struct index_page_row *rows, size_t count, struct diag *diag);

#endif
