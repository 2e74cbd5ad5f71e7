/* draft.h - small pictures of the contact for comparing cameras; they are never shown. */
#ifndef FIVECHECK_REPORT_PICTURE_DRAFT_H
#define FIVECHECK_REPORT_PICTURE_DRAFT_H

#include <stddef.h>

#include "report/picture/raster.h"
#include "report/picture/stage.h"

/* The heights of cameras above the horizon, in degrees. */
enum { DRAFT_RISES = 3 };
extern const int draft_rises[DRAFT_RISES];

/*
 * The visible triangles, as coarse as a small picture can show them: corners are on a grid of its pixels, and triangles
 * that become a line or a point, as most of a fine mesh do, are left out. Neighbours share their corners, so there are
 * no gaps.
 */
struct draft {
	int width, height;	/* of its pictures */
	double grid;	/* mm */
	struct draft_triangle *triangles;	/* owned */
	size_t count, capacity;
	struct ball *balls;	/* owned; each around some consecutive triangles, which are mostly neighbours */
};

/*
 * For cameras that look at the stage's point from the heights of draft_rises, in pictures whose width is 1 / scale mm:
 * bodies a and b, and everything that may hide them.
 */
void draft_init(struct draft *draft, const struct stage *stage, double scale);

/* The same, coarser by the factor `times`. */
void draft_init_coarser(struct draft *draft, const struct draft *fine, int times);
void draft_release(struct draft *draft);

/* Draws the draft on a raster of its size; of the paints only the classes are correct. */
void draft_draw(const struct draft *draft, const struct camera *camera, struct raster *raster);

#endif
