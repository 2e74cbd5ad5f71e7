#include "gcode/dialect/sinumerik/block/sinumerik_way.h"

#include <string.h>

#include "gcode/dialect/sinumerik/state/sinumerik_state.h"
#include "gcode/dialect/sinumerik/values/sinumerik_expr.h"
#include "gcode/dialect/sinumerik/words/sinumerik_name.h"

static const char *const names[] = {[SINUMERIK_WAY_AC] = "AC",
				    [SINUMERIK_WAY_IC] = "IC",
				    [SINUMERIK_WAY_DC] = "DC",
				    [SINUMERIK_WAY_ACP] = "ACP",
				    [SINUMERIK_WAY_ACN] = "ACN"};

bool sinumerik_way_read(struct interp *interp, struct lexer *lexer, double *value, unsigned char *way)
{
	const size_t position = lexer->position;
	char name[SINUMERIK_NAME + 1];

	*way = SINUMERIK_WAY_MODAL;
	if (sinumerik_name_read(lexer, name) && lexer_peek(lexer) == '(') {
		for (int i = SINUMERIK_WAY_AC; i <= SINUMERIK_WAY_ACN; i++) {
			if (strcmp(name, names[i]) != 0)
				continue;
			*way = (unsigned char)i;
			lexer_take(lexer);
			return sinumerik_expr_number(interp, lexer, value) &&
			       sinumerik_name_need(lexer, ')', "the coordinate");
		}
		if (!strcmp(name, "CAC") || !strcmp(name, "CIC") || !strcmp(name, "CDC") || !strcmp(name, "CACP") ||
		    !strcmp(name, "CACN"))
			return fault(lexer->at, (int)position + 1, "positions of a table of the control (%s)", name);
	}
	lexer->position = position;
	return sinumerik_expr_number(interp, lexer, value);
}

bool sinumerik_way_fits(const struct line_place *at, int column, const char *word, unsigned char way,
			bool is_coordinate)
{
	if (way == SINUMERIK_WAY_MODAL || (is_coordinate && way <= SINUMERIK_WAY_IC))
		return true;
	return fault(at, column,
		     is_coordinate ? "%s takes AC() and IC(), not %s()" : "%s takes a plain value, not %s()", word,
		     names[way]);
}

bool sinumerik_way_fits_letter(const struct line_place *at, int column, char letter, unsigned char way)
{
	const char word[] = {letter, '\0'};

	return sinumerik_way_fits(at, column, word, way, letter >= 'I' && letter <= 'K');
}
