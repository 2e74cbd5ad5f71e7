/* raster.h - triangles drawn with a depth buffer; a pixel holds the number of a paint. */
#ifndef FIVECHECK_REPORT_PICTURE_RASTER_H
#define FIVECHECK_REPORT_PICTURE_RASTER_H

#include <stdbool.h>
#include <stdint.h>

#include "geom/vec3.h"

/* Rows from top to bottom. Paint 0 is the background. */
struct raster {
	int width, height;
	uint8_t *paints;
	float *depths;	/* greater is nearer */
};

void raster_init(struct raster *raster, int width, int height);
void raster_release(struct raster *raster);

/* Is there a pixel whose centre the triangle might cover? Most triangles of a small picture have none. */
bool raster_may_show(const struct raster *raster, const vec3 corners[3]);

/* Draws a triangle: x and y in pixels, z its depth. Parts outside are cut off. */
void raster_triangle(struct raster *raster, const vec3 corners[3], uint8_t paint);

#endif
