#include "report/picture/silhouettes.h"

#include <stddef.h>

#include "report/picture/stage.h"

/*
 * At an edge the depth increases more than this times as much as on the surface before it, which may be seen at a flat
 * angle.
 */
#define STEEPER 3

/* Does the surface end within `width` pixels in this direction? Nothing ends outside the raster. */
static bool ends(const struct raster *raster, int x, int y, int dx, int dy, double jump)
{
	const int there_x = x + dx, there_y = y + dy, back_x = x - dx, back_y = y - dy;
	double here, falls, fell;

	if (there_x < 0 || there_y < 0 || back_x < 0 || back_y < 0 || there_x >= raster->width ||
	    back_x >= raster->width || there_y >= raster->height || back_y >= raster->height)
		return false;
	here = raster->depths[y * raster->width + x];
	falls = here - raster->depths[there_y * raster->width + there_x];
	fell = raster->depths[back_y * raster->width + back_x] - here;
	return falls > jump && !(falls <= STEEPER * fell);
}

void silhouettes_add(struct raster *raster, int width, double jump)
{
	for (int y = 0; y < raster->height; y++) {
		for (int x = 0; x < raster->width; x++) {
			uint8_t *paint = &raster->paints[y * raster->width + x];

			if (*paint >= PAINT_LEVELS &&
			    (ends(raster, x, y, width, 0, jump) || ends(raster, x, y, -width, 0, jump) ||
			     ends(raster, x, y, 0, width, jump) || ends(raster, x, y, 0, -width, jump)))
				*paint = (uint8_t)(*paint - *paint % PAINT_LEVELS);
		}
	}
}
