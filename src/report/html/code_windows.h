/* code_windows.h - the text of an NC program for a report: all of it, or windows around findings. */
#ifndef FIVECHECK_REPORT_HTML_CODE_WINDOWS_H
#define FIVECHECK_REPORT_HTML_CODE_WINDOWS_H

#include <jansson.h>
#include <stdbool.h>
#include <stddef.h>

#include "report/html/page.h"

/* Lines per window. */
enum { WINDOW_LINES = 1024 };

/*
 * Writes windows of the file to the page, up to `budget` bytes, those with `marks` (lines, from 1) first; each window
 * is added to the array `windows`. *lines receives the number of lines of the file, -1 if it cannot be read. *complete:
 * nothing was left out. Returns the number of bytes written.
 */
size_t code_windows_write(struct page *page, const char *path, const long *marks, size_t mark_count, size_t budget,
			  json_t *windows, long *lines, bool *complete);

#endif
