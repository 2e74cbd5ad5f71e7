#include "gcode/dialect/sinumerik/values/sinumerik_assign.h"

#include <math.h>
#include <string.h>

#include "gcode/dialect/sinumerik/builder/sinumerik_gud.h"
#include "gcode/dialect/sinumerik/values/sinumerik_expr.h"
#include "gcode/dialect/sinumerik/values/sinumerik_system_write.h"
#include "gcode/dialect/sinumerik/values/sinumerik_variables.h"
#include "gcode/dialect/sinumerik/words/sinumerik_codes.h"
#include "gcode/dialect/sinumerik/words/sinumerik_name.h"
#include "gcode/eval/expr.h"

static bool is_r(const char *name)
{
	return name[0] == 'R' && name[1 + strspn(name + 1, "0123456789")] == '\0';
}

bool sinumerik_assign_is_own(const struct interp *interp, const char *name)
{
	return (is_r(name) && name[1]) || sinumerik_variables_find(sinumerik_of(interp), name) >= 0;
}

/* -------------------------------------------------------------- one value */

static bool set_text(struct interp *interp, struct lexer *lexer, struct sinumerik_variable *variable, size_t element)
{
	const int column = lexer_next_column(lexer);
	struct sinumerik_text text;

	/* The text may contain the variable itself, so it is copied first. */
	if (!sinumerik_expr_text(interp, lexer, &text))
		return false;
	if (variable->length > 0 && strlen(text.bytes) > (size_t)variable->length)
		return fault(lexer->at, column, "a text of %d bytes in %s, which has room for %d",
			     (int)strlen(text.bytes), variable->name, variable->length);
	variable->texts[element] = text;
	sinumerik_variables_mark(variable, element);
	return true;
}

static bool set_axis(struct interp *interp, struct lexer *lexer, struct sinumerik_variable *variable, size_t element)
{
	int slot;

	if (!sinumerik_expr_axis(interp, lexer, &slot))
		return false;
	variable->numbers[element] = slot;
	sinumerik_variables_mark(variable, element);
	return true;
}

static bool set_one(struct interp *interp, struct lexer *lexer, struct sinumerik_variable *variable, size_t element)
{
	const int column = lexer_next_column(lexer);
	double value;

	if (variable->type == SINUMERIK_STRING)
		return set_text(interp, lexer, variable, element);
	if (variable->type == SINUMERIK_AXIS)
		return set_axis(interp, lexer, variable, element);
	return sinumerik_expr_number(interp, lexer, &value) &&
	       sinumerik_variables_set(interp, variable, element, value, column);
}

/* SET(1,,3): an element without a value keeps its value. */
static bool set_list(struct interp *interp, struct lexer *lexer, struct sinumerik_variable *variable, size_t element)
{
	while (lexer_peek(lexer) != ')') {
		const int column = lexer_next_column(lexer);

		if (lexer_peek(lexer) != ',') {
			if (element >= variable->count)
				return fault(lexer->at, column, "%s has no room for so many values", variable->name);
			if (!set_one(interp, lexer, variable, element))
				return false;
		}
		element++;
		if (!sinumerik_name_take_byte(lexer, ',') && lexer_peek(lexer) != ')')
			return fault(lexer->at, lexer_next_column(lexer), "',' or ')' is needed behind a value of SET");
	}
	lexer_take(lexer);
	return true;
}

/* REP(1,24): the value 1 for 24 elements; without the second number, up to the end of the array. */
static bool repeat_value(struct interp *interp, struct lexer *lexer, struct sinumerik_variable *variable,
			 size_t element)
{
	const int most = (int)(variable->count - element);
	int count = most;

	if (!set_one(interp, lexer, variable, element))
		return false;
	if (sinumerik_name_take_byte(lexer, ',') &&
	    !sinumerik_expr_whole(interp, lexer, "the number of values of REP", 1, most, &count))
		return false;
	for (size_t i = element + 1; i < element + (size_t)count; i++) {
		if (variable->texts)
			variable->texts[i] = variable->texts[element];
		else
			variable->numbers[i] = variable->numbers[element];
		sinumerik_variables_mark(variable, i);
	}
	return sinumerik_name_need(lexer, ')', "the values of REP");
}

static bool set_values(struct interp *interp, struct lexer *lexer, struct sinumerik_variable *variable, size_t element)
{
	const size_t position = lexer->position;

	if (variable->dimensions > 0 && sinumerik_name_take(lexer, "SET") && sinumerik_name_take_byte(lexer, '('))
		return set_list(interp, lexer, variable, element);
	lexer->position = position;
	if (variable->dimensions > 0 && sinumerik_name_take(lexer, "REP") && sinumerik_name_take_byte(lexer, '('))
		return repeat_value(interp, lexer, variable, element);
	lexer->position = position;
	return set_one(interp, lexer, variable, element);
}

/* -------------------------------------------------------------- statements */

static bool set_r(struct interp *interp, struct lexer *lexer, const char *name)
{
	int number = 0;
	double *r;

	if (!sinumerik_expr_r_number(interp, lexer, name, &number) ||
	    !sinumerik_name_need(lexer, '=', "an R parameter"))
		return false;
	r = &sinumerik_of(interp)->variables.r[number];
	if (sinumerik_expr_number(interp, lexer, r))
		return true;
	/* The error is reported here only, and not again where the parameter is read. */
	if (isnan(*r))
		*r = 0;
	return false;
}

bool sinumerik_assign(struct interp *interp, struct lexer *lexer, const char *name, int column)
{
	struct sinumerik *sinumerik = sinumerik_of(interp);
	struct sinumerik_variable *variable;
	size_t element;
	int found;

	if (is_r(name))
		return set_r(interp, lexer, name);
	if (name[0] == '$')
		return sinumerik_system_write(interp, lexer, name, column);
	found = sinumerik_variables_find(sinumerik, name);
	if (found < 0)
		return sinumerik_gud_ask(lexer, name, false, column);
	variable = &sinumerik->variables.items[found];
	return sinumerik_expr_element(interp, lexer, variable, &element) &&
	       sinumerik_name_need(lexer, '=', name) && set_values(interp, lexer, variable, element);
}

bool sinumerik_assign_type(struct interp *interp, struct lexer *lexer, enum sinumerik_type *type, int *length)
{
	static const struct {
		const char *name;
		enum sinumerik_type type;
	} types[] = {{"INT", SINUMERIK_INT},   {"REAL", SINUMERIK_REAL},     {"BOOL", SINUMERIK_BOOL},
		     {"CHAR", SINUMERIK_CHAR}, {"STRING", SINUMERIK_STRING}, {"AXIS", SINUMERIK_AXIS}};
	const int column = lexer_next_column(lexer);
	char name[SINUMERIK_NAME + 1] = "";

	*length = 0;
	sinumerik_name_read(lexer, name);
	for (size_t i = 0; i < sizeof(types) / sizeof(types[0]); i++) {
		if (strcmp(types[i].name, name) != 0)
			continue;
		*type = types[i].type;
		if (*type != SINUMERIK_STRING || lexer_peek(lexer) != '[')
			return true;
		lexer_take(lexer);
		return sinumerik_expr_whole(interp, lexer, "the length of a text", 1, SINUMERIK_TEXT, length) &&
		       sinumerik_name_need(lexer, ']', "the length of a text");
	}
	return fault(lexer->at, column, "a type is needed here: INT, REAL, BOOL, CHAR, STRING or AXIS");
}

static bool read_sizes(struct interp *interp, struct lexer *lexer, struct sinumerik_variable *made)
{
	if (!sinumerik_name_take_byte(lexer, '['))
		return true;
	do {
		if (made->dimensions == SINUMERIK_DIMENSIONS)
			return fault(lexer->at, lexer_next_column(lexer), "an array has at most %d dimensions",
				     SINUMERIK_DIMENSIONS);
		if (!sinumerik_expr_whole(interp, lexer, "the size of an array", 1, 32767,
					  &made->size[made->dimensions]))
			return false;
		made->dimensions++;
	} while (sinumerik_name_take_byte(lexer, ','));
	return sinumerik_name_need(lexer, ']', "the size of an array");
}

/* One variable of DEF: its name, sizes and initial values. A second DEF in the same program gives it new values. */
static bool define_one(struct interp *interp, struct lexer *lexer, enum sinumerik_type type, int length)
{
	struct sinumerik *sinumerik = sinumerik_of(interp);
	struct sinumerik_variable made = {.type = type, .length = length, .refers_to = -1}, *variable;
	const int column = lexer_next_column(lexer);
	struct sinumerik_word word;
	int found;

	if (!sinumerik_name_read(lexer, made.name) || made.name[0] == '$')
		return fault(lexer->at, column, "the name of a variable is needed here, of at most %d bytes",
			     SINUMERIK_NAME);
	/* DEF of an R parameter only gives it a value. */
	if (is_r(made.name) && made.name[1] && lexer_peek(lexer) == '=')
		return set_r(interp, lexer, made.name);
	if (made.name[1] == '\0' || sinumerik_codes_word(made.name, &word))
		if (slot_of_letter(made.name[0]) >= 0 || made.name[1] || strchr("DFGHIJKLMNPRST", made.name[0]))
			return fault(lexer->at, column, "%s means something else and can be no variable", made.name);
	if (!read_sizes(interp, lexer, &made))
		return false;
	found = sinumerik_variables_find_own(sinumerik, made.name);
	if (found >= 0 && (sinumerik->variables.items[found].type != type ||
			   sinumerik->variables.items[found].dimensions != made.dimensions))
		return fault(lexer->at, column, "%s has been made before, as something else", made.name);
	variable = found >= 0 ? &sinumerik->variables.items[found] : sinumerik_variables_add(interp, &made, column);
	if (!variable)
		return false;
	if (lexer_peek(lexer) != '=')
		return true;
	lexer_take(lexer);
	/* In DEF, the word SET may be omitted before the list. */
	if (variable->dimensions > 0 && sinumerik_name_take_byte(lexer, '('))
		return set_list(interp, lexer, variable, 0);
	return set_values(interp, lexer, variable, 0);
}

bool sinumerik_assign_define(struct interp *interp, struct lexer *lexer)
{
	enum sinumerik_type type;
	int length;

	if (!sinumerik_assign_type(interp, lexer, &type, &length))
		return false;
	do {
		if (!define_one(interp, lexer, type, length))
			return false;
	} while (sinumerik_name_take_byte(lexer, ','));
	if (lexer_peek(lexer) != '\0' && lexer_peek(lexer) != ';')
		return fault(lexer->at, lexer_next_column(lexer), "',' or the end of the block is needed here");
	return true;
}
