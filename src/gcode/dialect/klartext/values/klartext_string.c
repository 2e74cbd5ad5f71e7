#include "gcode/dialect/klartext/values/klartext_string.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

#include "base/ascii.h"
#include "base/decimal.h"
#include "gcode/dialect/klartext/text/klartext_lexis.h"
#include "gcode/dialect/klartext/values/klartext_value.h"

bool klartext_string_follows(struct lexer *lexer)
{
	const char *text;

	lexer_peek(lexer);
	text = lexer->at->text + lexer->position;
	return ascii_upper(text[0]) == 'Q' && ascii_upper(text[1]) == 'S' && ascii_is_digit(text[2]);
}

static struct klartext_string *find(struct klartext *klartext, int number)
{
	for (int i = 0; i < klartext->strings.count; i++) {
		if (klartext->strings.items[i].number == number)
			return &klartext->strings.items[i];
	}
	return NULL;
}

/* Reads the number of "QS5". */
static bool read_number(struct lexer *lexer, int *number)
{
	if (!klartext_string_follows(lexer))
		return fault(lexer->at, lexer_next_column(lexer),
			     "a string parameter, QS and its number, is needed here");
	lexer->position += 2;
	return klartext_integer(lexer, "the number of QS", 0, KLARTEXT_Q_COUNT - 1, number);
}

static bool read_value(struct lexer *lexer, char text[KLARTEXT_NAME])
{
	const int column = lexer_next_column(lexer);
	const struct klartext_string *string;
	int number;

	if (!read_number(lexer, &number))
		return false;
	string = find(klartext_of(lexer->context), number);
	if (string ? string->unknown : klartext_of(lexer->context)->strings.forgotten)
		return fault(lexer->at, column, "QS%d has no value that is known here", number);
	if (!string)
		return fault(lexer->at, column,
			     "QS%d has no value that is known here; if the control holds one from before, set "
			     "<variable name=\"QS%d\" value=\"\"/> in the machine file's <controller>",
			     number, number);
	memcpy(text, string->text, sizeof(string->text));
	return true;
}

bool klartext_string_name(struct lexer *lexer, const char *what, char name[KLARTEXT_NAME])
{
	return klartext_string_follows(lexer) ? read_value(lexer, name)
					      : klartext_name(lexer, what, name, KLARTEXT_NAME);
}

/* ----------------------------------------------------------------- functions */

/* TNC 640 user's manual, "String parameters"; the first character of a string is that of place 0. */

/* "SRC_QS5", "SEA_QS6": the text of the parameter. */
static bool read_part(struct lexer *lexer, const char *function, const char *key, char text[KLARTEXT_NAME])
{
	lexer_peek(lexer);
	if (strncmp(lexer->at->text + lexer->position, key, strlen(key)) != 0)
		return fault(lexer->at, lexer_next_column(lexer), "%s needs %sQS and a number here", function, key);
	lexer->position += strlen(key);
	return read_value(lexer, text);
}

static bool open_function(struct lexer *lexer, const char *function, const char *first)
{
	if (lexer_peek(lexer) != '(')
		return fault(lexer->at, lexer_next_column(lexer), "%s needs ( %s and a number )", function, first);
	lexer_take(lexer);
	return true;
}

static bool close_function(struct lexer *lexer)
{
	if (lexer_peek(lexer) != ')')
		return fault(lexer->at, lexer_next_column(lexer), "')' is needed here");
	lexer_take(lexer);
	return true;
}

static bool read_source(struct lexer *lexer, const char *function, char text[KLARTEXT_NAME])
{
	return open_function(lexer, function, "SRC_QS") && read_part(lexer, function, "SRC_", text);
}

/* The same for a function that counts places. Controls encode letters that are not of ASCII differently. */
static bool read_places(struct lexer *lexer, const char *function, char text[KLARTEXT_NAME])
{
	const int column = lexer_next_column(lexer);

	if (!read_source(lexer, function, text))
		return false;
	for (const char *at = text; *at; at++)
		if ((unsigned char)*at > 127)
			return fault(lexer->at, column,
				     "%s: the places in \"%s\" are only known if all letters are of ASCII", function,
				     text);
	return true;
}

/* "BEG2": a place or a number of characters, at most `most`. */
static bool read_count(struct lexer *lexer, const char *function, const char *key, size_t most, int *count)
{
	if (!klartext_take(lexer, key))
		return fault(lexer->at, lexer_next_column(lexer), "%s needs %s here", function, key);
	return klartext_integer(lexer, "a place inside of the string", 0, (int)most, count);
}

static bool read_substring(struct lexer *lexer, char text[KLARTEXT_NAME])
{
	char source[KLARTEXT_NAME];
	int begin, length;

	if (!read_places(lexer, "SUBSTR", source) ||
	    !read_count(lexer, "SUBSTR", "BEG", strlen(source), &begin) ||
	    !read_count(lexer, "SUBSTR", "LEN", strlen(source) - (size_t)begin, &length) || !close_function(lexer))
		return false;
	memcpy(text, source + begin, (size_t)length);
	text[length] = '\0';
	return true;
}

/* The manual does not say how TOCHAR rounds: a number with more decimals is refused. */
static bool read_written(struct lexer *lexer, char text[KLARTEXT_NAME])
{
	const int column = lexer_next_column(lexer);
	double number, units = 1;
	int decimals;

	if (!open_function(lexer, "TOCHAR", "DAT") || !klartext_take(lexer, "DAT"))
		return fault(lexer->at, column, "TOCHAR needs ( DAT with a value, DECIMALS with a number )");
	if (!klartext_value(lexer, &number) || !read_count(lexer, "TOCHAR", "DECIMALS", 9, &decimals) ||
	    !close_function(lexer))
		return false;
	for (int i = 0; i < decimals; i++)
		units *= 10;
	units *= number;
	if (!(fabs(units) < 1e15) || fabs(units - round(units)) > 1e-6)
		return fault(lexer->at, column, "TOCHAR: %.15g is too large, or has more decimals than %d", number,
			     decimals);
	/* No "-0.00". */
	snprintf(text, KLARTEXT_NAME, "%.*f", decimals, fabs(units) < 0.5 ? 0.0 : number);
	return true;
}

/* Between texts that differ in more than capital letters only digits, or letters of one case, have a known order. */
static bool compare(struct lexer *lexer, const char *a, const char *b, int column, double *order)
{
	while (*a && *a == *b) {
		a++;
		b++;
	}
	if (*a && *b && !(ascii_is_digit(*a) && ascii_is_digit(*b)) &&
	    !(ascii_is_letter(*a) && ascii_is_letter(*b) && (ascii_upper(*a) == *a) == (ascii_upper(*b) == *b)))
		return fault(lexer->at, column, "STRCOMP: which of the two texts comes first is not known here");
	*order = *a == *b ? 0 : (unsigned char)*a < (unsigned char)*b ? -1 : 1;
	return true;
}

bool klartext_string_compute(struct lexer *lexer, double *value, bool *is_function)
{
	static const char *const names[] = {"TONUMB", "STRLEN", "INSTR", "STRCOMP"};
	const int before = lexer_next_column(lexer);
	char text[KLARTEXT_NAME], other[KLARTEXT_NAME];
	size_t which = 0;
	const char *found;
	int column, begin;

	while (which < 4 && !klartext_take(lexer, names[which]))
		which++;
	*is_function = which < 4;
	if (!*is_function)
		return true;
	column = lexer_next_column(lexer);
	if (!(which == 1 || which == 2 ? read_places : read_source)(lexer, names[which], text))
		return false;
	if (which == 0)
		return close_function(lexer) && (decimal_read(text, strlen(text), value) ||
						 fault(lexer->at, column, "\"%s\" is no number", text));
	*value = (double)strlen(text);
	if (which == 1)
		return close_function(lexer);
	if (!read_part(lexer, names[which], "SEA_", other))
		return false;
	if (which == 3)
		return close_function(lexer) && compare(lexer, text, other, before, value);
	if (!read_count(lexer, "INSTR", "BEG", strlen(text), &begin))
		return false;
	/* What is not found is behind the last place: the length. */
	found = strstr(text + begin, other);
	*value = found ? (double)(found - text) : *value;
	return close_function(lexer);
}

/* SYSSTR and CFGREAD read what only the control has. */
static bool skip_unknown(struct lexer *lexer, bool *unknown)
{
	const char *text = lexer->at->text + lexer->position;
	const size_t length = strcspn(text, ");");

	*unknown = true;
	lexer->position += length;
	return close_function(lexer);
}

/* Reads a text in quotation marks, which may be empty, a string parameter, or a function. */
static bool read_term(struct lexer *lexer, char text[KLARTEXT_NAME], bool *unknown)
{
	const int column = lexer_next_column(lexer);
	const char *rest = lexer->at->text + lexer->position;

	text[0] = '\0';
	if (klartext_take(lexer, "SUBSTR"))
		return read_substring(lexer, text);
	if (klartext_take(lexer, "TOCHAR"))
		return read_written(lexer, text);
	if (klartext_take(lexer, "SYSSTR") || klartext_take(lexer, "CFGREAD"))
		return skip_unknown(lexer, unknown);
	if (rest[0] == '"' && rest[1] == '"') {
		lexer->position += 2;
		text[0] = '\0';
		return true;
	}
	return rest[0] == '"' ? klartext_name(lexer, "a text", text, KLARTEXT_NAME)
	       : klartext_string_follows(lexer)
		   ? read_value(lexer, text)
		   : fault(lexer->at, column,
			   "a string is a text in quotation marks, QS, SUBSTR, TOCHAR, SYSSTR, or several of them "
			   "joined by ||");
}

bool klartext_string_set(struct lexer *lexer, int column, int number, const char *text)
{
	struct klartext *klartext = klartext_of(lexer->context);
	struct klartext_string *string = find(klartext, number);

	if (text && strlen(text) >= sizeof(string->text))
		return fault(lexer->at, column, "a string of more than %zu characters is not supported",
			     sizeof(string->text) - 1);
	if (!string && klartext->strings.count == KLARTEXT_STRINGS_MAX)
		return fault(lexer->at, column, "more than %d string parameters", KLARTEXT_STRINGS_MAX);
	if (!string)
		string = &klartext->strings.items[klartext->strings.count++];
	string->number = number;
	string->unknown = !text;
	strcpy(string->text, text ? text : "");
	return true;
}

bool klartext_string_assign(struct lexer *lexer)
{
	const int column = lexer_next_column(lexer);
	char whole[KLARTEXT_NAME] = "", term[KLARTEXT_NAME];
	bool unknown = false;
	int number;

	if (!read_number(lexer, &number))
		return false;
	if (lexer_peek(lexer) != '=')
		return fault(lexer->at, lexer_column(lexer), "'=' is needed here");
	do {
		/* Takes the '=' or the first bar of "||". */
		lexer_take(lexer);
		if (lexer->at->text[lexer->position] == '|')
			lexer_take(lexer);
		if (!read_term(lexer, term, &unknown))
			return false;
		if (strlen(whole) + strlen(term) >= sizeof(whole))
			return fault(lexer->at, column, "a string of more than %zu characters is not supported",
				     sizeof(whole) - 1);
		strcat(whole, term);
	} while (lexer_peek(lexer) == '|' && lexer->at->text[lexer->position + 1] == '|');
	return klartext_expect_end(lexer) && klartext_string_set(lexer, column, number, unknown ? NULL : whole);
}

bool klartext_string_declare(struct lexer *lexer)
{
	return klartext_take(lexer, "STRING") ? klartext_string_assign(lexer)
					      : fault(lexer->at, lexer_next_column(lexer), "DECLARE needs STRING");
}

void klartext_string_forget(struct klartext *klartext)
{
	klartext->strings.count = 0;
	klartext->strings.forgotten = true;
}
