/*
 * cutter_approach.h - measures how near each cutter comes to the work while it feeds and turns. A cutter that never
 * comes near points to a wrong work offset, tool length or location of the part.
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
	long fed;	/* tools that feed and turn, and have a cutter */
	long far;	/* those of them that never come near; 0: the rest is not filled in */
	/* The nearest of these: */
	int tool;
	double distance;	/* mm: from the cylinder around its cutter to the convex hull of the body, about */
	int body;	/* of the scene: the part or the stock */
	long line;	/* the block in which it is nearest */
	bool in_subprogram;	/* the line is in a subprogram */
};

/* The part or the stock. */
struct approach_target {
	const struct bvh *bvh;
	struct solid_box box;	/* bounds in its mesh coordinates */
	struct corner_runs *corners;	/* of the tree; NULL until a cutter is in or near the box */
	xform from_machine;	/* machine coordinates at the zero pose -> those of the mesh */
	int body;
};

/* Axis positions, and a lower bound of the distance from the nearest target there. */
struct approach_place {
	axis_values q;
	double distance;	/* mm */
};

struct approach_tool {
	struct cylinder cutter;	/* bounds in machine coordinates at the zero pose */
	bool near;
	struct far_cutters nearest;	/* distance INFINITY: it has not fed yet */
	struct approach_place last;	/* of the last measurement; a negative distance: none */
};

struct cutter_approach {
	const char *file;	/* the program */
	struct chain chain;	/* from the work to the cutters */
	struct ball ball;	/* around all targets */
	struct approach_target *targets;
	size_t target_count;
	struct approach_tool *tools;
	size_t tool_count;
	bool with_stock;
	int settled;	/* a tool that needs no more measurements; -1: none */
};

/*
 * The targets are the parts and the stock; the tools are those that cut by turning and are not marked checked="".
 * `file` is the program. Without a scene (NULL) nothing is measured. Call cutter_approach_release.
 */
void cutter_approach_init(struct cutter_approach *approach, const struct scene *scene, const char *file);
void cutter_approach_release(struct cutter_approach *approach);

void cutter_approach_look(struct cutter_approach *approach, const struct motion_step *step);

/* Call it for each step of the program; it costs nothing once the tool in the spindle has been near. */
static inline void cutter_approach_step(struct cutter_approach *approach, const struct motion_step *step)
{
	if (step->step_class == STEP_FEED_TURNING && step->tool != approach->settled)
		cutter_approach_look(approach, step);
}

/* The result at the end of the program. */
struct far_cutters cutter_approach_result(const struct cutter_approach *approach);

#endif
