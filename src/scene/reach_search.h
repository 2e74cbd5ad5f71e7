/* reach_search.h - are two bodies out of each other's reach, over the whole travel of the axes between them? */
#ifndef FIVECHECK_SCENE_REACH_SEARCH_H
#define FIVECHECK_SCENE_REACH_SEARCH_H

#include <stdbool.h>

#include "scene/contact_search.h"
#include "scene/scene.h"
#include "scene/sweep.h"

struct last_contact;
struct last_tool;

/* The searches of one thread. The data kept about other pairs saves work and changes no result. */
struct reach_search {
	struct contact_search contacts;
	struct sweep sweep;
	struct last_contact *last;	/* owned: of each body and each role */
	struct last_tool *tools;	/* owned: likewise */
};

void reach_search_init(struct reach_search *search, const struct scene *scene);
void reach_search_release(struct reach_search *search);

/* Is the pair proved to stay apart over the whole travel? The proof stops after a fixed number of steps: false. */
bool reach_search_proves(struct reach_search *search, struct scene *scene, const struct scene_pair *pair,
			 const struct body_pair *bodies);

enum reach { REACH_APART, REACH_MEETS, REACH_UNKNOWN };

/*
 * Tests a tool's piece, the second body of the pair, by its sections, which takes a small part of the time of its
 * triangles. If a corner of the other body, whose tree is given, is inside the piece, no proof over the travel is
 * possible.
 */
enum reach reach_search_tool(struct reach_search *search, struct scene *scene, const struct scene_pair *pair,
			     const struct bvh *tree);

#endif
