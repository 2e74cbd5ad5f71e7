/*
 * cutter_approach.h - how near each cutter comes to the work while it feeds and turns. A cutter that never comes near
 * points to a wrong work offset, tool length or place of the part.
 */
#ifndef FIVECHECK_CHECK_CUTTER_APPROACH_H
#define FIVECHECK_CHECK_CUTTER_APPROACH_H

#include <stdbool.h>
#include <stddef.h>

#include "geom/corner_runs.h"
#include "geom/cylinder_box.h"
#include "machine/motion_bound.h"
#include "motion/events.h"
#include "scene/scene.h"

/* The tools of a program that feed and turn but never come near the work. */
struct far_cutters {
	long fed;	/* number of tools that feed and turn, and whose cutter is described */
	long far;	/* of them, so many never come near; 0: the rest is not filled in */
	/* Of these, the one that comes nearest: */
	int tool;
	double distance;	/* mm: from the cylinder around its cutter to the convex hull of the body, about */
	int body;	/* of the scene: the part or the stock */
	long line;	/* of the block in which it is nearest */
	bool in_subprogram;	/* the line is not one of the program itself */
};

/* The part or the stock. */
struct approach_target {
	const struct bvh *bvh;
	struct solid_box box;	/* around it, in its mesh coordinates */
	struct corner_runs *corners;	/* of the tree; NULL until a cutter is in or near the box */
	xform from_machine;	/* machine coordinates at the zero pose -> those of the mesh */
	int body;
};

struct approach_tool {
	struct cylinder cutter;	/* around it, in machine coordinates at the zero pose */
	bool near;
	struct far_cutters nearest;	/* distance INFINITY: it has not fed yet */
	axis_values last;	/* where the axes were at the last look */
	double last_distance;	/* mm: the distance there, or less; negative: there was no look */
};

struct cutter_approach {
	const char *file;	/* the program */
	struct chain chain;	/* the cutters as the work sees them */
	struct ball ball;	/* around all targets */
	struct approach_target *targets;
	size_t target_count;
	struct approach_tool *tools;
	size_t tool_count;
	bool with_stock;
	int settled;	/* a tool that needs no look any more; -1: none */
};

/*
 * The targets are the parts and the stock, the tools those that cut by turning and are not marked checked="". `file` is
 * the program. Without a scene (NULL) nothing is looked at. Call cutter_approach_release.
 */
void cutter_approach_init(struct cutter_approach *approach, const struct scene *scene, const char *file);
void cutter_approach_release(struct cutter_approach *approach);

void cutter_approach_look(struct cutter_approach *approach, const struct motion_step *step);

/* To be called for each step of the program; costs nothing once the tool in the spindle has been near. */
static inline void cutter_approach_step(struct cutter_approach *approach, const struct motion_step *step)
{
	if (step->step_class == STEP_FEED_TURNING && step->tool != approach->settled)
		cutter_approach_look(approach, step);
}

/* What is known when the program has ended. */
struct far_cutters cutter_approach_result(const struct cutter_approach *approach);

#endif
