/* mesh_order.h - an order of triangles in which each, where possible, shares an edge with the one before it. */
#ifndef FIVECHECK_REPORT_HTML_MESH_ORDER_H
#define FIVECHECK_REPORT_HTML_MESH_ORDER_H

#include <stddef.h>
#include <stdint.h>

/*
 * Reorders the triangles, three vertices below `vertices` each, and turns each of them so that an edge which it shares with an
 * earlier one comes first. Their sense stays.
 */
void mesh_order(uint32_t *corners, size_t triangles, size_t vertices);

#endif
