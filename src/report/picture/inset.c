#include "report/picture/inset.h"

#include <stddef.h>
#include <string.h>

#include "report/picture/silhouettes.h"

/* A third of the large picture's width, enlarged four times. */
enum { SHARE = 3, ENLARGED = 4 };

static long shown_in(const struct raster *raster, const struct inset *inset)
{
	long count = 0;

	for (int y = inset->y; y < inset->y + inset->height; y++) {
		for (int x = inset->x; x < inset->x + inset->width; x++)
			count += raster->paints[y * raster->width + x] / PAINT_LEVELS >= PAINT_A;
	}
	return count;
}

/* The corner that shows least of the bodies that meet. The names of the bodies are in the upper left one. */
static struct inset choose_corner(const struct raster *raster, int gap, int below)
{
	const int width = raster->width / SHARE, height = raster->height / SHARE;
	const int right = raster->width - width - gap, low = raster->height - height - gap - below;
	const struct inset corners[] = {
		{right, low, width, height}, {right, gap, width, height}, {gap, low, width, height}};
	struct inset best = corners[0];

	for (size_t i = 1; i < sizeof(corners) / sizeof(*corners); i++) {
		if (shown_in(raster, &corners[i]) < shown_in(raster, &best))
			best = corners[i];
	}
	return best;
}

static void fill(struct raster *raster, const struct inset *inset, int border, uint8_t paint)
{
	const size_t width = (size_t)inset->width + 2 * (size_t)border;

	for (int y = inset->y - border; y < inset->y + inset->height + border; y++)
		memset(&raster->paints[y * raster->width + inset->x - border], paint, width);
}

struct inset inset_add(struct raster *raster, const struct stage *stage, const struct camera *camera, int line,
		       int below)
{
	const struct inset inset = choose_corner(raster, 4 * line, below);
	struct camera nearer = *camera;
	struct raster small;

	nearer.scale *= (double)ENLARGED * raster->width / inset.width;
	raster_init(&small, inset.width, inset.height);
	stage_draw(stage, &nearer, &small);
	silhouettes_add(&small, line, SILHOUETTE_JUMP / nearer.scale);
	fill(raster, &inset, 2 * line, PAINT_NONE);
	fill(raster, &inset, line, PAINT_BASE * PAINT_LEVELS);
	for (int y = 0; y < inset.height; y++)
		memcpy(&raster->paints[(inset.y + y) * raster->width + inset.x], &small.paints[y * small.width],
		       (size_t)inset.width);
	raster_release(&small);
	return inset;
}
