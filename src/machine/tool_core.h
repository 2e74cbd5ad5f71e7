/* tool_core.h - the core of a tool's solid: the rest after a given depth is removed from its surface. */
#ifndef FIVECHECK_MACHINE_TOOL_CORE_H
#define FIVECHECK_MACHINE_TOOL_CORE_H

#include "base/arena.h"
#include "machine/tool_solid.h"

/*
 * The core of a cutter is the set of its points that are at least `depth` mm below its surface. A cutter whose core
 * stays out of a part enters the part less than `depth` deep. The tool continues above the solid, so only the part of
 * the upper end that is wider than the tool above it is surface. The computed core encloses the exact one, so no
 * contact is missed. For flat, ball, bull and cone tips and for single sections the two are equal. At the corners
 * between sections the computed core is larger by less than `depth`.
 */

/*
 * mm: the depth, or half of it, and so on, so that there is a core although the solid may be thin. With a depth that is
 * larger a drill of 0.3 mm, or a thin saw, would not be checked at all. Also a thin point below a thick cutter and the
 * thin rim of a disc must have a core if they stand out by more than six times the depth, unless the point is as sharp
 * as a needle. The upper end counts as surface. A depth of 0 remains 0.
 */
double tool_core_depth(const struct tool_solid *solid, double depth);

/*
 * Makes the core; a depth of 0 copies the solid. The tool has the radius `above` mm directly above the solid; INFINITY
 * if that is not known. The depth must be one that tool_core_depth returns. The sections of the result are in the
 * arena.
 */
struct tool_solid tool_core(const struct tool_solid *solid, double depth, double above, struct arena *arena);

#endif
