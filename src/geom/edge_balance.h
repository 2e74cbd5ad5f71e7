/* edge_balance.h - decides whether a mesh is closed, faster than by its topology. */
#ifndef FIVECHECK_GEOM_EDGE_BALANCE_H
#define FIVECHECK_GEOM_EDGE_BALANCE_H

#include <stdbool.h>

#include "geom/mesh.h"

/*
 * Is every edge used as often in one direction as in the other, and does the mesh enclose a volume? Then it is closed,
 * except for sheets that are drawn from both sides beside a solid. If not, its topology must decide (geom/topology.h).
 * The test compares sums of 64-bit hashes: an open mesh passes with a probability of 2^-64.
 */
bool edge_balance_is_closed(const struct mesh *mesh);

/*
 * Is every edge used as often in one direction as in the other, of those with an end that has a coordinate of at most
 * `near` mm? The same test, for few edges.
 */
bool edge_balance_near_zero(const struct mesh *mesh, float near);

#endif
