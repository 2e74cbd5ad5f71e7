/*
 * range_coder.h - bits written in less than a bit each, where they can be foretold: a binary range coder (G. N. N.
 * Martin, Range encoding, 1979) with probabilities that adapt.
 *
 * How to read it back: range = 2^32 - 1, code = the first five bytes, big endian, modulo 2^32. For a bit with the
 * model (p, seen): bound = floor(range / 65536) * p; code < bound means 1, and range = bound; else 0, code -= bound,
 * range -= bound. The model learns: shift = bits that the number seen + 1 has, at most 5; p += floor((65536 - p) /
 * 2^shift) after a 1, p -= floor(p / 2^shift) after a 0; then p is at least 32 and at most 65504; seen += 1. While
 * range < 2^24: range *= 256, code = 256 code + the next byte.
 */
#ifndef FIVECHECK_REPORT_FORMAT_RANGE_CODER_H
#define FIVECHECK_REPORT_FORMAT_RANGE_CODER_H

#include <stdbool.h>
#include <stdint.h>

#include "base/strbuf.h"

/* The prediction for a bit. At first both values have the same probability. */
struct bit_model {
	uint16_t learnt;	/* 65536 times the probability of 1, less 32768: 0 is a half */
	uint8_t seen;	/* bits, up to 16 */
};

/* The prediction for a whole number. Zeroed memory is a model without experience. */
enum { NUMBER_BITS = 33 };
struct number_model {
	struct bit_model length[NUMBER_BITS + 1];
	/* by length: the first bit below the highest, and the one after it */
	struct bit_model top[NUMBER_BITS + 1][3];
};

struct range_coder {
	struct strbuf *out;	/* borrowed */
	uint64_t low;
	uint32_t range;
	uint8_t held;	/* a byte that a carry may still change */
	uint64_t held_back;	/* it, and bytes 255 after it */
};

void range_coder_init(struct range_coder *coder, struct strbuf *out);
void range_coder_bit(struct range_coder *coder, struct bit_model *model, bool bit);

/*
 * A number, of which small ones are likelier. With n = the number of bits of value + 1: n - 1 ones and a zero (models
 * length[1] ...), then the bits below the highest one: the first under top[n][0], the second under top[n][1 + the
 * first], the others each under a new model.
 */
void range_coder_number(struct range_coder *coder, struct number_model *model, uint32_t value);

/* Call it once, after the last bit. */
void range_coder_finish(struct range_coder *coder);

#endif
