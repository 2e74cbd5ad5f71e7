/* glb.h - the machine and its motion before a finding as glTF 2.0 binary (--glb). */
#ifndef FIVECHECK_REPORT_GLB_GLB_H
#define FIVECHECK_REPORT_GLB_GLB_H

#include <stddef.h>

#include "base/axes.h"
#include "base/strbuf.h"
#include "scene/scene.h"

/* An instant of the animation. */
struct glb_key {
	double time;	/* s; each later than the one before */
	axis_values axes;
};

/* All pointers are borrowed. The trees of all bodies have been built. */
struct glb_scene {
	const struct scene *scene;
	int tool;	/* in the spindle: other tools are left out */
	int a, b;	/* bodies in colour; -1: none */
	const struct mesh *stock;	/* the remaining stock, in its mesh coordinates; NULL: the blank is shown */
	const struct glb_key *keys;	/* at least one; the last is the pose without animation */
	size_t key_count;
};

/*
 * Appends the file, in metres with Y up, as glTF requires. Below the node of the machine there is a node for each axis,
 * with its name, below that of the carrying axis; bodies are below their axis. Vertices are those of the meshes as
 * floats, relative to the axis' location. Between keys axes move uniformly.
 */
void glb_add(struct strbuf *out, const struct glb_scene *scene);

#endif
