/* block.h - a line of the program as a checked set of words. */
#ifndef FIVECHECK_GCODE_TEXT_BLOCK_H
#define FIVECHECK_GCODE_TEXT_BLOCK_H

#include <stdbool.h>
#include <stdint.h>

#include "gcode/code.h"
#include "gcode/config.h"
#include "gcode/text/fault.h"
#include "gcode/text/lexer.h"

/* No code of a group. */
#define CODE_NONE (-1)

struct block {
	int words;	/* including N and program numbers */
	uint32_t letters;	/* bit letter - 'A': the block has this word; without G, M, N and O */
	uint32_t points;	/* the same bits: the number has a decimal point */
	double value[26];
	int column[26];
	const struct code *recent;	/* the row of the last G-code, of this or an earlier block; or NULL */
	uint32_t plain_letters;	/* the words that plain blocks of this machine can have; 0: not computed yet */
	int g[G_GROUPS];	/* the code of each group, in tenths, or CODE_NONE */
	int g_column[G_GROUPS];
	uint32_t polar;	/* bits of letters: X is the radius @, Y is the angle ^ */
	char corner;	/* 'C' or 'R' of a word after a comma, 'L' of a chamfer by its length, or NUL */
	bool corner_point;	/* its number has a decimal point */
	double corner_value;
	int corner_column;
	bool has_next_tool;	/* "T1 T2 M6", if M6 loads T1: T2 is for the next M6 */
	double next_tool;
	int next_tool_column;
	int idle, idle_column;	/* a G-code of GROUP_NONE, in tenths, or CODE_NONE */
	int m[M_GROUPS];	/* M_TCP: an enum mcode_action */
	int m_column[M_GROUPS];
	int m_count;
	bool m_ignored;	/* an ignored M-code of the machine; it takes P and Q, without a motion more words */
	int motion;	/* the code of G_MOTION to carry out, of the block or modal, or CODE_NONE */
	bool plain;	/* block_read_plain has read it */
	bool vectors;	/* I, J and K are the direction of the tool (G43.5); valid after block_check */
};

/* Warnings that are given only once for a program. */
struct block_cautions {
	bool duplicate;
};

/* Removes all words and codes. */
void block_clear(struct block *block);

/* The row of a G-code, in tenths; NULL: the dialect has none. Programs repeat codes, so the last row is kept. */
const struct code *block_find_g(struct block *block, const struct dialect *dialect, int number);

static inline uint32_t letter_bit(char letter)
{
	return (uint32_t)1 << (letter - 'A');
}

static inline uint32_t letter_bits(const char *letters)
{
	uint32_t bits = 0;

	for (; *letters; letters++)
		bits |= letter_bit(*letters);
	return bits;
}

static inline bool block_has(const struct block *block, char letter)
{
	return block->letters & letter_bit(letter);
}

/* The number of a word; the block must have the word. */
static inline double block_value(const struct block *block, char letter)
{
	return block->value[letter - 'A'];
}

static inline int block_column(const struct block *block, char letter)
{
	return block->column[letter - 'A'];
}

#define AXIS_BITS \
	(letter_bit('X') | letter_bit('Y') | letter_bit('Z') | letter_bit('A') | letter_bit('B') | letter_bit('C') | \
	 letter_bit('U') | letter_bit('V') | letter_bit('W'))

/* The words of arcs. */
#define ARC_BITS (letter_bit('I') | letter_bit('J') | letter_bit('K') | letter_bit('R'))

/* The syntax of blocks of words. Constant data of a dialect. */
struct block_rules {
	const struct lexer_rules *lexer;
	bool program_numbers;	/* a line may start with O1234 or :1234 */
	/* several '/', each with a digit after it, are allowed at the start of a block and after its N */
	bool numbered_switches;
};

/*
 * Reads a plain block in one pass; nearly all lines of long programs are plain. A plain block has only N, at its start;
 * G0 to G3; words of the machine's axes; words of arcs; and F. Each word occurs at most once, as a capital letter and a
 * number without blanks between them. False: the line is no plain block, or is empty; the contents of the block are
 * not valid.
 */
bool block_read_plain(struct block *block, const struct line_place *line, const struct gcode_config *config);

/*
 * Fills the block from the words of a line that block_read_plain does not read. The block has no words if the line
 * starts with '/' and config says that such lines are skipped. The context is for the lexer's hooks. False: a fault was
 * reported.
 */
bool block_read(struct block *block, const struct line_place *at, const struct gcode_config *config,
		const struct block_rules *rules, void *context, struct block_cautions *cautions);

/* The active modes that the checks need. */
struct block_modes {
	int motion;	/* CODE_NONE: cancelled */
	int after_g80;	/* the motion that G80 restores, or CODE_NONE */
	bool incremental;
	bool vectors;	/* G43.5 */
	int plane;	/* G17, G18, ... before the block */
};

/*
 * Sets the motion of a plain block that moves, by its own code or the modal one `in_force`; nearly all blocks of a
 * program are such blocks. `vectors`: G43.5 is active. False: block_check must examine the words one by one.
 */
static inline bool block_is_plain_move(struct block *block, int in_force, bool vectors)
{
	const bool own = block->g[G_MOTION] != CODE_NONE;
	const int motion = own ? block->g[G_MOTION] : in_force;
	const uint32_t arc = motion == G2 || motion == G3 ? 0 : ARC_BITS;

	if (!block->plain || vectors || motion < G0 || motion > G3 || (block->letters & arc) ||
	    !(own || (block->letters & AXIS_BITS)))
		return false;
	block->motion = motion;
	return true;
}

/* Finds the motion to carry out and checks that a code uses every word. */
bool block_check(struct block *block, const struct line_place *at, const struct gcode_config *config,
		 const struct block_modes *modes);

/* The number of a word as a whole number in [least, greatest]; otherwise a fault that names the permitted numbers. */
bool block_integer(const struct block *block, const struct line_place *at, char letter, int least, int greatest,
		   int *value);

/* The column for faults of the motion: that of its G word, or else of the first axis or arc word. */
int block_motion_column(const struct block *block);

#endif
