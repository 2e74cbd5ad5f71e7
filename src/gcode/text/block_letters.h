/* block_letters.h - which words of a block its codes use. */
#ifndef FIVECHECK_GCODE_TEXT_BLOCK_LETTERS_H
#define FIVECHECK_GCODE_TEXT_BLOCK_LETTERS_H

#include <stdbool.h>
#include <stdint.h>

#include "gcode/dialect.h"
#include "gcode/text/block.h"

/*
 * The bits of the letters that some code of the block uses; its motion is known. The words of calls are not among them.
 */
uint32_t block_used_letters(const struct block *block, const struct dialect *dialect);

/*
 * Is the block's P the number of an additional work offset (G54.1, G154, G54 where it may have one)? Beside M98, G54
 * leaves it a P that is the number of no such offset.
 */
bool block_numbers_offset(const struct block *block, const struct dialect *dialect);

/* Does the block call a subprogram or return from one (M97 to M99)? */
bool block_is_call(const struct block *block, const struct dialect *dialect);

#endif
