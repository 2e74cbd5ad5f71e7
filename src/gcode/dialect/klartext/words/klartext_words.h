/* klartext_words.h - the words of a positioning block: coordinates, radius compensation, feed, speed, M-functions. */
#ifndef FIVECHECK_GCODE_DIALECT_KLARTEXT_WORDS_KLARTEXT_WORDS_H
#define FIVECHECK_GCODE_DIALECT_KLARTEXT_WORDS_KLARTEXT_WORDS_H

#include <stdbool.h>

#include "gcode/dialect/klartext/state/klartext_state.h"
#include "gcode/text/lexer.h"

/* M-functions in one block. */
#define KLARTEXT_M_MAX 8

enum klartext_feed { KLARTEXT_FEED_NONE, KLARTEXT_FEED_VALUE, KLARTEXT_FEED_MAX, KLARTEXT_FEED_AUTO };

struct klartext_m {
	int number;
	int column;
	/* M140; in `way` M120 has its LA, M94 and M138 the bits of their axes */
	bool has_way, to_limit;
	double way; /* mm */
};

/* Values are in mm and degrees. */
struct klartext_words {
	unsigned axes, increments; /* bits 1 << slot: a word was given; it was given as I */
	double value[SLOT_COUNT];
	int column[SLOT_COUNT];
	bool has_radius, has_angle; /* PR, PA */
	bool radius_increment, angle_increment;
	double radius, angle;
	int radius_column, angle_column;
	bool has_size; /* R with a number: CR, RND, CT of APPR; or CHF's */
	double size;
	int size_column;
	int direction; /* DR+ 1, DR- -1, 0: none */
	enum klartext_comp comp;
	int comp_column;
	enum klartext_feed feed;
	double feed_value; /* mm/min, degrees/min */
	double feed_bare; /* the number itself */
	int feed_column;
	bool feed_per_revolution; /* FU */
	bool has_speed;
	double speed;
	unsigned spatial; /* bits 1 << slot: A, B or C with AXIS SPAT */
	unsigned normal_given, tool_given; /* LN: bits 0, 1, 2 for NX, NY, NZ and for TX, TY, TZ */
	double normal[3], tool[3];
	int m_count;
	unsigned handwheel; /* bits 1 << slot: a limit behind M118 */
	bool has_length, has_centre_angle; /* LEN and CCA of APPR and DEP */
	double length, centre_angle;
	int first_column; /* of the first word */
	struct klartext_m m[KLARTEXT_M_MAX]; /* only the first m_count are set */
};

/* Reads words up to the end of the block. False: reported. */
bool klartext_words_read(struct lexer *lexer, struct klartext_words *words);

static inline bool klartext_words_has(const struct klartext_words *words, int slot)
{
	return words->axes & 1U << slot;
}

/* Warns at the first FZ of a program: the number of teeth of the tool is not known here. */
void klartext_words_caution_teeth(struct lexer *lexer, int column);

/* The M-function of this number, or NULL. */
const struct klartext_m *klartext_words_m(const struct klartext_words *words, int number);

#endif
