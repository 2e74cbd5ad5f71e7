#include "gcode/text/lexer.h"

#include <string.h>

#include "base/ascii.h"
#include "gcode/text/line_shape.h"
#include "gcode/text/number.h"

void lexer_init(struct lexer *lexer, const struct line_place *at, const struct lexer_rules *rules, void *context)
{
	*lexer = (struct lexer){.at = at, .rules = rules, .context = context};
}

int lexer_next_column(struct lexer *lexer)
{
	lexer_peek(lexer);
	return lexer_column(lexer);
}

bool lexer_keyword(struct lexer *lexer, const char *keyword)
{
	size_t position = lexer->position;

	for (; *keyword; keyword++, lexer_take(lexer)) {
		if (ascii_lower(lexer_peek(lexer)) != *keyword) {
			lexer->position = position;
			return false;
		}
	}
	return true;
}

static bool check_comment(const struct lexer *lexer, const char *text)
{
	return !lexer->rules->check_comment || lexer->rules->check_comment(lexer, text + strspn(text, " \t"));
}

/* Skips "(...)". Controls differ in where a comment inside a comment ends, so this is a fault. */
static bool skip_comment(struct lexer *lexer)
{
	const char *text = lexer->at->text + lexer->position + 1;
	const char *close = strchr(text, ')');
	size_t length = strcspn(text, "()");

	if (text[length] == '\0')
		return fault(lexer->at, lexer_column(lexer), "this comment is not closed");
	/* Wherever the comment ends, only parentheses remain of the block. */
	if (text[length] == '(' && lexer->rules->comments_nest && close && close[strspn(close, ") \t")] == '\0') {
		lexer->position += strlen(text) + 1;
		return check_comment(lexer, text);
	}
	if (text[length] == '(')
		return fault(lexer->at, lexer_column(lexer) + 1 + (int)length, "a comment inside a comment");
	if (!check_comment(lexer, text))
		return false;
	lexer->position += length + 2;
	return true;
}

/*
 * Has the text after a ';' that ends a block any word or statement? Text without one is a remark: the control may
 * refuse or skip it, but it moves no axis.
 */
static bool may_be_blocks(const char *text)
{
	char squeezed[LINE_SHAPE_MAX];

	if (strlen(text) >= LINE_SHAPE_MAX || strpbrk(text, "#[%"))
		return true;
	for (; *text; text += *text == ';') {
		line_shape_squeeze(text, squeezed);
		if (line_shape_has_word(squeezed))
			return true;
		text += strcspn(text, ";");
	}
	return false;
}

static bool skip_rest(struct lexer *lexer)
{
	const char *rest = lexer->at->text + lexer->position + 1;

	if (!lexer->rules->semicolon)
		return fault(lexer->at, lexer_column(lexer),
			     "it is not known whether ';' starts a comment or ends the block on this control");
	if (lexer->rules->semicolon == SEMICOLON_ENDS_BLOCK && may_be_blocks(rest))
		return fault(lexer->at, lexer_column(lexer),
			     "';' ends a block on this control; write the rest on a line of its own, or in parentheses "
			     "if it is a comment; if a parameter makes ';' start a comment, set semicolon=\"comment\" "
			     "in the machine file's <controller>");
	if (!check_comment(lexer, rest))
		return false;
	lexer->position += strlen(rest) + 1;
	return true;
}

bool lexer_skip_comments(struct lexer *lexer)
{
	for (;;) {
		char byte = lexer_peek(lexer);

		if (byte == '(' ? !skip_comment(lexer) : byte == ';' && !skip_rest(lexer))
			return false;
		if (byte != '(')
			return true;
	}
}

static bool fault_at_byte(const struct lexer *lexer, char byte)
{
	int column = lexer_column(lexer);

	for (size_t i = 0; i < lexer->rules->refusal_count; i++) {
		if (lexer->rules->refusals[i].byte == byte)
			return fault(lexer->at, column, "%s", lexer->rules->refusals[i].message);
	}
	if (byte == '/')
		return fault(lexer->at, column, "'/' is allowed only at the start of a block");
	if (byte == '%')
		return fault(lexer->at, column, "'%%' must be alone on its line");
	if (byte > ' ' && byte <= '~')
		return fault(lexer->at, column, "unexpected '%c'", byte);
	return fault(lexer->at, column, "unexpected byte 0x%02X%s", (unsigned)(unsigned char)byte,
		     (unsigned char)byte > '~' ? ": only comments can have characters other than ASCII" : "");
}

static enum lexer_result read_word(struct lexer *lexer, char letter, struct word *word)
{
	size_t position = lexer->position + 1;
	enum lexer_result result;

	word->letter = letter;
	word->vacant = false;
	word->column = lexer_column(lexer);
	switch (number_read(lexer->at->text, &position, &word->value, &word->point)) {
	case NUMBER_OK:
		lexer->position = position;
		return LEXER_WORD;
	case NUMBER_TOO_LONG:
		fault_report(lexer->at, word->column, "%c has a number of more than %d digits", letter,
			     NUMBER_LENGTH_MAX);
		return LEXER_FAULT;
	case NUMBER_MISSING:
		break;
	}
	lexer->position++;
	result = lexer->rules->value ? lexer->rules->value(lexer, word) : LEXER_END;
	if (result != LEXER_END)
		return result;
	fault_report(lexer->at, word->column, "%c without a number", letter);
	return LEXER_FAULT;
}

static enum lexer_result read_comma_word(struct lexer *lexer, struct word *word)
{
	char letter;

	lexer_take(lexer);
	letter = ascii_upper(lexer_peek(lexer));
	if (!ascii_is_letter(letter)) {
		fault_report(lexer->at, lexer_column(lexer), "a letter is missing after ','");
		return LEXER_FAULT;
	}
	word->comma = true;
	return read_word(lexer, letter, word);
}

enum lexer_result lexer_next_any(struct lexer *lexer, struct word *word)
{
	for (;;) {
		char byte = lexer_peek(lexer);

		word->comma = false;
		if (byte == ',' && lexer->rules->comma_words)
			return read_comma_word(lexer, word);
		if (ascii_is_letter(byte))
			return read_word(lexer, ascii_upper(byte), word);
		if ((byte == '@' || byte == '^') && lexer->rules->polar_words)
			return read_word(lexer, byte, word);
		if (byte == '\0')
			return LEXER_END;
		if (lexer->rules->assignment && byte == lexer->rules->assignment_start) {
			if (!lexer->rules->assignment(lexer))
				return LEXER_FAULT;
			lexer->assignments++;
		} else if (byte == '(') {
			if (!skip_comment(lexer))
				return LEXER_FAULT;
		} else if (byte == ';') {
			if (!skip_rest(lexer))
				return LEXER_FAULT;
		} else {
			fault_at_byte(lexer, byte);
			return LEXER_FAULT;
		}
	}
}
