#include "gcode/dialect/sinumerik/block/sinumerik_spindle.h"

#include <stdlib.h>

#include "gcode/dialect/sinumerik/values/sinumerik_expr.h"
#include "gcode/dialect/sinumerik/words/sinumerik_name.h"

/* 840D sl: the maximum number of spindles of a channel. */
#define SPINDLES_MAX 20

/* "Spindle speed (S), master spindle (SETMS)": SETMS without a number makes the first spindle the master again. */
bool sinumerik_spindle_take_master(struct interp *interp, struct lexer *lexer)
{
	int number = 1;

	if (sinumerik_name_take_byte(lexer, '(') && !sinumerik_name_take_byte(lexer, ')') &&
	    (!sinumerik_expr_whole(interp, lexer, "the number of a spindle", 1, SPINDLES_MAX, &number) ||
	     !sinumerik_name_need(lexer, ')', "the number of a spindle")))
		return false;
	sinumerik_of(interp)->master = number - 1;
	return true;
}

bool sinumerik_spindle_check(const struct interp *interp, const char *name, int column)
{
	const int master = sinumerik_of(interp)->master + 1;

	return strtol(name + 1, NULL, 10) == master ||
	       fault(&interp->at, column,
		     "%s: only the master spindle is supported, which is the %s; SETMS(%s) before it makes this one "
		     "the master, if it turns the tool",
		     name, master == 1 ? "first one" : "one of SETMS", name + 1);
}
