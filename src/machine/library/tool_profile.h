/*
 * tool_profile.h - the outline of a solid of revolution, put together from pieces, and cut into the sections of a
 * setup.
 */
#ifndef FIVECHECK_MACHINE_LIBRARY_TOOL_PROFILE_H
#define FIVECHECK_MACHINE_LIBRARY_TOOL_PROFILE_H

#include <stdbool.h>
#include <stddef.h>

#include "base/arena.h"
#include "machine/description.h"

/* A frustum of the outline: mm, heights above the tip of the tool, low < high. */
struct profile_piece {
	double low, high;
	double radius_low, radius_high;
};

/* All zero is empty. */
struct tool_profile {
	struct profile_piece *pieces;
	size_t count, capacity;
};

void tool_profile_release(struct tool_profile *profile);

/* Adds a frustum between two heights; nothing if they are equal: a step has no volume. */
void tool_profile_add(struct tool_profile *profile, double z0, double r0, double z1, double r1);

/*
 * Adds the surface that an arc sweeps, from one point to another about a center, with frustums that enclose it and
 * leave it by 0.005 mm at most. `left`: the arc turns counter-clockwise, seen with the radius to the right and heights
 * upwards.
 */
void tool_profile_add_arc(struct tool_profile *profile, double z0, double r0, double z1, double r1, double center_z,
			  double center_r, bool left);

/* Adds all pieces of another outline. */
void tool_profile_join(struct tool_profile *profile, const struct tool_profile *other);

/* The height, `from` or above, up to which `inner` does not stick out of `outer`. */
double tool_profile_hides(const struct tool_profile *outer, const struct tool_profile *inner, double from);

/* The largest height; 0 if it is empty. */
double tool_profile_top(const struct tool_profile *profile);

/*
 * Cuts the outer outline between two heights into sections from `high` down to `low`, as a setup has them. Heights at
 * which there is nothing get the diameter `gap`. The sections live in the arena; their lengths add up to high - low.
 */
void tool_profile_sections(const struct tool_profile *profile, double low, double high, double gap,
			   struct arena *arena, struct piece_description *out);

#endif
