#include "gcode/dialect/klartext/values/klartext_string.h"

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
	if (!string && klartext_of(lexer->context)->strings.forgotten)
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

/* Reads a text in quotation marks, which may be empty, or a string parameter. */
static bool read_term(struct lexer *lexer, char text[KLARTEXT_NAME])
{
	const int column = lexer_next_column(lexer);
	const char *rest = lexer->at->text + lexer->position;

	if (rest[0] == '"' && rest[1] == '"') {
		lexer->position += 2;
		text[0] = '\0';
		return true;
	}
	return rest[0] == '"' ? klartext_name(lexer, "a text", text, KLARTEXT_NAME)
	       : klartext_string_follows(lexer)
		   ? read_value(lexer, text)
		   : fault(lexer->at, column,
			   "a string is a text in quotation marks, QS, or several of them joined by ||; functions of "
			   "strings are not supported");
}

bool klartext_string_set(struct lexer *lexer, int column, int number, const char *text)
{
	struct klartext *klartext = klartext_of(lexer->context);
	struct klartext_string *string = find(klartext, number);

	if (strlen(text) >= sizeof(string->text))
		return fault(lexer->at, column, "a string of more than %zu characters is not supported",
			     sizeof(string->text) - 1);
	if (!string && klartext->strings.count == KLARTEXT_STRINGS_MAX)
		return fault(lexer->at, column, "more than %d string parameters", KLARTEXT_STRINGS_MAX);
	if (!string)
		string = &klartext->strings.items[klartext->strings.count++];
	string->number = number;
	strcpy(string->text, text);
	return true;
}

bool klartext_string_assign(struct lexer *lexer)
{
	const int column = lexer_next_column(lexer);
	char whole[KLARTEXT_NAME] = "", term[KLARTEXT_NAME];
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
		if (!read_term(lexer, term))
			return false;
		if (strlen(whole) + strlen(term) >= sizeof(whole))
			return fault(lexer->at, column, "a string of more than %zu characters is not supported",
				     sizeof(whole) - 1);
		strcat(whole, term);
	} while (lexer_peek(lexer) == '|' && lexer->at->text[lexer->position + 1] == '|');
	return klartext_expect_end(lexer) && klartext_string_set(lexer, column, number, whole);
}

bool klartext_string_declare(struct lexer *lexer)
{
	return klartext_take(lexer, "STRING") ? klartext_string_assign(lexer)
					      : fault(lexer->at, lexer_next_column(lexer), "DECLARE needs STRING");
}

bool klartext_string_number(struct lexer *lexer, double *value)
{
	const int column = lexer_next_column(lexer);
	char text[KLARTEXT_NAME];

	if (lexer_peek(lexer) != '(')
		return fault(lexer->at, column, "TONUMB needs ( SRC_QS and a number )");
	lexer_take(lexer);
	lexer_peek(lexer);
	if (strncmp(lexer->at->text + lexer->position, "SRC_", 4) != 0)
		return fault(lexer->at, lexer_next_column(lexer), "TONUMB needs SRC_QS and a number here");
	lexer->position += 4;
	if (!read_value(lexer, text))
		return false;
	if (lexer_peek(lexer) != ')')
		return fault(lexer->at, lexer_next_column(lexer), "')' is needed here");
	lexer_take(lexer);
	return decimal_read(text, strlen(text), value) || fault(lexer->at, column, "\"%s\" is no number", text);
}

void klartext_string_forget(struct klartext *klartext)
{
	klartext->strings.count = 0;
	klartext->strings.forgotten = true;
}
