/* index_page.h - the page that names the reports of several programs. */
#ifndef FIVECHECK_REPORT_HTML_INDEX_PAGE_H
#define FIVECHECK_REPORT_HTML_INDEX_PAGE_H

#include <stdbool.h>
#include <stddef.h>

#include "base/diag.h"

/* Borrows everything. */
struct index_page_row {
	const char *program, *link, *word, *sentence;	/* link: the file name of its report; NULL: there is none */
};

/* Writes the file, which takes its name when it is complete. False, reported: the file of this name is as it was. */
bool index_page_write(const char *path, const struct index_page_row *rows, size_t count, struct diag *diag);

#endif
