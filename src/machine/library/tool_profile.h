/* tool_profile.h - the outline of a solid of revolution, made from pieces and divided into the sections of a setup. */
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

/* All zero is an empty outline. */
struct tool_profile {
	struct profile_piece *pieces;
	size_t count, capacity;
};

void tool_profile_release(struct tool_profile *profile);

/* Adds a frustum between two heights; nothing if they are equal, because a step has no volume. */
void tool_profile_add(struct tool_profile *profile, double z0, double r0, double z1, double r1);

/*
 * Adds the surface of revolution of an arc between two points about a center, as frustums that enclose it and deviate
 * by at most 0.005 mm. `left`: the arc is counter-clockwise, with the radius to the right and heights upward.
 */
void tool_profile_add_arc(struct tool_profile *profile, double z0, double r0, double z1, double r1, double center_z,
			  double center_r, bool left);

/* Adds all pieces of another outline. */
void tool_profile_join(struct tool_profile *profile, const struct tool_profile *other);

/* The largest height, `from` or above, up to which `inner` does not extend outside `outer`. */
double tool_profile_hides(const struct tool_profile *outer, const struct tool_profile *inner, double from);

/* The largest height; 0 if the outline is empty. */
double tool_profile_top(const struct tool_profile *profile);

/*
 * Divides the outer outline between two heights into sections from `high` down to `low`, as in a setup. Heights without
 * a piece get the diameter `gap`. The sections are in the arena; their lengths add up to high - low.
 */
void tool_profile_sections(const struct tool_profile *profile, double low, double high, double gap,
			   struct arena *arena, struct piece_description *out);

#endif
