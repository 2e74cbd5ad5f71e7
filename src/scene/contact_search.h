/*
 * contact_search.h - searches axis positions at which two bodies meet. It may miss some, but a found contact is real.
 */
#ifndef FIVECHECK_SCENE_CONTACT_SEARCH_H
#define FIVECHECK_SCENE_CONTACT_SEARCH_H

#include <stdbool.h>

#include "scene/sweep.h"

enum { CONTACTS_KEPT = 4 };

/* The last positions at which bodies met: other bodies often meet near them. All zero is empty. */
struct contact_search {
	axis_values met[CONTACTS_KEPT];	/* the newest first */
	int count;
};

/*
 * Do the surfaces come as near as `clearance` (mm) at `near`, or, with `steps`, after the nearest triangles were moved
 * together from there? `near` is first moved into the travel from low to high. True: they do. It tries a position at
 * which similar bodies met, and costs a small part of contact_search_finds.
 */
bool contact_search_recalls(struct contact_search *search, struct sweep *sweep, const struct body_pair *pair,
			    double clearance, const axis_values *low, const axis_values *high, const axis_values *near,
			    int steps);

/*
 * Do the surfaces come as near as `clearance` (mm) at a position between low and high? True: they do. False: no such
 * position was found. Tries positions spread over the travel; with `moves` it instead moves the nearest triangles
 * together from a few of them, which finds more and takes ten times as long.
 */
bool contact_search_finds(struct contact_search *search, struct sweep *sweep, const struct body_pair *pair,
			  double clearance, const axis_values *low, const axis_values *high, bool moves);

#endif
