/* contours.h - converts the areas of equal paint in a raster to outlines of an SVG path. */
#ifndef FIVECHECK_REPORT_PICTURE_CONTOURS_H
#define FIVECHECK_REPORT_PICTURE_CONTOURS_H

#include "base/strbuf.h"
#include "report/picture/raster.h"

/*
 * Appends the outlines of all areas of the paint (SVG 1.1, 8.3, for fill-rule evenodd), in pixels, each within
 * `tolerance` pixels of the true one; areas of less than `least` pixels are left out. Appends nothing if there is no
 * area.
 */
void contours_add(struct strbuf *out, const struct raster *raster, uint8_t paint, double tolerance, int least);

#endif
