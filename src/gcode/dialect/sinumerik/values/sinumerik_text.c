#include "gcode/dialect/sinumerik/values/sinumerik_text.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

#include "base/ascii.h"
#include "gcode/dialect/sinumerik/values/sinumerik_variables.h"
#include "gcode/dialect/sinumerik/words/sinumerik_name.h"
#include "gcode/text/number.h"

/* 840D sl, job planning, "String operations". Positions count from 0; -1 means not found. */
static const char *const makers[] = {"TOUPPER", "TOLOWER", "SUBSTR"};
static const char *const measures[] = {"STRLEN", "INDEX", "RINDEX", "MINDEX", "NUMBER", "ISNUMBER"};

static bool is_one_of(const char *const *names, size_t count, const char *name)
{
	for (size_t i = 0; i < count; i++) {
		if (!strcmp(names[i], name))
			return true;
	}
	return false;
}

static bool makes_text(const char *name)
{
	return is_one_of(makers, sizeof(makers) / sizeof(makers[0]), name);
}

bool sinumerik_text_measures(const char *name)
{
	return is_one_of(measures, sizeof(measures) / sizeof(measures[0]), name);
}

static bool quoted(struct lexer *lexer, struct sinumerik_text *text)
{
	const char *start, *end;
	const int column = lexer_next_column(lexer);

	lexer_take(lexer);
	start = lexer->at->text + lexer->position;
	end = strchr(start, '"');
	if (!end)
		return fault(lexer->at, column, "this text is not closed: '\"' is missing");
	if (end - start > SINUMERIK_TEXT)
		return fault(lexer->at, column, "a text of more than %d bytes", SINUMERIK_TEXT);
	memcpy(text->bytes, start, (size_t)(end - start));
	text->bytes[end - start] = '\0';
	lexer->position += (size_t)(end - start) + 1;
	return true;
}

/*
 * Looks at the next name: returns a text variable; or NULL, and *function tells whether it is a function of text.
 * Nothing is consumed.
 */
static const struct sinumerik_variable *look(struct interp *interp, struct lexer *lexer, bool *function)
{
	const struct sinumerik *sinumerik = sinumerik_of(interp);
	const size_t position = lexer->position;
	char name[SINUMERIK_NAME + 1];
	int found = -1;

	*function = false;
	if (sinumerik_name_read(lexer, name)) {
		found = sinumerik_variables_find(sinumerik, name);
		*function = found < 0 && makes_text(name) && lexer_peek(lexer) == '(';
	}
	lexer->position = position;
	return found >= 0 && sinumerik->variables.items[found].texts ? &sinumerik->variables.items[found] : NULL;
}

static bool concatenates(struct lexer *lexer)
{
	return lexer_peek(lexer) == '<' && lexer->at->text[lexer->position + 1] == '<';
}

bool sinumerik_text_follows(struct interp *interp, struct lexer *lexer)
{
	bool function;

	return lexer_peek(lexer) == '"' || concatenates(lexer) || look(interp, lexer, &function) != NULL || function;
}

static bool whole(struct expr *expr, const char *what, int most, int *number)
{
	const int column = lexer_next_column(expr->lexer);
	struct expr_operand value;

	if (!expr_sum(expr, &value))
		return false;
	if (!(value.number >= 0 && value.number <= most) || floor(value.number) < value.number)
		return fault(expr->lexer->at, column, "%s must be a whole number from 0 to %d, not %.15g", what, most,
			     value.number);
	*number = (int)value.number;
	return true;
}

static bool read_variable(struct expr *expr, const struct sinumerik_variable *variable, struct sinumerik_text *text)
{
	const int column = lexer_next_column(expr->lexer);
	char name[SINUMERIK_NAME + 1];
	size_t element = 0;
	int index = 0;

	sinumerik_name_read(expr->lexer, name);
	for (int i = 0; i < variable->dimensions; i++) {
		if (!sinumerik_name_need(expr->lexer, i > 0 ? ',' : '[', i > 0 ? "an index" : variable->name) ||
		    !whole(expr, "an index", variable->size[i] - 1, &index))
			return false;
		element = element * (size_t)variable->size[i] + (size_t)index;
	}
	if (variable->dimensions > 0 && !sinumerik_name_need(expr->lexer, ']', "the indices"))
		return false;
	if (lexer_peek(expr->lexer) == '[')
		return fault(expr->lexer->at, lexer_next_column(expr->lexer),
			     "single bytes of a text are not supported");
	*text = variable->texts[element];
	return sinumerik_variables_check(expr->lexer->at, variable, element, column);
}

/* SUBSTR(text, first) and SUBSTR(text, first, length): positions after the end are omitted. */
static bool cut(struct expr *expr, struct sinumerik_text *text)
{
	int first, length = SINUMERIK_TEXT;
	size_t all = strlen(text->bytes), from;

	if (!sinumerik_name_need(expr->lexer, ',', "the text of SUBSTR") ||
	    !whole(expr, "the first byte of SUBSTR", SINUMERIK_TEXT, &first))
		return false;
	if (sinumerik_name_take_byte(expr->lexer, ',') &&
	    !whole(expr, "the length of SUBSTR", SINUMERIK_TEXT, &length))
		return false;
	from = (size_t)first < all ? (size_t)first : all;
	all = all - from < (size_t)length ? all - from : (size_t)length;
	memmove(text->bytes, text->bytes + from, all);
	text->bytes[all] = '\0';
	return true;
}

static bool make(struct expr *expr, struct sinumerik_text *text)
{
	char name[SINUMERIK_NAME + 1];

	sinumerik_name_read(expr->lexer, name);
	if (!expr_enter(expr) || !expr_open(expr, name) || !sinumerik_text_read(expr, text))
		return false;
	expr->depth--;
	if (!strcmp(name, "SUBSTR"))
		return cut(expr, text) && expr_close(expr);
	for (char *byte = text->bytes; *byte; byte++)
		*byte = !strcmp(name, "TOUPPER") ? ascii_upper(*byte) : ascii_lower(*byte);
	return expr_close(expr);
}

/* Operators of arithmetic come before <<: their least rank in the tables of sinumerik_expr.c. */
#define ARITHMETIC_RANK 5

/* One piece of a text. A number becomes its shortest decimal, as the control shows it. */
static bool piece(struct expr *expr, struct sinumerik_text *text)
{
	bool function;
	const struct sinumerik_variable *variable = look(expr->context, expr->lexer, &function);
	struct expr_operand value;

	if (lexer_peek(expr->lexer) == '"')
		return quoted(expr->lexer, text);
	if (variable)
		return read_variable(expr, variable, text);
	if (function)
		return make(expr, text);
	if (!expr_part(expr, ARITHMETIC_RANK, &value))
		return false;
	snprintf(text->bytes, sizeof(text->bytes), "%.12g", value.number);
	return true;
}

bool sinumerik_text_read(struct expr *expr, struct sinumerik_text *text)
{
	const int column = lexer_next_column(expr->lexer);
	struct sinumerik_text next;

	text->bytes[0] = '\0';
	if (!concatenates(expr->lexer) && !piece(expr, text))
		return false;
	while (concatenates(expr->lexer)) {
		expr->lexer->position += 2;
		if (!piece(expr, &next))
			return false;
		if (strlen(text->bytes) + strlen(next.bytes) > SINUMERIK_TEXT)
			return fault(expr->lexer->at, column, "a text of more than %d bytes", SINUMERIK_TEXT);
		strcat(text->bytes, next.bytes);
	}
	return true;
}

/* Text is compared whole, byte by byte; case counts. */
bool sinumerik_text_compare(struct expr *expr, struct expr_operand *value)
{
	static const struct {
		const char *name;
		bool less, equal, greater;
	} comparisons[] = {{"==", false, true, false}, {"<>", true, false, true}, {"<=", true, true, false},
			   {">=", false, true, true},  {"<", true, false, false}, {">", false, false, true}};
	struct sinumerik_text left, right;
	int column, order;

	if (!sinumerik_text_read(expr, &left))
		return false;
	column = lexer_next_column(expr->lexer);
	for (size_t i = 0; i < sizeof(comparisons) / sizeof(comparisons[0]); i++) {
		if (!lexer_keyword(expr->lexer, comparisons[i].name))
			continue;
		if (!sinumerik_text_read(expr, &right))
			return false;
		order = strcmp(left.bytes, right.bytes);
		value->truth = true;
		value->number = order < 0   ? comparisons[i].less
				: order > 0 ? comparisons[i].greater
					    : comparisons[i].equal;
		return true;
	}
	return fault(expr->lexer->at, column, "text stands here for a number; compare it with ==, <> or the like");
}

/* ---------------------------------------------------------------- measures */

static bool number_of(const char *text, double *value)
{
	size_t position = 0;
	bool point;

	return number_read(text, &position, value, &point) == NUMBER_OK &&
	       text[position + strspn(text + position, " ")] == '\0';
}

/* The position of `what` in the text: INDEX finds the first such byte, RINDEX the last, MINDEX the first of several. */
static double find(const char *name, const char *text, const char *what)
{
	const char *place = !strcmp(name, "RINDEX")   ? strrchr(text, what[0])
			    : !strcmp(name, "MINDEX") ? strpbrk(text, what)
						      : strchr(text, what[0]);

	return place ? (double)(place - text) : -1;
}

static bool search(struct expr *expr, const char *name, const char *text, double *value)
{
	struct sinumerik_text what;
	int column;

	if (!sinumerik_name_need(expr->lexer, ',', name))
		return false;
	column = lexer_next_column(expr->lexer);
	if (!sinumerik_text_read(expr, &what))
		return false;
	if (what.bytes[0] == '\0' || (what.bytes[1] && strcmp(name, "MINDEX") != 0))
		return fault(expr->lexer->at, column, "%s looks for one byte", name);
	*value = find(name, text, what.bytes);
	return true;
}

bool sinumerik_text_measure(struct expr *expr, const char *name, double *value)
{
	const int column = lexer_next_column(expr->lexer);
	struct sinumerik_text text;

	if (!expr_enter(expr) || !expr_open(expr, name) || !sinumerik_text_read(expr, &text))
		return false;
	expr->depth--;
	if (!strcmp(name, "STRLEN")) {
		*value = (double)strlen(text.bytes);
	} else if (!strcmp(name, "NUMBER") || !strcmp(name, "ISNUMBER")) {
		/* It is not certain which other texts are numbers to the control (1EX3, 'HFF'). */
		const bool number = number_of(text.bytes, value);

		if (!number && (name[0] == 'N' || strpbrk(text.bytes, "0123456789")))
			return fault(expr->lexer->at, column, "%s of a text that is no plain number: \"%s\"", name,
				     text.bytes);
		if (name[0] == 'I')
			*value = number;
	} else if (!search(expr, name, text.bytes, value)) {
		return false;
	}
	return expr_close(expr);
}
