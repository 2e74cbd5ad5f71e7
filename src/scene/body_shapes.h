/* body_shapes.h - the shapes of a body for plane searches: computed once, shared by all pairs of the body. */
#ifndef FIVECHECK_SCENE_BODY_SHAPES_H
#define FIVECHECK_SCENE_BODY_SHAPES_H

#include "geom/bvh.h"
#include "geom/corner_runs.h"
#include "geom/xform.h"
#include "scene/profile.h"

/* The corners of a tree, and the profiles of the whole tree. Any thread may ask for them. */
struct body_shapes;

/* Borrows the tree, which is at `place`. The caller is the first holder. */
struct body_shapes *body_shapes_new(const struct bvh *bvh, const xform *place);
struct body_shapes *body_shapes_hold(struct body_shapes *shapes);

/* The last holder's release frees the shapes; NULL is none. */
void body_shapes_release(struct body_shapes *shapes);

/* Borrowed. */
const struct corner_runs *body_shapes_corners(struct body_shapes *shapes);

/*
 * profile_init of the whole tree. *visits grows by the same amount whether the profile existed before or not, so that
 * the order in which pairs are checked makes no difference.
 */
void body_shapes_profile(struct body_shapes *shapes, vec3 location, vec3 axis, struct profile *profile, long *visits);

#endif
