#include "gcode/dialect/sinumerik/block/sinumerik_coupling.h"

#include "gcode/dialect/sinumerik/builder/sinumerik_builder.h"
#include "gcode/dialect/sinumerik/words/sinumerik_name.h"

/*
 * 840D sl, job planning, "Coupled motion (TRAILON, TRAILOF)": TRAILON(<following axis>, <leading axis>, <factor>). The
 * following axis moves as far as the leading one, times the factor. Where it is a second motor of a table, or a
 * tailstock that turns with it, the machine file has its bodies on the leading axis and no axis of this name.
 */
bool sinumerik_coupling_read(struct interp *interp, struct lexer *lexer, int column)
{
	char name[SINUMERIK_NAME + 1];
	int slot;

	if (!sinumerik_name_need(lexer, '(', "TRAILON"))
		return false;
	if (sinumerik_name_read(lexer, name) == 0)
		return fault(&interp->at, column, "TRAILON needs the names of its axes");
	slot = name[1] == '\0' ? slot_of_letter(name[0]) : -1;
	if (slot >= 0 && interp->config->has_axis[slot])
		return fault(&interp->at, column,
			     "TRAILON makes %s follow another axis, which is not supported for an axis of the machine "
			     "file",
			     name);
	if (!sinumerik_builder_does_nothing(interp, "TRAILON"))
		return fault(&interp->at, column,
			     "TRAILON makes %s follow another axis, and the machine file has no axis %s: if it moves "
			     "nothing but what is on the leading axis there, set <macro program=\"TRAILON\" "
			     "action=\"none\"/> in the machine file's <controller>",
			     name, name);
	/* The leading axis and the factor. */
	while (lexer_peek(lexer) != ')' && lexer_peek(lexer) != '\0')
		lexer_take(lexer);
	return sinumerik_name_need(lexer, ')', "TRAILON");
}
