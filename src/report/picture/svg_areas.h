/* svg_areas.h - a raster as coloured areas of an SVG picture. */
#ifndef FIVECHECK_REPORT_PICTURE_SVG_AREAS_H
#define FIVECHECK_REPORT_PICTURE_SVG_AREAS_H

#include "base/strbuf.h"
#include "report/picture/raster.h"

/* Appends a <path> for each paint; `tolerance` and `least` as for contours_add. */
void svg_areas_add(struct strbuf *out, const struct raster *raster, double tolerance, int least);

#endif
