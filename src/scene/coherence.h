/* coherence.h - axes and triangles with which the last proof of a pair succeeded, to be tried first next time. */
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

/* The nearest points of two triangles when they were last measured (near_pair.h). */
struct near_points {
	bool known;
	uint32_t a, b;	/* the triangles of the trees */
	vec3 on_a, on_b;	/* each in its own mesh coordinates */
	bool a_replaced;	/* the last nearer triangle found is a's */
};

/*
 * The last axes that separated the bodies, newest first, and two triangles that were close. They change how fast an
 * answer comes, but never the answer. All zero is empty.
 */
struct coherence {
	struct coherence_axis axes[COHERENCE_AXES];
	int axis_count;
	int idle, idleness;	/* subtrees to skip now; subtrees to skip after the next failure */
	uint32_t near_a, near_b;	/* triangles of the trees */
	struct near_points points;
	double near;	/* mm: the distance of the two triangles in the last distance query */
};

/*
 * Remembers that n, a unit vector in a's mesh coordinates, separates the bodies at the pose: once fixed to a and once
 * fixed to b.
 */
void coherence_learn(struct coherence *coherence, vec3 n, const xform *pose);

/*
 * Does an axis keep two triangles more than `clearance` apart throughout the interval, which is a chord? b0 and b1 are
 * b's triangle at the ends of the interval, in a's mesh coordinates. The axis is fixed in its frame, so at both ends
 * the gap must exceed the interval's `displacement` of that view.
 */
bool coherence_separates_triangles(struct coherence *coherence, const struct motion_interval *interval, const tri *a,
				   const tri *b0, const tri *b1, double clearance);

/*
 * The same for all triangles under two subtrees, if there are few and this has succeeded lately. Where two surfaces
 * bulge towards each other, one axis separates many triangles whose boxes overlap.
 */
bool coherence_separates_subtrees(struct coherence *coherence, const struct motion_interval *interval,
				  const struct body_pair *pair, const struct subtree *a, const struct subtree *b,
				  double clearance);

/* The largest gap in mm between two boxes at one pose along any of the axes; negative: no axis separates them. */
double coherence_gap(struct coherence *coherence, const xform *pose, const struct body_pair *pair, const struct box *a,
		     const struct box *b);

#endif
