/* edge_balance.h - whether a mesh is closed, asked faster than its topology is found. */
#ifndef FIVECHECK_GEOM_EDGE_BALANCE_H
#define FIVECHECK_GEOM_EDGE_BALANCE_H

#include <stdbool.h>

#include "geom/mesh.h"

/*
 * Does every edge run as often one way as the other, and does the mesh enclose a volume? Then it is closed, but for
 * sheets that are drawn from both sides beside a solid. If not, only its topology tells (geom/topology.h). Sums of 64
 * bits of hash decide: an open mesh passes by a chance of 2^-64.
 */
bool edge_balance_is_closed(const struct mesh *mesh);

#endif
