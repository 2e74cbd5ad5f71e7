#include "gcode/dialect/sinumerik/values/sinumerik_macro.h"

#include <stdlib.h>
#include <string.h>

#include "base/ascii.h"
#include "base/mem.h"
#include "gcode/dialect/sinumerik/words/sinumerik_codes.h"
#include "gcode/dialect/sinumerik/words/sinumerik_name.h"
#include "gcode/eval/expr.h"

/* The maximum number of macros in a program. */
#define MACROS_MAX 1000

static struct sinumerik_macro *find(const struct sinumerik *sinumerik, const char *name, size_t length)
{
	for (size_t i = 0; i < sinumerik->macros.count; i++) {
		struct sinumerik_macro *macro = &sinumerik->macros.items[i];
		size_t k = 0;

		while (k < length && macro->name[k] == ascii_upper(name[k]))
			k++;
		if (k == length && macro->name[k] == '\0')
			return macro;
	}
	return NULL;
}

/* The end of the text, before a comment and the blanks that precede it. */
static size_t text_length(const char *text)
{
	size_t length = 0;
	bool quoted = false;

	while (text[length] && (text[length] != ';' || quoted)) {
		quoted = quoted != (text[length] == '"');
		length++;
	}
	while (length > 0 && (text[length - 1] == ' ' || text[length - 1] == '\t'))
		length--;
	return length;
}

/* Refuses a statement in the text: it would begin or end a structure, and jumps would not find it. False: reported. */
static bool check_text(struct lexer text)
{
	char name[SINUMERIK_NAME + 1];
	struct sinumerik_word word;
	bool quoted = false;

	for (char byte; (byte = lexer_peek(&text)) != '\0' && (byte != ';' || quoted);) {
		const int column = lexer_next_column(&text);

		quoted = quoted != (byte == '"');
		if (quoted || !sinumerik_name_read(&text, name))
			lexer_take(&text);
		else if (sinumerik_codes_word(name, &word) && word.kind == SINUMERIK_WORD_STATEMENT)
			return fault(text.at, column, "DEFINE of %s, a statement of its own block, is not supported",
				     name);
	}
	return true;
}

/*
 * 840D sl, job planning, "Macro technique (DEFINE ... AS)". A name that the control itself knows would change the
 * meaning of other lines, and a part of a structure could not be found from elsewhere: both are refused.
 */
bool sinumerik_macro_define(struct interp *interp, struct lexer *lexer)
{
	struct sinumerik *sinumerik = sinumerik_of(interp);
	const int column = lexer_next_column(lexer);
	char name[SINUMERIK_NAME + 1];
	struct sinumerik_macro *macro;
	struct sinumerik_word word;
	const char *text;

	if (!sinumerik_name_read(lexer, name) || !sinumerik_starts_name(name[1]))
		return fault(lexer->at, column,
			     "DEFINE needs a name that begins with two letters, of at most %d bytes", SINUMERIK_NAME);
	if (sinumerik_codes_word(name, &word))
		return fault(lexer->at, column, "%s means something else: a DEFINE of it is not supported", name);
	if (!sinumerik_name_take(lexer, "AS"))
		return fault(lexer->at, lexer_next_column(lexer), "AS is needed behind the name of DEFINE");
	lexer_peek(lexer);
	text = lexer->at->text + lexer->position;
	if (!check_text(*lexer))
		return false;
	macro = find(sinumerik, name, strlen(name));
	if (macro && macro->level != sinumerik->calls.level &&
	    (strlen(macro->text) != text_length(text) || memcmp(macro->text, text, text_length(text)) != 0))
		return fault(lexer->at, column,
			     "%s has another text in the program that calls, or in a subprogram before: which one "
			     "holds after the return is not certain; give it another name",
			     name);
	if (!macro && sinumerik->macros.count == MACROS_MAX)
		return fault(lexer->at, column, "more than %d names of DEFINE", MACROS_MAX);
	if (!macro) {
		sinumerik->macros.items = mem_grow(sinumerik->macros.items, &sinumerik->macros.capacity,
						   sinumerik->macros.count + 1, sizeof(*sinumerik->macros.items));
		macro = &sinumerik->macros.items[sinumerik->macros.count++];
		*macro = (struct sinumerik_macro){.level = sinumerik->calls.level};
		strcpy(macro->name, name);
	}
	free(macro->text);
	macro->text = mem_strndup(text, text_length(text));
	return true;
}

void sinumerik_macro_expand(struct interp *interp, size_t rest)
{
	struct sinumerik *sinumerik = sinumerik_of(interp);
	const char *text = interp->at.text;
	struct strbuf *line = &interp->program.line;
	struct lexer lexer = {.at = &interp->at, .position = rest};
	size_t at = rest, kept = 0;
	bool quoted = false;

	/* A second DEFINE gives the name another text. */
	if (sinumerik->macros.count == 0 || sinumerik_name_take(&lexer, "DEFINE"))
		return;
	strbuf_clear(line);
	while (text[at] && (text[at] != ';' || quoted)) {
		const struct sinumerik_macro *macro;
		size_t length = 0;

		quoted = quoted != (text[at] == '"');
		while (!quoted && (sinumerik_is_name(text[at + length]) || text[at + length] == '$'))
			length++;
		macro = length > 1 ? find(sinumerik, text + at, length) : NULL;
		if (macro) {
			strbuf_add(line, text + kept, at - kept);
			strbuf_addf(line, "%s", macro->text);
			kept = at + length;
		}
		at += length ? length : 1;
	}
	if (kept == 0)
		return;
	strbuf_addf(line, "%s", text + kept);
	interp->at.text = strbuf_text(line);
}

void sinumerik_macro_release(struct sinumerik *sinumerik)
{
	for (size_t i = 0; i < sinumerik->macros.count; i++)
		free(sinumerik->macros.items[i].text);
	free(sinumerik->macros.items);
}
