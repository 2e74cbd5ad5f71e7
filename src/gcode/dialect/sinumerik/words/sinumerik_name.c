#include "gcode/dialect/sinumerik/words/sinumerik_name.h"

#include <string.h>

#include "base/ascii.h"
#include "gcode/eval/expr.h"

size_t sinumerik_name_read(struct lexer *lexer, char name[SINUMERIK_NAME + 1])
{
	const char *text = lexer->at->text;
	size_t length = 0, at;

	lexer_peek(lexer);
	at = lexer->position;
	if (!sinumerik_starts_name(text[at]) && text[at] != '$')
		return 0;
	for (; sinumerik_is_name(text[at]) || (length == 0 && text[at] == '$'); at++, length++) {
		if (length == SINUMERIK_NAME)
			return 0;
		name[length] = ascii_upper(text[at]);
	}
	name[length] = '\0';
	lexer->position = at;
	return length;
}

bool sinumerik_name_take(struct lexer *lexer, const char *name)
{
	const size_t position = lexer->position;
	char found[SINUMERIK_NAME + 1];

	if (sinumerik_name_read(lexer, found) && !strcmp(found, name))
		return true;
	lexer->position = position;
	return false;
}

bool sinumerik_name_take_byte(struct lexer *lexer, char byte)
{
	if (lexer_peek(lexer) != byte)
		return false;
	lexer_take(lexer);
	return true;
}

bool sinumerik_name_need(struct lexer *lexer, char byte, const char *after)
{
	return sinumerik_name_take_byte(lexer, byte) ||
	       fault(lexer->at, lexer_next_column(lexer), "'%c' is needed behind %s", byte, after);
}

bool sinumerik_name_step_over_call(struct lexer *lexer)
{
	const char *text = lexer->at->text;
	const int column = lexer_next_column(lexer);
	bool quoted = false;
	int depth = 0;

	if (lexer_peek(lexer) != '(')
		return true;
	for (size_t at = lexer->position; text[at]; at++) {
		quoted = quoted != (text[at] == '"');
		depth += quoted ? 0 : text[at] == '(' ? 1 : text[at] == ')' ? -1 : 0;
		if (depth == 0 && !quoted) {
			lexer->position = at + 1;
			return true;
		}
	}
	return fault(lexer->at, column, "this '(' is not closed");
}
