/* block_letters.h - finds the words that each code of a block uses. */
#ifndef FIVECHECK_GCODE_TEXT_BLOCK_LETTERS_H
#define FIVECHECK_GCODE_TEXT_BLOCK_LETTERS_H

#include <stdbool.h>
#include <stdint.h>

#include "gcode/dialect.h"
#include "gcode/text/block.h"

/* Words that a code of the block takes. */
struct block_claim {
	char kind;	/* 'G' or 'M'; 0: words that another code may use, too */
	int code;
	uint32_t letters;	/* letter bits */
};

#define BLOCK_CLAIMS_MAX 16

/* Does G10 with this L write the tool table of LinuxCNC (execute/g10_tool_table.h)? */
static inline bool block_writes_tool_table(int mode)
{
	return mode == 1 || mode == 10 || mode == 11;
}

/* Finds the codes that use words of the block, whose motion is known. Returns their number. */
int block_claims(const struct block *block, const struct dialect *dialect, struct block_claim claims[BLOCK_CLAIMS_MAX]);

/*
 * Is the block's P the number of an additional work offset (G54.1, G154, or G54 on controls where G54 takes P)? G54
 * leaves a P to another code if P is not the number of such an offset.
 */
bool block_numbers_offset(const struct block *block, const struct dialect *dialect);

#endif
