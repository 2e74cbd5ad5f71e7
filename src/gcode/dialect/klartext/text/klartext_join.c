#include "gcode/dialect/klartext/text/klartext_join.h"

#include <string.h>

#include "base/ascii.h"
#include "gcode/dialect/klartext/text/klartext_lexis.h"

enum joined { JOINED_NOT, JOINED_FORMULA, JOINED_BLOCK };

/* The kind of block that begins in the current line and continues in the next one. */
static enum joined kind_of_line(struct interp *interp)
{
	static const char *const by_line[] = {"CYCL", "CYCLE", "TCH", "PATTERN", "GLOBAL"};
	struct lexer lexer = klartext_lexer(interp);
	const char *text = interp->at.text;
	char word[KLARTEXT_WORD];

	if (klartext_of(interp)->cycles.definition.open || !klartext_continues(text))
		return JOINED_NOT;
	/* Skips a block number and the mark for block skip, which stands before or after the number. */
	lexer.position += strspn(text + lexer.position, " \t0123456789/");
	if (ascii_upper(lexer_peek(&lexer)) == 'Q')
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
	return ascii_is_digit(text[strspn(text, " \t")]);
}

/* Does this line begin a new block? A block that ignores its words would otherwise swallow it. */
static bool is_own_block(struct interp *interp, const char *text, bool (*begins_block)(const char *word))
{
	const struct line_place at = interp->at;
	struct lexer lexer;
	char word[KLARTEXT_WORD], behind;

	interp->at.text = text;
	lexer = klartext_lexer(interp);
	klartext_word(&lexer, word);
	behind = text[lexer.position];
	interp->at = at;
	if (word[0] == 'Q')
		return strchr(text, '=') != NULL;
	/* "L+5" and "C+90" are a length and an axis, not blocks. */
	return begins_block(word) && (behind == '\0' || behind == ' ' || behind == '\t');
}

/*
 * Adds the line without its final '~', and without its comment if another line follows. Another '~' in the line stays
 * and is refused later.
 */
static void add_part(struct strbuf *line, const char *text)
{
	size_t length = strlen(text);

	if (klartext_continues(text))
		length = strchr(text, ';') ? strcspn(text, ";") : (size_t)(strrchr(text, '~') - text);
	strbuf_addf(line, "%.*s", (int)length, text);
}

/* Reports a fault with the joined text, because the reader has overwritten the first line. */
static bool fault_joined(struct interp *interp, const char *message)
{
	interp->at.text = strbuf_text(&klartext_of(interp)->lines.joined);
	return fault(&interp->at, 1, "%s", message);
}

/* Refuses a block that could fill the memory. Its text is too long for a message. */
static bool fault_long(struct interp *interp)
{
	interp->at.text = strbuf_text(&klartext_of(interp)->lines.joined);
	diag_error(interp->diag, (struct srcloc){interp->at.file, interp->at.line, 0},
		   "'~' continues this block over more than %d bytes; is this an NC program?", LINE_LENGTH_MAX);
	return false;
}

bool klartext_join(struct interp *interp, bool (*begins_block)(const char *word))
{
	struct strbuf *line = &klartext_of(interp)->lines.joined;
	const enum joined kind = kind_of_line(interp);
	const char *text = interp->at.text;

	if (kind == JOINED_NOT)
		return true;
	strbuf_clear(line);
	add_part(line, text);
	while (klartext_continues(text)) {
		if (reader_next(&interp->program.source->reader, &text) != READER_LINE)
			return fault_joined(interp, kind == JOINED_FORMULA
							    ? "the next line, in which this formula goes on, cannot be "
							      "read"
							    : "the next line, in which this block goes on, cannot be "
							      "read");
		/* A number would become part of the value at the end of the line before. */
		if (kind == JOINED_BLOCK && begins_with_digit(text))
			return fault_joined(interp, "'~' continues this block, but the next line begins with a number");
		if (kind == JOINED_BLOCK && is_own_block(interp, text, begins_block))
			return fault_joined(interp, "'~' continues this block, but the next line begins another one");
		if (kind == JOINED_BLOCK)
			strbuf_addf(line, " ");
		add_part(line, text);
		if (line->length > LINE_LENGTH_MAX)
			return fault_long(interp);
	}
	interp->at.text = strbuf_text(line);
	return true;
}
