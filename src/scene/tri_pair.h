/* tri_pair.h - triangle against triangle over an interval: a proof that they stay apart, or where they do not. */
#ifndef FIVECHECK_SCENE_TRI_PAIR_H
#define FIVECHECK_SCENE_TRI_PAIR_H

#include <stdbool.h>

#include "scene/bvh_pair.h"
#include "scene/motion_interval.h"

/* Two triangles within the clearance of each other at one instant. */
struct contact {
	double s;	/* of the sweep; meaningless for a box */
	axis_values q;
	double distance;	/* mm, on the programmed path */
	vec3 point;	/* the middle between the closest points, in a's mesh coordinates */
	double path_displacement;	/* mm: how far the path tolerance can move one body as the other sees it; 0: not asked */
};

enum tri_pair_answer {
	TRI_PAIR_APART,	/* proved: farther than the clearance, throughout the interval */
	TRI_PAIR_TOUCHES,	/* at the interval's start (BOX: its middle) they are not: *contact is filled */
	TRI_PAIR_OPEN	/* neither; *contact is filled if they touch at the end of a chord */
};

/* Do two leaves stay farther apart than the clearance, and than what the path tolerance may take from it? */
struct tri_pair_query {
	double clearance;	/* mm */
	double coherence_margin;	/* mm: what the remembered axes must prove beyond that */
	bool final;	/* the interval is short enough to be called one instant */
};

/*
 * Answers for all pairs of two leaves' triangles at once. In an interval that is
 * `final` what is not apart touches; it is within clearance + path displacement + tolerance.
 * contact->s is only ever lowered. counts one certificate a pair proved.
 */
enum tri_pair_answer tri_pair_prove(const struct motion_interval *interval, const struct body_pair *pair, struct leaf a, struct leaf b,
			    const struct tri_pair_query *question, struct contact *contact, long *certificates);

#endif
