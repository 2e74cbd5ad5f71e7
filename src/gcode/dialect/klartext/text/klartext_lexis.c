#include "gcode/dialect/klartext/text/klartext_lexis.h"

#include <string.h>

#include "base/ascii.h"

struct lexer klartext_lexer(struct interp *interp)
{
	static const struct lexer_rules rules = {.semicolon = SEMICOLON_STARTS_COMMENT};
	struct lexer lexer;

	lexer_init(&lexer, &interp->at, &rules, interp);
	return lexer;
}

bool klartext_ends_by_tilde(const struct lexer *lexer)
{
	const char *rest = lexer->at->text + lexer->position + 1;

	return rest[strspn(rest, " \t")] == '\0';
}

bool klartext_expect_end(struct lexer *lexer)
{
	if (klartext_ends(lexer))
		return true;
	return fault(lexer->at, lexer_next_column(lexer), "the block should end here");
}

bool klartext_continues(const char *text)
{
	size_t length = strlen(text);

	while (length > 0 && (text[length - 1] == ' ' || text[length - 1] == '\t'))
		length--;
	return length > 0 && text[length - 1] == '~';
}

size_t klartext_word(struct lexer *lexer, char word[KLARTEXT_WORD])
{
	size_t length = 0;

	for (char byte = lexer_peek(lexer); ascii_is_letter(byte); byte = lexer->at->text[lexer->position]) {
		if (length < KLARTEXT_WORD - 1)
			word[length] = ascii_upper(byte);
		length++;
		lexer_take(lexer);
	}
	word[length < KLARTEXT_WORD - 1 ? length : KLARTEXT_WORD - 1] = '\0';
	return length;
}

/* "Q5", "QL5": a parameter may follow a word without a blank, as in REPQ5. */
static bool is_parameter(const char *text)
{
	if (ascii_upper(*text) != 'Q')
		return false;
	text += text[1] != '\0' && strchr("LlRr", text[1]) ? 2 : 1;
	return ascii_is_digit(*text);
}

bool klartext_take(struct lexer *lexer, const char *word)
{
	const char *text;
	size_t length = 0;

	lexer_peek(lexer);
	text = lexer->at->text + lexer->position;
	while (word[length] && ascii_upper(text[length]) == word[length])
		length++;
	if (word[length])
		return false;
	if (ascii_is_letter(text[length]) && ascii_is_letter(word[length - 1]) && !is_parameter(text + length))
		return false;
	lexer->position += length;
	return true;
}

bool klartext_name(struct lexer *lexer, const char *what, char *name, size_t size)
{
	int column = lexer_next_column(lexer);
	const char *text = lexer->at->text + lexer->position, *start = text;
	size_t length;

	if (*text == '"' || *text == '\'') {
		const char *close = strchr(++start, *text);

		if (!close)
			return fault(lexer->at, column,
				     "this name is not closed: the second quotation mark is missing");
		length = (size_t)(close - start);
		lexer->position += length + 2;
	} else {
		length = strcspn(start, " \t;~");
		lexer->position += length;
	}
	if (length == 0)
		return fault(lexer->at, column, "%s is needed here", what);
	if (length >= size)
		return fault(lexer->at, column, "%s of more than %zu characters", what, size - 1);
	memcpy(name, start, length);
	name[length] = '\0';
	return true;
}
