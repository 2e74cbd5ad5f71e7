/* block_letters.h - which words of a block its codes use. */
#ifndef FIVECHECK_GCODE_TEXT_BLOCK_LETTERS_H
#define FIVECHECK_GCODE_TEXT_BLOCK_LETTERS_H

#include <stdbool.h>
#include <stdint.h>

#include "gcode/dialect.h"
#include "gcode/text/block.h"

/* Words that a code of the block takes. */
struct block_claim {
	char kind;	/* 'G' or 'M'; 0: words that may be another code's as well */
	int code;
	uint32_t letters;	/* letter bits */
};

#define BLOCK_CLAIMS_MAX 16

/* Is G10 with this L the one that writes the tool table of LinuxCNC (execute/g10_tool_table.h)? */
static inline bool block_writes_tool_table(int mode)
{
	return mode == 1 || mode == 10 || mode == 11;
}

/* What takes words of the block, whose motion is known. Returns how many: codes that take none are left out. */
int block_claims(const struct block *block, const struct dialect *dialect, struct block_claim claims[BLOCK_CLAIMS_MAX]);

/*
 * Is the block's P the number of an additional work offset (G54.1, G154, G54 where it may have one)? G54 leaves
 * another code a P that is the number of no such offset.
 */
bool block_numbers_offset(const struct block *block, const struct dialect *dialect);

/* Does the block call a subprogram or return from one (M97 to M99)? */
bool block_is_call(const struct block *block, const struct dialect *dialect);

#endif
