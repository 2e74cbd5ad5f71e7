/* leaf.h - triangle against triangle over a region: a proof that they stay apart, or where they do not. */
#ifndef FIVECHECK_SCENE_LEAF_H
#define FIVECHECK_SCENE_LEAF_H

#include <stdbool.h>

#include "scene/region.h"

/* A run of triangles of one body. */
struct leaf {
	uint32_t first;
	uint8_t count;
};

/* Two triangles within the clearance of each other at one instant. */
struct contact {
	double s;	/* of the sweep; meaningless for a box */
	axis_values q;
	double distance;	/* mm, on the programmed path */
	vec3 point;	/* the middle between the closest points, in a's mesh coordinates */
	double path_displacement;	/* mm: how far the path tolerance can move one body as the other sees it; 0: not asked */
};

enum leaf_answer {
	LEAF_APART,	/* proved: farther than the clearance, throughout the region */
	LEAF_TOUCHES,	/* at the region's start (BOX: its middle) they are not: *contact is filled */
	LEAF_OPEN	/* neither; *contact is filled if they touch at the end of a chord */
};

/* Do two leaves stay farther apart than the clearance, and than what the path tolerance may take from it? */
struct leaf_question {
	double clearance;	/* mm */
	double memory_margin;	/* mm: what the axes in the memory must prove beyond that */
	bool final;	/* the region is short enough to be called one instant */
};

/*
 * Answers for all pairs of two leaves' triangles at once. In a region that is
 * `final` what is not apart touches; it is within clearance + path displacement + tolerance.
 * contact->s is only ever lowered. counts one certificate a pair proved.
 */
enum leaf_answer leaf_prove(const struct region *region, const struct body_pair *pair, struct leaf a, struct leaf b,
			    const struct leaf_question *question, struct contact *contact, long *certificates);

#endif
