/* png.h - an image as PNG (ISO/IEC 15948), 8 bits of red, green and blue. */
#ifndef FIVECHECK_REPORT_PICTURE_PNG_H
#define FIVECHECK_REPORT_PICTURE_PNG_H

#include "base/strbuf.h"

/* Appends the file. pixels: three bytes each, rows from top to bottom. */
void png_add(struct strbuf *out, const unsigned char *pixels, int width, int height);

#endif
