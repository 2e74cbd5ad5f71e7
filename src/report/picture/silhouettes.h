/* silhouettes.h - dark lines in a raster where one surface ends in front of another. */
#ifndef FIVECHECK_REPORT_PICTURE_SILHOUETTES_H
#define FIVECHECK_REPORT_PICTURE_SILHOUETTES_H

#include "report/picture/raster.h"

/* As a share of a picture's width: the surface behind an edge is farther away by at least this. */
#define SILHOUETTE_JUMP 0.008

/*
 * Paints the nearer side of each such edge in the darkest level of its class, `width` pixels wide. The surface behind
 * is at least `jump` farther, in the unit of the depths.
 */
void silhouettes_add(struct raster *raster, int width, double jump);

#endif
