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
 * Do the surfaces come as near as `clearance` (mm) at a position between low and high? True: they do. False: none
 * was found.
 */
bool contact_search_finds(struct contact_search *search, struct sweep *sweep, const struct body_pair *pair,
			  double clearance, const axis_values *low, const axis_values *high);

#endif
