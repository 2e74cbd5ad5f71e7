/* draft.h - small pictures of the contact, to judge a camera by; they are never shown. */
#ifndef FIVECHECK_REPORT_PICTURE_DRAFT_H
#define FIVECHECK_REPORT_PICTURE_DRAFT_H

#include <stddef.h>

#include "report/picture/raster.h"
#include "report/picture/stage.h"

/* From how far above the horizon cameras look, in degrees. */
enum { DRAFT_RISES = 3 };
extern const int draft_rises[DRAFT_RISES];

/*
 * What cameras can see, as coarse as a small picture can show it: corners stand on a grid of its pixels, and triangles
 * that shrink to a line or a point, as most of a fine mesh do, are left out. Neighbours share their corners, so that no
 * gaps open.
 */
struct draft {
	int width, height;	/* of its pictures */
	double grid;	/* mm */
	struct draft_triangle *triangles;	/* owned */
	size_t count, capacity;
	struct ball *balls;	/* owned; one around some triangles in a row, which mostly are neighbours */
};

/*
 * Of what cameras show that look at the stage's point from the heights of draft_rises, in pictures whose width is 1 /
 * scale mm: bodies a and b, and what may hide them.
 */
void draft_init(struct draft *draft, const struct stage *stage, double scale);

/* The same, `times` as coarse. */
void draft_init_coarser(struct draft *draft, const struct draft *fine, int times);
void draft_release(struct draft *draft);

/* Draws it on a raster of its size; of the paints only the classes are right. */
void draft_draw(const struct draft *draft, const struct camera *camera, struct raster *raster);

#endif
