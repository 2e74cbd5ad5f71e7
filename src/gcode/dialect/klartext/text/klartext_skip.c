#include "gcode/dialect/klartext/text/klartext_skip.h"

#include <string.h>

#include "base/ascii.h"
#include "gcode/dialect/klartext/text/klartext_lexis.h"

bool klartext_skip_number(struct lexer *lexer)
{
	const char *text;
	size_t digits;

	lexer_peek(lexer);
	text = lexer->at->text + lexer->position;
	digits = strspn(text, "0123456789");
	lexer->position += digits;
	return digits > 0;
}

bool klartext_skip_head(struct lexer *lexer, bool *slash)
{
	bool numbered = klartext_skip_number(lexer);

	*slash = lexer_peek(lexer) == '/';
	if (!*slash)
		return numbered;
	lexer_take(lexer);
	return klartext_skip_number(lexer) || numbered;
}

/* Do lines with the parameters of this block follow it? */
static bool is_definition(struct lexer *lexer)
{
	char word[KLARTEXT_WORD];

	klartext_word(lexer, word);
	return ((!strcmp(word, "CYCL") || !strcmp(word, "CYCLE")) && !klartext_take(lexer, "CALL")) ||
	       !strcmp(word, "TCH") || !strcmp(word, "PATTERN") || !strcmp(word, "GLOBAL");
}

/* Does this line hold a parameter of a cycle (Q and a number, then "=")? */
static bool is_parameter(struct lexer *lexer)
{
	const char *text;

	if (ascii_upper(lexer_peek(lexer)) != 'Q')
		return false;
	text = lexer->at->text + lexer->position + 1;
	return ascii_is_digit(*text) && strchr(text, '=');
}

bool klartext_skip_definition(struct interp *interp)
{
	struct klartext_lines *lines = &klartext_of(interp)->lines;
	const char *text = interp->at.text;
	struct lexer lexer;
	bool numbered, slash;

	if (!interp->config->read.block_delete || lines->behind_end)
		return false;
	lexer = klartext_lexer(interp);
	numbered = klartext_skip_head(&lexer, &slash);
	if (slash) {
		lines->skips = is_definition(&lexer);
		lines->skips_next = lines->skips && klartext_continues(text);
		return lines->skips;
	}
	if (!lines->skips || klartext_ends(&lexer))
		return false;
	lines->skips = !numbered && (lines->skips_next || is_parameter(&lexer));
	if (!lines->skips)
		return false;
	/* In lines joined by '~', the first line without '~' ends the block. */
	lines->skips = !lines->skips_next || klartext_continues(text);
	lines->skips_next = lines->skips_next && lines->skips;
	return true;
}
