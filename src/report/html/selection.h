/* selection.h - which pieces of something long go into a report of limited size: those near what was found. */
#ifndef FIVECHECK_REPORT_HTML_SELECTION_H
#define FIVECHECK_REPORT_HTML_SELECTION_H

#include <stddef.h>

/*
 * Writes to order[0..pieces) the numbers of all pieces: those with a mark first, then those beside them, and so on;
 * without marks from the first piece on. marks[0..count) are numbers of pieces.
 */
void selection_order(size_t *order, size_t pieces, const size_t *marks, size_t count);

#endif
