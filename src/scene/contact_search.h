/* contact_search.h - looks for axis positions at which two bodies meet. It may miss some; what it finds is there. */
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
 * Do the surfaces come as near as `clearance` (mm) at `near` or, if `steps` are allowed, where the nearest triangles
 * are moved together from there? `near` is moved into the travel from low to high first. True: they do. A look at a
 * place where similar bodies met, for a small part of what contact_search_finds costs.
 */
bool contact_search_recalls(struct contact_search *search, struct sweep *sweep, const struct body_pair *pair,
			    double clearance, const axis_values *low, const axis_values *high, const axis_values *near,
			    int steps);

/*
 * Do the surfaces come as near as `clearance` (mm) at a position between low and high? True: they do. False: none
 * was found. Looks at positions spread over the travel; if `moves`, instead of these it moves the nearest triangles
 * together from a few of them, which finds more and takes ten times as long.
 */
bool contact_search_finds(struct contact_search *search, struct sweep *sweep, const struct body_pair *pair,
			  double clearance, const axis_values *low, const axis_values *high, bool moves);

#endif
