/* sinumerik_way.h - AC(), IC() and the like: the reference of the coordinate of one word. */
#ifndef FIVECHECK_GCODE_DIALECT_SINUMERIK_SINUMERIK_WAY_H
#define FIVECHECK_GCODE_DIALECT_SINUMERIK_SINUMERIK_WAY_H

#include "gcode/state.h"

/* The reference of a coordinate: according to G90 and G91, or X=IC(...) and the like for this word only. */
enum sinumerik_way {
	SINUMERIK_WAY_MODAL,
	SINUMERIK_WAY_AC,
	SINUMERIK_WAY_IC,
	SINUMERIK_WAY_DC,	/* rotary: the shortest way */
	SINUMERIK_WAY_ACP,	/* rotary: in the positive direction */
	SINUMERIK_WAY_ACN
};

/* Reads a value behind '=': AC(5), IC(5) and the like, or an expression. False: reported. */
bool sinumerik_way_read(struct interp *interp, struct lexer *lexer, double *value, unsigned char *way);

/*
 * Can the word, which is no axis, have the value counted in this way? 840D sl, "List of addresses": coordinates may be
 * absolute or incremental, other values are plain. False: reported.
 */
bool sinumerik_way_fits(const struct line_place *at, int column, const char *word, unsigned char way,
			bool is_coordinate);

/* The same of a word of one letter that is no axis; I, J and K are coordinates. */
bool sinumerik_way_fits_letter(const struct line_place *at, int column, char letter, unsigned char way);

#endif
