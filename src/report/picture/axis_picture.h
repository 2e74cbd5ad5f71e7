/*
 * axis_picture.h - pictures of the machine with every axis at 0, and with each axis moved alone in its positive
 * direction, so that a wrong direction is visible.
 */
#ifndef FIVECHECK_REPORT_PICTURE_AXIS_PICTURE_H
#define FIVECHECK_REPORT_PICTURE_AXIS_PICTURE_H

#include "base/strbuf.h"
#include "report/picture/stage.h"

/* The motion of an axis in its picture, mm or radians. All other axes are at 0. */
struct axis_motion {
	double from, to;	/* from < to; both within the travel */
};

/* One camera for all pictures, so that they can be compared. */
struct axis_pictures {
	const struct scene *scene;	/* borrowed; the trees of all bodies have been built */
	struct camera camera;
	double size;	/* mm: approximately that of the machine */
	struct axis_motion motions[SLOT_COUNT];	/* in the order of the machine's axes */
};

void axis_pictures_init(struct axis_pictures *pictures, const struct scene *scene);

/*
 * Appends an element <svg> of a few tens of kB. axis: its number in the machine, or -1: all axes at 0. The bodies that
 * the axis carries are blue, with an arrow from their middle, and a dashed outline shows their start. The gauge point
 * with the direction of the tool, and the mount of the work, are marked.
 */
void axis_pictures_add(struct strbuf *out, const struct axis_pictures *pictures, int axis, const char *title);

#endif
