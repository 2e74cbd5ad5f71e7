/* tool_core.h - the core of a tool's solid: the rest after a given depth is removed from its surface. */
#ifndef FIVECHECK_MACHINE_TOOL_CORE_H
#define FIVECHECK_MACHINE_TOOL_CORE_H

#include "base/arena.h"
#include "machine/tool_solid.h"

/*
 * The core of a cutter is the set of its points that are at least `depth` mm below its surface. A cutter whose core
 * stays out of a part enters the part less than `depth` deep. The upper end is not moved, because the tool continues
 * there. The computed core encloses the exact one, so no contact is missed. For flat, ball, bull and cone tips and for
 * single sections the two are equal. At the corners between sections the computed core is larger by less than `depth`.
 */

/*
 * Makes the core; a depth of 0 copies the solid. If no point of the solid is that deep, half the depth is tried, and so
 * on: an empty core would leave a thin drill unchecked. The sections of the result are in the arena.
 */
struct tool_solid tool_core(const struct tool_solid *solid, double depth, struct arena *arena);

#endif
