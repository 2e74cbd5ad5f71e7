#include "gcode/dialect/sinumerik/block/sinumerik_traori.h"

#include <math.h>

#include "gcode/dialect/sinumerik/values/sinumerik_expr.h"
#include "gcode/dialect/sinumerik/words/sinumerik_name.h"
#include "gcode/eval/expr.h"

bool sinumerik_traori_read(struct interp *interp, struct lexer *lexer)
{
	const int column = lexer_next_column(lexer);
	double arguments[4] = {1, 0, 0, 1};
	size_t count = 0;

	if (!sinumerik_name_take_byte(lexer, '(') || sinumerik_name_take_byte(lexer, ')'))
		return true;
	do {
		const char byte = lexer_peek(lexer);

		if (count == sizeof(arguments) / sizeof(arguments[0]))
			return fault(lexer->at, column, "TRAORI with so many arguments is not supported");
		if (byte != ',' && byte != ')' && !sinumerik_expr_number(interp, lexer, &arguments[count]))
			return false;
		count++;
	} while (sinumerik_name_take_byte(lexer, ','));
	if (!sinumerik_name_need(lexer, ')', "TRAORI"))
		return false;
	if (fabs(arguments[0] - 1) > 0)
		return fault(lexer->at, column,
			     "TRAORI(%.15g): the axes of any transformation but the first are not known; only "
			     "TRAORI(1) is supported",
			     arguments[0]);
	return (!(fabs(arguments[1]) + fabs(arguments[2]) > 0) && arguments[3] > 0) ||
	       fault(lexer->at, column, "TRAORI whose tool does not lie along Z at first is not supported");
}
