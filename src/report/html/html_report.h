/* html_report.h - the report of one program as one HTML file (--report), and the index page of several. */
#ifndef FIVECHECK_REPORT_HTML_HTML_REPORT_H
#define FIVECHECK_REPORT_HTML_HTML_REPORT_H

#include <stdbool.h>
#include <stddef.h>

#include "base/diag.h"
#include "report/html/html_contents.h"

/* Writes the file, which takes its name when it is complete. False, reported: the file of this name is as it was. */
bool html_report_write(const struct html_contents *report, const char *path, struct diag *diag);

/* A row of the index. Borrows everything. */
struct html_index_row {
	const char *program, *link, *word, *sentence;	/* link: the file name of its report; NULL: there is none */
};

bool html_index_write(const char *path, const struct html_index_row *rows, size_t count, struct diag *diag);

#endif
