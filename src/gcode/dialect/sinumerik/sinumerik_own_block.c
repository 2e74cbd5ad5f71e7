#include "gcode/dialect/sinumerik/sinumerik_own_block.h"

#include "gcode/dialect/sinumerik/sinumerik_polar.h"

/* Addresses of a motion, without those of a pole. */
#define MOTION_ADDRESSES (SINUMERIK_DIRECTION_BITS | SINUMERIK_LINE_BIT | 1U << SINUMERIK_CR | 1U << SINUMERIK_AR | \
			  1U << SINUMERIK_TURN | 1U << SINUMERIK_I1 | 1U << SINUMERIK_J1 | 1U << SINUMERIK_K1 | \
			  1U << SINUMERIK_CHF | 1U << SINUMERIK_CHR | 1U << SINUMERIK_RND)

static bool is_pole(int once)
{
	return once >= SINUMERIK_G(110) && once <= SINUMERIK_G(112);
}

static bool is_limit(int once)
{
	return once == SINUMERIK_G(25) || once == SINUMERIK_G(26);
}

/* The column of the code that takes the words of this block; 0: only a motion takes them. */
static int taker_column(const struct sinumerik_block *block)
{
	const int once = block->code[SINUMERIK_ONCE];

	if (block->code[SINUMERIK_FRAME] != CODE_NONE)
		return block->code_column[SINUMERIK_FRAME];
	return once == CODE_NONE || once == SINUMERIK_G(63) ? 0 : block->code_column[SINUMERIK_ONCE];
}

static bool refuse(struct interp *interp, int column, int taker)
{
	return fault(&interp->at, column,
		     "the code at column %d takes the words of its block, and leaves none for this one: write two "
		     "blocks",
		     taker);
}

/* Words of a motion that no code takes. */
static bool check_left(struct interp *interp, const struct sinumerik_block *block, int taker)
{
	const uint32_t polar = is_pole(block->code[SINUMERIK_ONCE]) ? 0 : SINUMERIK_POLAR_BITS;

	for (const char *letter = "IJK"; *letter; letter++) {
		if (sinumerik_block_has(block, *letter))
			return refuse(interp, block->column[*letter - 'A'], taker);
	}
	for (int i = 0; i < SINUMERIK_ADDRESSES; i++) {
		if (block->addresses & (MOTION_ADDRESSES | polar) & 1U << i)
			return refuse(interp, block->address_column[i], taker);
	}
	return true;
}

bool sinumerik_own_block_check(struct interp *interp, const struct sinumerik_block *block)
{
	const int once = block->code[SINUMERIK_ONCE], motion = block->code[SINUMERIK_MOTION];
	const int taker = taker_column(block);

	if (once != CODE_NONE && block->code[SINUMERIK_FRAME] != CODE_NONE)
		return refuse(interp, block->code_column[SINUMERIK_ONCE], taker);
	if (taker == 0)
		return true;
	if (block->positions)
		return refuse(interp, block->positions_column, taker);
	/* G0 to G3 only select the next motion; threads, CIP and CT need words of their own. */
	if (motion > G3 || (motion != CODE_NONE && is_limit(once) && (block->letters & AXIS_BITS)))
		return refuse(interp, block->code_column[SINUMERIK_MOTION], taker);
	if (once == G4 && sinumerik_block_has(block, 'F') && sinumerik_block_has(block, 'S'))
		return refuse(interp, block->column['S' - 'A'], taker);
	return check_left(interp, block, taker);
}
