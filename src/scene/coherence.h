/* coherence.h - what helped to prove a pair apart a moment ago will probably help again. */
#ifndef FIVECHECK_SCENE_COHERENCE_H
#define FIVECHECK_SCENE_COHERENCE_H

#include <stdbool.h>
#include <stdint.h>

#include "geom/boxes.h"
#include "geom/tri.h"
#include "scene/bvh_pair.h"
#include "scene/motion_interval.h"

enum { COHERENCE_AXES = 4 };

/* A unit vector in the mesh coordinates of a (frame 0) or b (frame 1): it moves with that body. */
struct coherence_axis {
	vec3 n;
	int frame;
};

/*
 * The axes that separated last, the newest first, and two triangles that were
 * close. What is remembered changes how fast an answer comes, never the answer's truth.
 * All zero is empty.
 */
struct coherence {
	struct coherence_axis axes[COHERENCE_AXES];
	int axis_count;
	int idle, idleness;	/* subtrees not to be tried for now, and after the next failure */
	uint32_t near_a, near_b;	/* triangles of the trees */
	double near;	/* mm: how close they, or others, were when the distance was last asked for */
};

/* Learns that n, a unit vector of a's mesh coordinates, separates at the pose: kept as it is, and as b sees it. */
void coherence_learn(struct coherence *coherence, vec3 n, const xform *pose);

/* The axis was of use: it comes first from now on. */
void coherence_prefer(struct coherence *coherence, int axis);

/*
 * Does an axis keep two triangles more than `clearance` apart throughout the
 * interval, which is a chord? b0 and b1 are b's at its ends, in a's mesh coordinates. The
 * axis is fixed in its frame, so the gap must exceed the stray of that view at both ends.
 */
bool coherence_separates_triangles(struct coherence *coherence, const struct motion_interval *interval, const tri *a, const tri *b0,
			    const tri *b1, double clearance);

/*
 * The same for all triangles under two subtrees, while they are few and this has been of use lately: where two
 * surfaces bulge towards each other one axis tells many triangles apart that no boxes do.
 */
bool coherence_separates_subtrees(struct coherence *coherence, const struct motion_interval *interval, const struct body_pair *pair,
			   const struct subtree *a, const struct subtree *b, double clearance);

/* The largest gap that an axis shows between two boxes at one pose, mm; negative: none does. */
double coherence_gap(struct coherence *coherence, const xform *pose, const struct body_pair *pair, const struct box *a,
		  const struct box *b);

#endif
