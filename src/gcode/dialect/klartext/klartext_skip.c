#include "gcode/dialect/klartext/klartext_skip.h"

#include <string.h>

#include "gcode/dialect/klartext/klartext_lexis.h"

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

/* Has the block lines of its own behind it: its parameters? */
static bool is_definition(struct lexer *lexer)
{
	char word[KLARTEXT_WORD];

	klartext_word(lexer, word);
	return ((!strcmp(word, "CYCL") || !strcmp(word, "CYCLE")) && !klartext_take(lexer, "CALL")) ||
	       !strcmp(word, "TCH") || !strcmp(word, "PATTERN");
}

/* Does a line without '~' before it, and without a number, hold the parameter of a cycle? */
static bool is_parameter(struct lexer *lexer)
{
	const char *text;

	if (klartext_upper(lexer_peek(lexer)) != 'Q')
		return false;
	text = lexer->at->text + lexer->position + 1;
	return *text >= '0' && *text <= '9' && strchr(text, '=');
}

bool klartext_skip_definition(struct interp *interp)
{
	struct klartext *klartext = klartext_of(interp);
	const char *text = interp->at.text;
	struct lexer lexer;
	bool numbered, slash;

	if (!interp->config->read.block_delete || klartext->behind_end)
		return false;
	lexer = klartext_lexer(interp);
	numbered = klartext_skip_head(&lexer, &slash);
	if (slash) {
		klartext->skips = is_definition(&lexer);
		klartext->skips_next = klartext->skips && klartext_continues(text);
		return klartext->skips;
	}
	if (!klartext->skips || klartext_ends(&lexer))
		return false;
	klartext->skips = !numbered && (klartext->skips_next || is_parameter(&lexer));
	if (!klartext->skips)
		return false;
	/* Of lines with '~' the first one without it is the last. */
	klartext->skips = !klartext->skips_next || klartext_continues(text);
	klartext->skips_next = klartext->skips_next && klartext->skips;
	return true;
}
