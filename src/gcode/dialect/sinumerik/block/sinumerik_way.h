/* sinumerik_way.h - AC(), IC() and the like: what the coordinate of one word is relative to. */
#ifndef FIVECHECK_GCODE_DIALECT_SINUMERIK_BLOCK_SINUMERIK_WAY_H
#define FIVECHECK_GCODE_DIALECT_SINUMERIK_BLOCK_SINUMERIK_WAY_H

#include "gcode/state.h"

/* What a coordinate is relative to: G90 or G91 decide, or X=IC(...) and the like for this word only. */
enum sinumerik_way {
	SINUMERIK_WAY_MODAL,
	SINUMERIK_WAY_AC,
	SINUMERIK_WAY_IC,
	SINUMERIK_WAY_DC,	/* rotary axis: the shortest way */
	SINUMERIK_WAY_ACP,	/* rotary axis: in the positive direction */
	SINUMERIK_WAY_ACN
};

/* Reads a value behind '=': AC(5), IC(5) and the like, or an expression. False: reported. */
bool sinumerik_way_read(struct interp *interp, struct lexer *lexer, double *value, unsigned char *way);

/*
 * May the value of the word, which is no axis, have this form? 840D sl, "List of addresses": coordinates may be
 * absolute or incremental, other values are plain. False: reported.
 */
bool sinumerik_way_fits(const struct line_place *at, int column, const char *word, unsigned char way,
			bool is_coordinate);

/* The same for a word of one letter that is no axis; I, J and K are coordinates. */
bool sinumerik_way_fits_letter(const struct line_place *at, int column, char letter, unsigned char way);

#endif
