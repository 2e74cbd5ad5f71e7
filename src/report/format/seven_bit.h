/*
 * seven_bit.h - bytes as text inside a <script> element: seven bits to a character, where base64 has six.
 *
 * The bits of the bytes, the most significant of each first, are read in groups of seven; zeros fill the last group.
 * A group is the character of that number, unless it is one of eight that HTML changes or that a terminal obeys (NUL,
 * CR, SO, SI, SUB, ESC, <, DEL): of these, number i in this order, and the group g after it make one character U+0100
 * + 128 i + g, and if none is left to come after it U+0500 + i. In UTF-8 these have two bytes, so 8 characters of one
 * byte carry 7 bytes. Whoever reads drops the bits that do not fill a byte.
 */
#ifndef FIVECHECK_REPORT_FORMAT_SEVEN_BIT_H
#define FIVECHECK_REPORT_FORMAT_SEVEN_BIT_H

#include <stddef.h>

#include "base/strbuf.h"

/* Appends the bytes as text in UTF-8. */
void seven_bit_add(struct strbuf *out, const void *bytes, size_t count);

#endif
