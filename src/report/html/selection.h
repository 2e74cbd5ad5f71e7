/* selection.h - selects the pieces of a long table or text for a report of limited size: those near findings. */
#ifndef FIVECHECK_REPORT_HTML_SELECTION_H
#define FIVECHECK_REPORT_HTML_SELECTION_H

#include <stddef.h>

/*
 * Writes the numbers of all pieces to order[0..pieces): those with a mark first, then their neighbours, and so on;
 * without marks in their order. marks[0..count) are numbers of pieces.
 */
void selection_order(size_t *order, size_t pieces, const size_t *marks, size_t count);

#endif
