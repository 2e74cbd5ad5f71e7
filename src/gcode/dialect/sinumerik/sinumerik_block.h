/* sinumerik_block.h - the words of one block. */
#ifndef FIVECHECK_GCODE_DIALECT_SINUMERIK_SINUMERIK_BLOCK_H
#define FIVECHECK_GCODE_DIALECT_SINUMERIK_SINUMERIK_BLOCK_H

#include "gcode/dialect/sinumerik/sinumerik_codes.h"
#include "gcode/dialect/sinumerik/sinumerik_state.h"
#include "gcode/dialect/sinumerik/sinumerik_way.h"

#define SINUMERIK_M_MAX 10

struct sinumerik_block {
	bool any;	/* there is something in the line, N and labels included */
	bool machine_axes;	/* X1= and the like, which G74 and G75 may have */
	uint32_t letters;	/* bits of letter_bit: the block has this word; G, M, N and R apart */
	double value[26];
	unsigned char way[26];
	int column[26];
	uint32_t addresses;	/* 1 << enum sinumerik_address */
	double address_value[SINUMERIK_ADDRESSES];
	unsigned char address_way[SINUMERIK_ADDRESSES];
	int address_column[SINUMERIK_ADDRESSES];
	int code[SINUMERIK_GROUPS];	/* in tenths, or one of words; CODE_NONE */
	int code_column[SINUMERIK_GROUPS];
	int m[SINUMERIK_M_MAX];
	int m_column[SINUMERIK_M_MAX];
	int m_count;
	bool names_tool;	/* T="NAME", in tool_name */
	struct sinumerik_text tool_name;
	bool positions;	/* POS[axis]=: the axis is among the letters */
	int positions_column;
	bool spindle_stands;	/* SPOS= */
	bool stops_reading;	/* STOPRE */
	bool modal;	/* MCALL */
	int modal_column;
	char call[SINUMERIK_NAME + 1];	/* "": none; a cycle or a subprogram: its name in upper case */
	int call_column;
	bool call_has_arguments;	/* '(' comes next in the lexer */
};

static inline bool sinumerik_block_has(const struct sinumerik_block *block, char letter)
{
	return block->letters & letter_bit(letter);
}

static inline bool sinumerik_block_has_address(const struct sinumerik_block *block, enum sinumerik_address address)
{
	return block->addresses & 1U << address;
}

/* Words that give the tool a direction: A3= B3= C3= and, by angles, A2= B2= C2=. */
#define SINUMERIK_VECTOR_BITS (1U << SINUMERIK_A3 | 1U << SINUMERIK_B3 | 1U << SINUMERIK_C3)
#define SINUMERIK_ANGLE_BITS (1U << SINUMERIK_A2 | 1U << SINUMERIK_B2 | 1U << SINUMERIK_C2)
#define SINUMERIK_DIRECTION_BITS (SINUMERIK_VECTOR_BITS | SINUMERIK_ANGLE_BITS)

/* The column of the first axis word, or 1. */
int sinumerik_block_axis_column(const struct sinumerik_block *block);

/*
 * Reads the words up to the end of the line, or up to the arguments of a call; variables get their values on the
 * way. The block was emptied by sinumerik_block_clear. False: reported.
 */
bool sinumerik_block_read(struct interp *interp, struct lexer *lexer, struct sinumerik_block *block);

void sinumerik_block_clear(struct sinumerik_block *block);

#endif
