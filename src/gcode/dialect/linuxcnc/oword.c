#include "gcode/dialect/linuxcnc/oword.h"

#include <stdio.h>
#include <string.h>

#include "base/ascii.h"
#include "gcode/dialect/linuxcnc/linuxcnc_expr.h"
#include "gcode/text/number.h"

/* A keyword comes after all keywords that start with it, such as else after elseif. */
static const struct {
	const char *name;
	enum o_kind kind;
} keywords[] = {{"sub", O_SUB},	    {"endsub", O_ENDSUB}, {"call", O_CALL},	{"do", O_DO},
		{"while", O_WHILE}, {"repeat", O_REPEAT}, {"if", O_IF},		{"elseif", O_ELSEIF},
		{"else", O_ELSE},   {"endif", O_ENDIF},	  {"break", O_BREAK},	{"continue", O_CONTINUE},
		{"endwhile", O_ENDWHILE}, {"endrepeat", O_ENDREPEAT}, {"return", O_RETURN}};

const char *oword_keyword(enum o_kind kind)
{
	for (size_t i = 0; i < sizeof(keywords) / sizeof(*keywords); i++) {
		if (keywords[i].kind == kind)
			return keywords[i].name;
	}
	return kind == O_M98 ? "M98" : kind == O_M99 ? "M99" : "program number";
}

const char *oword_title(const char *name, char *buffer)
{
	bool number = name[0] != '\0' && name[strspn(name, "0123456789")] == '\0';

	snprintf(buffer, OWORD_TITLE, number ? "o%s" : "o<%s>", name);
	return buffer;
}

static bool stands_in_number(char byte)
{
	return ascii_is_digit(byte) || byte == '.' || byte == ' ' || byte == '\t';
}

/* '/' (this line is not skipped) and N, which may have a fraction. */
static void skip_start(struct lexer *lexer)
{
	char byte = lexer_peek(lexer);
	size_t position;
	const char *at;

	if (byte == '/') {
		lexer_take(lexer);
		byte = lexer_peek(lexer);
	}
	if (byte != 'n' && byte != 'N')
		return;
	position = lexer->position;
	lexer_take(lexer);
	byte = lexer_peek(lexer);
	if (byte < '0' || byte > '9') {
		lexer->position = position;
		return;
	}
	for (at = lexer->at->text + lexer->position; stands_in_number(*at); at++)
		continue;
	lexer->position = (size_t)(at - lexer->at->text);
}

/* Reads M98, and M99 inside of subprograms. */
static enum oword_result read_m(struct lexer *lexer, bool called, struct oword *oword)
{
	size_t position = lexer->position + 1;
	double value;
	bool point;

	if (number_read(lexer->at->text, &position, &value, &point) != NUMBER_OK || point)
		return OWORD_NONE;
	if (value > 97 && value < 99)
		oword->kind = O_M98;
	else if (value > 98 && value < 100 && called)
		oword->kind = O_M99;
	else
		return OWORD_NONE;
	lexer->position = position;
	return OWORD_READ;
}

static bool read_label(struct lexer *lexer, struct oword *oword)
{
	int number;

	if (lexer_peek(lexer) == '<')
		return linuxcnc_expr_name(lexer, oword->name);
	if (!linuxcnc_expr_integer(lexer, &number))
		return false;
	snprintf(oword->name, sizeof(oword->name), "%d", number);
	return true;
}

enum oword_result oword_read(struct lexer *lexer, bool called, struct oword *oword)
{
	char byte;

	skip_start(lexer);
	byte = lexer_peek(lexer);
	oword->column = lexer_column(lexer);
	oword->name[0] = '\0';
	if (byte == 'm' || byte == 'M')
		return read_m(lexer, called, oword);
	if (byte != 'o' && byte != 'O')
		return OWORD_NONE;
	lexer_take(lexer);
	if (!read_label(lexer, oword))
		return OWORD_FAULT;
	for (size_t i = 0; i < sizeof(keywords) / sizeof(*keywords); i++) {
		if (lexer_keyword(lexer, keywords[i].name)) {
			oword->kind = keywords[i].kind;
			return OWORD_READ;
		}
	}
	byte = lexer_peek(lexer);
	oword->kind = O_PROGRAM;
	if (byte == '\0' || byte == '(' || byte == ';')
		return OWORD_READ;
	fault_report(lexer->at, lexer_column(lexer),
	      "an o-word must be followed by sub, endsub, call, return, if, elseif, else, endif, while, endwhile, do, "
	      "repeat, endrepeat, break or continue");
	return OWORD_FAULT;
}

bool oword_end(struct lexer *lexer, const struct oword *oword)
{
	if (!lexer_skip_comments(lexer))
		return false;
	if (lexer_peek(lexer) == '\0')
		return true;
	return fault(lexer->at, lexer_column(lexer), "only a comment can follow %s%s",
		     oword->kind <= O_RETURN ? "the o-word " : "", oword_keyword(oword->kind));
}
