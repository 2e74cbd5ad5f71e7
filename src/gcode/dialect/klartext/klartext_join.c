#include "gcode/dialect/klartext/klartext_join.h"

#include <string.h>

#include "gcode/dialect/klartext/klartext_lexis.h"

enum joined { JOINED_NOT, JOINED_FORMULA, JOINED_BLOCK };

/* What the line in hand begins that goes on in the next one. */
static enum joined kind_of_line(struct interp *interp)
{
	static const char *const by_line[] = {"CYCL", "CYCLE", "TCH", "PATTERN"};
	struct lexer lexer = klartext_lexer(interp);
	const char *text = interp->at.text;
	char word[KLARTEXT_WORD];

	if (klartext_of(interp)->definition.open || !klartext_continues(text))
		return JOINED_NOT;
	lexer.position += strspn(text + lexer.position, " \t");
	lexer.position += strspn(text + lexer.position, "0123456789");
	if (klartext_upper(lexer_peek(&lexer)) == 'Q')
		return JOINED_FORMULA;
	if (strchr(text, ';') || !klartext_word(&lexer, word))
		return JOINED_NOT;
	for (size_t i = 0; i < sizeof(by_line) / sizeof(by_line[0]); i++) {
		if (!strcmp(word, by_line[i]))
			return JOINED_NOT;
	}
	return JOINED_BLOCK;
}

static bool begins_with_digit(const char *text)
{
	const char byte = text[strspn(text, " \t")];

	return byte >= '0' && byte <= '9';
}

/* The reader has given up the first line: what was joined so far stands for it. */
static bool fault_joined(struct interp *interp, const char *message)
{
	interp->at.text = strbuf_text(&klartext_of(interp)->joined);
	return fault(&interp->at, 1, "%s", message);
}

bool klartext_join(struct interp *interp)
{
	struct strbuf *line = &klartext_of(interp)->joined;
	const enum joined kind = kind_of_line(interp);
	const char *text = interp->at.text;

	if (kind == JOINED_NOT)
		return true;
	strbuf_clear(line);
	strbuf_addf(line, "%.*s", (int)strcspn(text, ";~"), text);
	while (klartext_continues(text)) {
		if (reader_next(&interp->program.source->reader, &text) != READER_LINE)
			return fault_joined(interp, kind == JOINED_FORMULA
							    ? "the next line, in which this formula goes on, cannot be read"
							    : "the next line, in which this block goes on, cannot be read");
		/* Behind a value, a number would become part of it. */
		if (kind == JOINED_BLOCK && begins_with_digit(text))
			return fault_joined(interp, "'~' continues this block, but the next line begins with a number");
		strbuf_addf(line, kind == JOINED_BLOCK ? " %.*s" : "%.*s", (int)strcspn(text, ";~"), text);
	}
	interp->at.text = strbuf_text(line);
	return true;
}
