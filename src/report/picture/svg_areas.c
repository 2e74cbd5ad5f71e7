#include "report/picture/svg_areas.h"

#include "report/picture/contours.h"
#include "report/picture/stage.h"

void svg_areas_add(struct strbuf *out, const struct raster *raster, double tolerance, int least)
{
	for (int paint = PAINT_LEVELS; paint < PAINT_CLASSES * PAINT_LEVELS; paint++) {
		struct strbuf outlines = {0};

		contours_add(&outlines, raster, (uint8_t)paint, tolerance, least);
		if (outlines.length) {
			const uint32_t colour = paint_colour((uint8_t)paint);

			/* The stroke closes gaps between the outlines of neighbours. */
			strbuf_addf(out, "<path fill=\"#%06x\" stroke=\"#%06x\" d=\"%s\"/>\n", (unsigned)colour,
				    (unsigned)colour, outlines.text);
		}
		strbuf_release(&outlines);
	}
}
