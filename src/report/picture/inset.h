/* inset.h - a small picture in a corner of a large one, which shows the contact enlarged. */
#ifndef FIVECHECK_REPORT_PICTURE_INSET_H
#define FIVECHECK_REPORT_PICTURE_INSET_H

#include "report/picture/stage.h"

/* Pixels of the raster. */
struct inset {
	int x, y, width, height;
};

/*
 * Draws the surroundings of the raster's middle, in which the stage was drawn with this camera, enlarged into one of
 * its corners, with a frame of `line` pixels. `below`: pixels that stay free at the lower edge. Returns the place of
 * the inset.
 */
struct inset inset_add(struct raster *raster, const struct stage *stage, const struct camera *camera, int line,
		       int below);

#endif
