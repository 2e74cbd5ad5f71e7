/* tri_pair.h - the triangles of two leaves over an interval: proves them apart, or finds a contact. */
#ifndef FIVECHECK_SCENE_TRI_PAIR_H
#define FIVECHECK_SCENE_TRI_PAIR_H

#include <stdbool.h>

#include "scene/bvh_pair.h"
#include "scene/motion_interval.h"

/* Two triangles within the clearance of each other at one instant. */
struct contact {
	double s;	/* time in the sweep, 0 to 1; meaningless for a box */
	axis_values q;
	double distance;	/* mm, on the programmed path */
	vec3 point;	/* half-way between the closest points, in a's mesh coordinates */
	double path_displacement;	/* mm: the pair's path displacement at q; 0: not computed */
};

enum tri_pair_answer {
	TRI_PAIR_APART,	/* proved: farther apart than the clearance throughout the interval */
	TRI_PAIR_TOUCHES,	/* not apart at the interval's start (BOX: its middle): *contact is filled in */
	TRI_PAIR_OPEN	/* neither; *contact is filled in if they touch at the end of a chord */
};

/* The question: do two leaves stay farther apart than the clearance plus the path displacement? */
struct tri_pair_query {
	double clearance;	/* mm */
	double coherence_margin;	/* mm: the additional distance that remembered axes must prove */
	bool final;	/* the interval is so short that it counts as one instant */
};

/*
 * Answers for all triangles of two leaves at once. In a `final` interval, triangles that are not proved apart touch:
 * they are within clearance + path displacement + tolerance. contact->s only becomes smaller. *certificates grows by
 * one for each pair that is proved apart.
 */
enum tri_pair_answer tri_pair_prove(const struct motion_interval *interval, const struct body_pair *pair, struct leaf a,
				    struct leaf b, const struct tri_pair_query *question, struct contact *contact,
				    long *certificates);

#endif
