/* picture.h - a picture of the machine at one instant (--picture): SVG for pages, PNG for everything else. */
#ifndef FIVECHECK_REPORT_PICTURE_PICTURE_H
#define FIVECHECK_REPORT_PICTURE_PICTURE_H

#include "base/strbuf.h"
#include "report/picture/stage.h"

/*
 * Appends an element <svg> of a few tens of kB, with `title` for screen readers. `fine`: with more detail, and with the
 * title and the names of both bodies in the picture; otherwise they belong in the caption.
 */
void picture_add_svg(struct strbuf *out, const struct stage *stage, const char *title, bool fine);

/* Appends an element <figcaption>: both bodies with their colours, and the title. */
void picture_add_caption(struct strbuf *out, const struct stage *stage, const char *title);

/* Appends a PNG file. */
void picture_add_png(struct strbuf *out, const struct stage *stage);

#endif
