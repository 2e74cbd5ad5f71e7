/*
 * convex.h - the support function of a part of a body: of its convex hull, or of the convex hull of all places to which
 * a rotary joint can turn it.
 */
#ifndef FIVECHECK_SCENE_CONVEX_H
#define FIVECHECK_SCENE_CONVEX_H

#include <stdbool.h>

#include "geom/bvh.h"
#include "geom/corner_runs.h"
#include "geom/xform.h"
#include "scene/bvh_pair.h"
#include "scene/profile.h"

/*
 * Corners of a part that reached farthest in some direction, in its mesh coordinates from the tree's origin. They are
 * tried before the tree. All zero is empty.
 */
enum { SEEN_CORNERS = 32 };

struct seen_corners {
	int count, next;
	float x[SEEN_CORNERS], y[SEEN_CORNERS], z[SEEN_CORNERS];
};

/*
 * A part of a body at one pose. Borrows everything. With a profile it is the hull of the rings about the axis, and the
 * ball encloses these.
 */
struct convex {
	const struct mesh_part *mesh;
	const xform *place;	/* mesh coordinates -> those of the pose */
	struct seen_corners *seen;	/* of the mesh; or NULL */
	const struct profile *profile;	/* or NULL */
	vec3 location, axis;	/* of the profile, at the pose */
	vec3 centre;	/* of the ball, at the pose */
	double radius;	/* mm */
};

/* The triangles below a leaf of a tree, and a ball around them, all in mesh coordinates. Borrows tree and corners. */
struct mesh_part {
	const struct bvh *bvh;
	const struct corner_runs *corners;	/* of the tree */
	struct leaf leaf;
	vec3 centre;
	double radius;	/* mm */
};

struct mesh_part mesh_part_of(const struct bvh *bvh, const struct corner_runs *corners, struct leaf leaf);

/* The part of a mesh at `place`, without or with a profile. seen: the part's seen corners, or NULL. */
struct convex convex_of_mesh(const struct mesh_part *part, const xform *place, struct seen_corners *seen);
struct convex convex_of_profile(const struct profile *profile, vec3 location, vec3 axis);

/*
 * An upper bound of the greatest m.p over the points p, in double; at most |m| times `slack` mm plus two millionths of
 * the body's size too large. m is any vector. *at, unless NULL, is a point that reaches as far to within the same. With
 * a slack, boxes that exceed the best known point by less need not be opened; in a finely meshed round body these are
 * many. Adds the cost in node pairs to *visits.
 */
double convex_support(const struct convex *convex, vec3 m, double slack, vec3 *at, long *visits);

/* The largest numbers of steps: with supports, and before these with seen corners. */
enum { CONVEX_STEPS = 24, CONVEX_GUESSES = 16 };

/* The result of a search for a direction. */
struct convex_search {
	vec3 direction;	/* unit, from a to b */
	/* Each from a point of a to one of b: no gap along n is larger than n.seen. */
	vec3 seen[CONVEX_GUESSES + CONVEX_STEPS];
	int count;
};

/*
 * Searches a direction along which the parts are nearly as far apart as possible (Gilbert, Johnson and Keerthi, 1988).
 * False: none was found. The direction is a guess: the supports show how good it is.
 */
bool convex_direction(const struct convex *a, const struct convex *b, struct convex_search *search, long *visits);

#endif
