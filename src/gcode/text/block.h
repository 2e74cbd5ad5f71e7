/* block.h - one line of the program as a checked set of words. */
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
	int words;	/* N and program numbers included */
	uint32_t letters;	/* bit letter - 'A': the block has this word; G, M, N and O apart */
	uint32_t points;	/* the same: its number has a decimal point */
	double value[26];
	int column[26];
	const struct code *recent;	/* the row of the G-code that was read last, whatever its block; or NULL */
	uint32_t plain_letters;	/* what words plain blocks of this machine can have; 0: not asked yet */
	int g[G_GROUPS];	/* the code of each group, in tenths, or CODE_NONE */
	int g_column[G_GROUPS];
	char corner;	/* 'C' or 'R' of a word behind a comma, 'L' of a chamfer by its length, or NUL */
	bool corner_point;	/* its number has a decimal point */
	double corner_value;
	int corner_column;
	bool has_next_tool;	/* "T1 T2 M6" where M6 loads the first: the second, for the next M6 */
	double next_tool;
	int next_tool_column;
	int idle, idle_column;	/* a G-code of GROUP_NONE, in tenths, or CODE_NONE */
	int m[M_GROUPS];	/* M_TCP: an enum mcode_action */
	int m_column[M_GROUPS];
	int m_count;
	bool m_ignored;	/* a machine's own M-code, to be ignored; it may have P and Q, and more where nothing moves */
	int motion;	/* the code of G_MOTION to be carried out, given or in force, or CODE_NONE */
	bool plain;	/* block_read_plain has read it */
	bool vectors;	/* I, J and K are the direction of the tool (G43.5); known once block_check has passed */
};

/* Warnings that a program gets only once. */
struct block_cautions {
	bool duplicate;
};

/* No words and no codes. */
void block_clear(struct block *block);

/* The row of a G-code, in tenths; NULL: the dialect has none. Programs repeat their codes: the last one is kept. */
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

/* The word's number; the block has it. */
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

/* How blocks of words are written. Constant data of a dialect. */
struct block_rules {
	const struct lexer_rules *lexer;
	bool program_numbers;	/* O1234 or :1234 may stand at the start of a line */
	/* several '/', a digit behind each, may stand at the start of a block, and behind its N */
	bool numbered_switches;
};

/*
 * Nearly all lines of long programs are plain blocks, which are read in one pass: nothing but N, at the beginning; G0
 * to G3; and words of axes that the machine has, of arcs, and F. Each stands once at most, as a capital letter and a
 * number without blanks between. False: the line is no plain block, or it is empty; what the block holds is of no use.
 */
bool block_read_plain(struct block *block, const struct line_place *line, const struct gcode_config *config);

/*
 * Fills the block from the words of a line that block_read_plain does not read. False: a fault was reported.
 * Skips a line that starts with '/' when config says so: no words. The context
 * is that of the lexer's hooks.
 */
bool block_read(struct block *block, const struct line_place *at, const struct gcode_config *config,
		const struct block_rules *rules, void *context, struct block_cautions *cautions);

/* The modes in force that the checks need. */
struct block_modes {
	int motion;	/* CODE_NONE: cancelled */
	int after_g80;	/* the motion that G80 brings back, or CODE_NONE */
	bool incremental;
	bool vectors;	/* G43.5 */
};

/*
 * Nearly all blocks of a program are plain ones that move. Sets the motion of such a block, which may be the one in
 * force; false: its words must be looked at one by one, by block_check. `vectors`: G43.5 is in force.
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

/* Finds the motion to be carried out and checks that every word has a code that uses it. */
bool block_check(struct block *block, const struct line_place *at, const struct gcode_config *config,
		 const struct block_modes *modes);

/* The word's number as a whole number in [least, greatest], else a fault that says what it should be. */
bool block_integer(const struct block *block, const struct line_place *at, char letter, int least, int greatest,
		   int *value);

/* The column to blame for the motion: its G word, or else the first axis or arc word. */
int block_motion_column(const struct block *block);

#endif
