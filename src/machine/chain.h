/* chain.h - forward kinematics by product of exponentials, and the joints between two links. */
#ifndef FIVECHECK_MACHINE_CHAIN_H
#define FIVECHECK_MACHINE_CHAIN_H

#include <stdbool.h>
#include <stddef.h>

#include "base/axes.h"
#include "geom/xform.h"
#include "machine/machine.h"

/* The pose of a link's zero-pose geometry when the axes are at q (mm, radians). */
xform machine_pose(const struct machine *machine, int link, const axis_values *q);

/* Is the link the carrier, or carried by it, directly or indirectly? Every link is on link 0, the base. */
bool machine_link_is_on(const struct machine *machine, int link, int carrier);

/* One joint of a chain; the direction is that of the motion, so it includes the sign of the axis. */
struct joint {
	int slot;
	bool rotary;
	vec3 direction;	/* unit, in machine coordinates at the zero pose */
	vec3 location;
};

/*
 * The joints between a fixed link and a moved one, starting at the fixed link: pose(moved in fixed) = E1(q1) E2(q2) ...
 * En(qn).
 */
struct chain {
	size_t count;
	struct joint joints[SLOT_COUNT];
};

void chain_init(struct chain *chain, const struct machine *machine, int fixed, int moved);

/* The pose of the moved link's zero-pose geometry in the fixed link's. */
xform chain_pose(const struct chain *chain, const axis_values *q);

/* Is any joint between the links? */
static inline bool chain_is_rigid(const struct chain *chain)
{
	return chain->count == 0;
}

#endif
