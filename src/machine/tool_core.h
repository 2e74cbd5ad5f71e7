/* tool_core.h - what is left of a tool's solid when a given depth is taken off its surface. */
#ifndef FIVECHECK_MACHINE_TOOL_CORE_H
#define FIVECHECK_MACHINE_TOOL_CORE_H

#include "base/arena.h"
#include "machine/tool_solid.h"

/*
 * The core of a cutter is the set of its points that lie at least `depth` mm
 * below its surface. A cutter whose core stays out of a part enters the part
 * less than `depth` deep. The upper end keeps its place: there the tool goes on.
 *
 * The core that is made encloses the exact one, so no contact is missed. On flat,
 * ball, bull and cone tips and on single sections the two are equal; at the
 * corners between sections the made core is larger by less than `depth`.
 */

/*
 * Makes the core; a depth of 0 copies the solid. Of a solid so thin that nothing
 * lies that deep, half the depth is taken, and so on: a core is never empty, or
 * a thin drill would go unchecked. The sections of the result live in the arena.
 */
struct tool_solid tool_core(const struct tool_solid *solid, double depth, struct arena *arena);

#endif
