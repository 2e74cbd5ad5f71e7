#include "gcode/dialect/sinumerik/flow/sinumerik_proc.h"

#include <math.h>
#include <string.h>

#include "base/same_double.h"
#include "gcode/dialect/sinumerik/flow/sinumerik_save.h"
#include "gcode/dialect/sinumerik/values/sinumerik_assign.h"
#include "gcode/dialect/sinumerik/values/sinumerik_expr.h"
#include "gcode/dialect/sinumerik/values/sinumerik_variables.h"
#include "gcode/dialect/sinumerik/words/sinumerik_name.h"
#include "gcode/eval/expr.h"

/* The index of the first variable of the level, or the number of all variables. */
static size_t first_of_level(const struct sinumerik *sinumerik)
{
	size_t first = sinumerik->variables.count;

	while (first > 0 && sinumerik->variables.items[first - 1].level == sinumerik->calls.level)
		first--;
	return first;
}

/* Keeps the initial values of the parameters for sinumerik_proc_check_begun. */
static void keep_begun(struct sinumerik *sinumerik, size_t count)
{
	struct sinumerik_call *call = sinumerik_top_call(sinumerik);
	const size_t first = first_of_level(sinumerik);

	if (!call)
		return;
	call->begun_count = count < SINUMERIK_ARGUMENTS_MAX ? count : SINUMERIK_ARGUMENTS_MAX;
	for (size_t i = 0; i < call->begun_count; i++) {
		const struct sinumerik_variable *parameter = &sinumerik->variables.items[first + i];

		call->begun[i] = parameter->numbers ? parameter->numbers[0] : 0;
	}
}

bool sinumerik_proc_check_begun(struct interp *interp, const struct sinumerik_call *call, int column)
{
	const struct sinumerik *sinumerik = sinumerik_of(interp);
	const size_t first = first_of_level(sinumerik);

	for (size_t i = 0; i < call->begun_count; i++) {
		const struct sinumerik_variable *parameter = &sinumerik->variables.items[first + i];

		if (parameter->numbers && !same_double(parameter->numbers[0], call->begun[i]))
			return fault(&interp->at, column,
				     "%s has changed its parameter %s, and P repeats it: what the next round begins "
				     "with is not certain; let the subprogram change a variable of its own",
				     call->title, parameter->name);
	}
	return true;
}

/* One parameter of PROC: [VAR] type name[,,] [= value]. */
static bool take_parameter(struct interp *interp, struct lexer *lexer, size_t i)
{
	struct sinumerik *sinumerik = sinumerik_of(interp);
	const bool given = i < sinumerik->passed.count;
	const bool by_reference = sinumerik_name_take(lexer, "VAR");
	struct sinumerik_variable made = {.refers_to = -1}, *variable;
	const int column = lexer_next_column(lexer);
	double value = 0;

	if (!sinumerik_assign_type(interp, lexer, &made.type, &made.length))
		return false;
	if (!sinumerik_name_read(lexer, made.name))
		return fault(lexer->at, lexer_next_column(lexer), "the name of a parameter is needed here");
	if (lexer_peek(lexer) == '[') {
		const char *close = strchr(lexer->at->text + lexer->position, ']');

		if (!by_reference || !close)
			return fault(lexer->at, column, "an array is a VAR parameter");
		lexer->position = (size_t)(close - lexer->at->text) + 1;
	}
	if (by_reference) {
		made.refers_to = given ? sinumerik->passed.variable[i] : -1;
		if (made.refers_to < 0)
			return fault(lexer->at, column, "the VAR parameter %s needs a variable of the caller",
				     made.name);
		if (sinumerik->variables.items[made.refers_to].type != made.type)
			return fault(lexer->at, column, "the VAR parameter %s and its variable differ in type",
				     made.name);
	}
	variable = sinumerik_variables_add(interp, &made, column);
	if (!variable)
		return false;
	if (sinumerik_name_take_byte(lexer, '=')) {
		if (made.type == SINUMERIK_STRING ? !sinumerik_expr_text(interp, lexer, &variable->texts[0])
						  : !sinumerik_expr_number(interp, lexer, &value))
			return false;
	}
	if (by_reference)
		return true;
	if (made.type == SINUMERIK_STRING) {
		if (given && sinumerik->passed.is_text[i])
			variable->texts[0] = sinumerik->passed.texts[i];
		return true;
	}
	if (given && sinumerik->passed.is_text[i])
		return fault(lexer->at, column, "the parameter %s is a number, and the call gives a text", made.name);
	if (given && !isnan(sinumerik->passed.numbers[i]))
		value = sinumerik->passed.numbers[i];
	return sinumerik_variables_set(interp, variable, 0, value, column);
}

bool sinumerik_proc_take(struct interp *interp, struct lexer *lexer)
{
	struct sinumerik *sinumerik = sinumerik_of(interp);
	const int column = lexer_next_column(lexer);
	char name[SINUMERIK_NAME + 1];
	size_t count = 0;

	sinumerik->calls.entering = false;
	if (!sinumerik_name_read(lexer, name))
		return fault(lexer->at, column, "PROC needs the name of its subprogram");
	if (sinumerik_name_take_byte(lexer, '(') && !sinumerik_name_take_byte(lexer, ')')) {
		do {
			if (!take_parameter(interp, lexer, count++))
				return false;
		} while (sinumerik_name_take_byte(lexer, ','));
		if (!sinumerik_name_need(lexer, ')', "the parameters"))
			return false;
	}
	if (sinumerik->passed.count > count)
		return fault(lexer->at, column, "%s has %zu parameters, and the call gives %zu", name, count,
			     sinumerik->passed.count);
	keep_begun(sinumerik, count);
	while (sinumerik_name_read(lexer, name)) {
		if (!strcmp(name, "SAVE") && sinumerik->calls.depth) {
			sinumerik_top_call(sinumerik)->saves = true;
			sinumerik_save_modes(interp, &sinumerik_top_call(sinumerik)->saved);
		}
	}
	return true;
}

bool sinumerik_proc_none(struct interp *interp)
{
	struct sinumerik *sinumerik = sinumerik_of(interp);
	const struct sinumerik_call *call = sinumerik_top_call(sinumerik);

	sinumerik->calls.entering = false;
	return !call || sinumerik->passed.count == 0 ||
	       fault(&interp->at, 1, "%s is called with arguments, but does not begin with PROC", call->title);
}
