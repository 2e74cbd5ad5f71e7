/* sinumerik_block.h - the words of one block. */
#ifndef FIVECHECK_GCODE_DIALECT_SINUMERIK_BLOCK_SINUMERIK_BLOCK_H
#define FIVECHECK_GCODE_DIALECT_SINUMERIK_BLOCK_SINUMERIK_BLOCK_H

#include "gcode/dialect/sinumerik/block/sinumerik_way.h"
#include "gcode/dialect/sinumerik/state/sinumerik_state.h"
#include "gcode/dialect/sinumerik/words/sinumerik_codes.h"

#define SINUMERIK_M_MAX 10

struct sinumerik_block {
	bool any;	/* the line is not empty; N and labels count, too */
	bool machine_axes;	/* X1= and the like, which are allowed with G74 and G75 */
	uint32_t letters;	/* bits of letter_bit for the words of the block, except G, M, N and R */
	int axis_column;	/* the column of the first word of an axis or of a circle's centre; 0: there is none */
	uint32_t addresses;	/* 1 << enum sinumerik_address */
	int column[26], address_column[SINUMERIK_ADDRESSES], code_column[SINUMERIK_GROUPS];
	int code[SINUMERIK_GROUPS];	/* a number in tenths, or a code of a word; CODE_NONE */
	int m_count;
	bool names_tool;	/* T="NAME", in tool_name */
	uint32_t positions;	/* bits of letter_bit: POS[axis]=; the axes are among the letters */
	int positions_column;
	bool spindle_stands;	/* SPOS= */
	bool stops_reading;	/* STOPRE */
	bool modal;	/* MCALL */
	int modal_column;
	char call[SINUMERIK_NAME + 1];	/* "": none; a cycle or a subprogram: its name in upper case */
	int call_column;
	bool call_has_arguments;	/* '(' comes next in the lexer */
	/* The members below are set only for the words that the block has. */
	double value[26];
	unsigned char way[26];
	double address_value[SINUMERIK_ADDRESSES];
	unsigned char address_way[SINUMERIK_ADDRESSES];
	int m[SINUMERIK_M_MAX];
	int m_column[SINUMERIK_M_MAX];
	struct sinumerik_text tool_name;
};

static inline bool sinumerik_block_has(const struct sinumerik_block *block, char letter)
{
	return block->letters & letter_bit(letter);
}

static inline bool sinumerik_block_has_address(const struct sinumerik_block *block, enum sinumerik_address address)
{
	return block->addresses & 1U << address;
}

/* Words that give the centre of a circle. */
#define SINUMERIK_CENTRE_BITS (letter_bit('I') | letter_bit('J') | letter_bit('K'))

/* Words that give a direction of the tool: A3= B3= C3= and, by angles, A2= B2= C2=. */
#define SINUMERIK_VECTOR_BITS (1U << SINUMERIK_A3 | 1U << SINUMERIK_B3 | 1U << SINUMERIK_C3)
#define SINUMERIK_ANGLE_BITS (1U << SINUMERIK_A2 | 1U << SINUMERIK_B2 | 1U << SINUMERIK_C2)
#define SINUMERIK_DIRECTION_BITS (SINUMERIK_VECTOR_BITS | SINUMERIK_ANGLE_BITS)

/* The column of the first axis word, or 1. */
static inline int sinumerik_block_axis_column(const struct sinumerik_block *block)
{
	return block->axis_column ? block->axis_column : 1;
}

/*
 * Reads the words up to the end of the line, or up to the arguments of a call, and executes assignments to variables.
 * Call sinumerik_block_clear before it. False: reported.
 */
bool sinumerik_block_read(struct interp *interp, struct lexer *lexer, struct sinumerik_block *block);

void sinumerik_block_clear(struct sinumerik_block *block);

#endif
