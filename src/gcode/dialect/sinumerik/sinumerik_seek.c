#include "gcode/dialect/sinumerik/sinumerik_seek.h"

#include <string.h>

#include "base/callbacks.h"
#include "gcode/dialect/sinumerik/sinumerik_ahead.h"
#include "gcode/program.h"

/* Lines read between two queries of the cancel callback. */
#define ASK_LINES 4096

static size_t skip_blanks(const char *text, size_t at)
{
	while (text[at] == ' ' || text[at] == '\t')
		at++;
	return at;
}

/* Copies a name of digits, letters and '_' in upper case; a name that is too long becomes empty. */
static size_t copy_name(const char *text, size_t at, char name[SINUMERIK_NAME + 1])
{
	size_t length = 0;

	for (; sinumerik_is_name(text[at]); at++) {
		if (length == SINUMERIK_NAME) {
			name[0] = '\0';
			return at +
			       strspn(text + at, "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz_0123456789");
		}
		name[length++] = sinumerik_upper(text[at]);
	}
	name[length] = '\0';
	return at;
}

struct sinumerik_head sinumerik_seek_head(const char *text)
{
	struct sinumerik_head head = {.rest = skip_blanks(text, 0)};
	char name[SINUMERIK_NAME + 1];
	size_t at;

	if (text[head.rest] == '/') {
		head.skipped = true;
		head.rest = skip_blanks(text, head.rest + 1 + sinumerik_is_digit(text[head.rest + 1]));
	}
	if ((sinumerik_upper(text[head.rest]) == 'N' || text[head.rest] == ':') &&
	    sinumerik_is_digit(text[head.rest + 1])) {
		size_t length = 0;

		head.number[length++] = sinumerik_upper(text[head.rest]);
		for (at = head.rest + 1; sinumerik_is_digit(text[at]); at++) {
			if (length < SINUMERIK_NAME)
				head.number[length++] = text[at];
		}
		head.rest = skip_blanks(text, at);
	}
	if (!sinumerik_is_letter(text[head.rest]))
		return head;
	at = skip_blanks(text, copy_name(text, head.rest, name));
	if (text[at] == ':' && text[at + 1] != '=' && name[0]) {
		strcpy(head.label, name);
		head.rest = skip_blanks(text, at + 1);
	}
	return head;
}

static bool is_word(const char *text, size_t at, const char *word)
{
	const size_t length = strlen(word);

	for (size_t i = 0; i < length; i++) {
		if (sinumerik_upper(text[at + i]) != word[i])
			return false;
	}
	return !sinumerik_is_name(text[at + length]);
}

/* Is the line a condition with a jump? Such an IF has no ENDIF. */
static bool has_jump(const char *words)
{
	static const char *const jumps[] = {"GOTO", "GOTOF", "GOTOB", "GOTOC", "GOTOS"};
	bool quoted = false;

	for (size_t at = 0; words[at] && (quoted || words[at] != ';'); at++) {
		quoted = quoted != (words[at] == '"');
		if (quoted || (at > 0 && sinumerik_is_name(words[at - 1])))
			continue;
		for (size_t i = 0; i < sizeof(jumps) / sizeof(jumps[0]); i++) {
			if (is_word(words, at, jumps[i]))
				return true;
		}
	}
	return false;
}

/* "%_N_NAME_SPF": the head of a program in a file with several programs. */
static bool is_head(const char *text)
{
	return text[skip_blanks(text, 0)] == '%';
}

/* Is the line the head of the program with this upper-case name? */
static bool heads(const char *text, const char *name)
{
	size_t at = skip_blanks(text, skip_blanks(text, 0) + 1), length;
	char found[SINUMERIK_NAME + 1];

	if (!is_head(text))
		return false;
	if (!strncmp(text + at, "_N_", 3))
		at += 3;
	copy_name(text, at, found);
	length = strlen(found);
	if (length > 4 && (!strcmp(found + length - 4, "_SPF") || !strcmp(found + length - 4, "_MPF")))
		found[length - 4] = '\0';
	return found[0] && !strcmp(found, name);
}

struct position sinumerik_seek_top(struct interp *interp)
{
	const struct sinumerik *sinumerik = sinumerik_of(interp);

	for (int i = sinumerik->calls.depth; i-- > 0;) {
		const struct sinumerik_call *call = &sinumerik->calls.items[i];

		if (!call->last_line)
			return call->entry.source == interp->program.source
				   ? call->entry
				   : (struct position){interp->program.source, 0, 1};
	}
	if (interp->program.source == interp->program.start.source)
		return interp->program.start;
	return (struct position){interp->program.source, 0, 1};
}

/* ------------------------------------------------------------------ memory */

static struct sinumerik_jump *remembered(struct interp *interp, const char *target, long long from)
{
	unsigned long hash = (unsigned long)from * 31;

	for (const char *at = target; *at; at++)
		hash = hash * 31 + (unsigned char)*at;
	return &sinumerik_of(interp)->search.jumps[hash % SINUMERIK_JUMPS];
}

static bool recall(struct interp *interp, const char *target, long long from, struct position *to)
{
	const struct sinumerik_jump *jump = remembered(interp, target, from);

	if (jump->source != interp->program.source || jump->from != from || strcmp(jump->target, target) != 0)
		return false;
	*to = jump->to;
	return true;
}

static void remember(struct interp *interp, const char *target, long long from, const struct position *to)
{
	struct sinumerik_jump *jump = remembered(interp, target, from);

	*jump = (struct sinumerik_jump){.source = interp->program.source, .from = from, .to = *to};
	strcpy(jump->target, target);
}

/* ------------------------------------------------------------------ search */

/* Further reading overwrites the text of the current line, which messages and the lexer need: copies it. */
static void keep_line(struct interp *interp)
{
	struct strbuf *line = &sinumerik_of(interp)->search.line;

	if (interp->at.text == line->text)
		return;
	strbuf_clear(line);
	strbuf_add(line, interp->at.text, strlen(interp->at.text));
	interp->at.text = strbuf_text(line);
}

/* Returns to the line after the current one. */
static bool come_back(struct interp *interp, const struct position *next, int column)
{
	return program_jump(&interp->program, next, &interp->at, column);
}

static bool cancelled(struct interp *interp, const struct reader *reader)
{
	return reader->line % ASK_LINES == 0 && cancel_asked(interp->config->read.cancel);
}

static bool label_matches(const struct sinumerik_head *head, const char *name)
{
	return !strcmp(head->label, name) || !strcmp(head->number, name);
}

/* Searches from the reader's position to the line `last` (0: to the end); the first match, or the last one. */
static bool scan(struct interp *interp, const char *name, long last, bool first, struct position *to, bool *found)
{
	struct source *source = interp->program.source;
	struct reader *reader = &source->reader;
	const char *text;

	while ((!last || reader->line < last) && reader_next(reader, &text) == READER_LINE) {
		const struct sinumerik_head head = sinumerik_seek_head(text);

		if (cancelled(interp, reader))
			return false;
		/* Another program begins. */
		if (!last && is_head(text))
			return true;
		if (!label_matches(&head, name))
			continue;
		*to = source_here(source);
		*found = true;
		if (first)
			return true;
	}
	return true;
}

static bool search_label(struct interp *interp, const char *name, enum sinumerik_direction direction, int column,
			 struct position *to, bool *found)
{
	const struct position next = source_next(interp->program.source), top = sinumerik_seek_top(interp);
	const long here = interp->at.line;

	*found = false;
	if (direction != SINUMERIK_BACKWARD && !scan(interp, name, 0, true, to, found))
		return false;
	if (!*found && direction != SINUMERIK_FORWARD) {
		if (!program_jump(&interp->program, &top, &interp->at, column) ||
		    !scan(interp, name, here, direction == SINUMERIK_ANYWHERE, to, found))
			return false;
	}
	return come_back(interp, &next, column);
}

bool sinumerik_seek_label(struct interp *interp, const char *name, enum sinumerik_direction direction, int column,
			  struct position *to, bool *found)
{
	const long long from = interp->program.source->reader.start;
	char key[SINUMERIK_NAME + 2];
	bool good;

	key[0] = (char)('0' + direction);
	strcpy(key + 1, name);
	*found = true;
	if (recall(interp, key, from, to))
		return true;
	keep_line(interp);
	good = search_label(interp, name, direction, column, to, found);
	if (good && *found)
		remember(interp, key, from, to);
	return good;
}

bool sinumerik_seek_label_behind(struct interp *interp, const char *name, const struct position *start, long last,
				 int column, struct position *to, bool *found)
{
	const struct position next = source_next(interp->program.source);

	keep_line(interp);
	*found = false;
	return program_jump(&interp->program, start, &interp->at, column) &&
	       scan(interp, name, last, true, to, found) && come_back(interp, &next, column);
}

bool sinumerik_seek_program(struct interp *interp, const char *name, int column, struct position *to, bool *found)
{
	struct source *source = interp->program.source;
	const struct position next = source_next(source), top = {source, 0, 1};
	const char *text;
	char key[SINUMERIK_NAME + 2] = "%";

	strcat(key, name);
	*found = true;
	if (recall(interp, key, 0, to))
		return true;
	*found = false;
	keep_line(interp);
	if (!program_jump(&interp->program, &top, &interp->at, column))
		return false;
	while (!*found && reader_next(&source->reader, &text) == READER_LINE) {
		if (cancelled(interp, &source->reader))
			return false;
		*found = heads(text, name);
	}
	if (*found) {
		*to = source_next(source);
		remember(interp, key, 0, to);
	}
	return come_back(interp, &next, column);
}

/* Is the line the head of a program of this type, "_MPF" or "_SPF"? */
static bool is_head_of(const char *text, const char *type)
{
	size_t at = skip_blanks(text, skip_blanks(text, 0) + 1), length;
	char name[SINUMERIK_NAME + 1];

	if (!is_head(text) || strncmp(text + at, "_N_", 3) != 0)
		return false;
	copy_name(text, at, name);
	length = strlen(name);
	return length > 4 && !strcmp(name + length - 4, type);
}

bool sinumerik_seek_heads_main(const char *text)
{
	return is_head_of(text, "_MPF");
}

bool sinumerik_seek_main(struct interp *interp)
{
	struct source *source = interp->program.source;
	const struct position next = source_next(source);
	const char *text;

	if (!is_head_of(line_start(&interp->at), "_SPF"))
		return true;
	keep_line(interp);
	while (reader_next(&source->reader, &text) == READER_LINE) {
		if (cancelled(interp, &source->reader))
			return false;
		if (!sinumerik_seek_heads_main(text))
			continue;
		interp->program.start = source_next(source);
		return true;
	}
	return come_back(interp, &next, 1);
}

bool sinumerik_seek_tool_change(struct interp *interp, int column, bool *found)
{
	struct source *source = interp->program.source;
	const struct position next = source_next(source);
	enum sinumerik_ahead ahead = SINUMERIK_AHEAD_NOTHING;
	const char *text;

	keep_line(interp);
	while (ahead == SINUMERIK_AHEAD_NOTHING && reader_next(&source->reader, &text) == READER_LINE &&
	       !is_head(text)) {
		if (cancelled(interp, &source->reader))
			return false;
		ahead = sinumerik_ahead_of_line(text + sinumerik_seek_head(text).rest);
	}
	*found = ahead == SINUMERIK_AHEAD_CHANGE;
	return come_back(interp, &next, column);
}

/* -------------------------------------------------------------- structures */

struct structure {
	const char *open, *close;
};

static const struct structure structures[] = {
	[SINUMERIK_ENDIF] = {"IF", "ENDIF"},	   [SINUMERIK_ELSE] = {"IF", "ENDIF"},
	[SINUMERIK_ENDWHILE] = {"WHILE", "ENDWHILE"}, [SINUMERIK_ENDFOR] = {"FOR", "ENDFOR"},
	[SINUMERIK_ENDLOOP] = {"LOOP", "ENDLOOP"},	   [SINUMERIK_UNTIL] = {"REPEAT", "UNTIL"},
};

/* REPEAT with a label repeats a part of the program, and IF with a jump is complete: neither opens a structure. */
static bool opens(const char *words, const struct structure *structure)
{
	size_t at;

	if (!is_word(words, 0, structure->open))
		return false;
	at = skip_blanks(words, strlen(structure->open));
	if (structure == &structures[SINUMERIK_UNTIL])
		return !sinumerik_is_letter(words[at]);
	return structure->open[0] != 'I' || !has_jump(words);
}

/* Searches from the reader's position on, which is inside the structure. */
static bool scan_close(struct interp *interp, enum sinumerik_close close, struct position *behind, bool *found)
{
	struct source *source = interp->program.source;
	const struct structure *structure = &structures[close];
	const char *text;
	int depth = 1;

	*found = false;
	while (reader_next(&source->reader, &text) == READER_LINE) {
		const struct sinumerik_head head = sinumerik_seek_head(text);
		const char *words = text + head.rest;

		if (cancelled(interp, &source->reader))
			return false;
		if (is_head(text))
			return true;
		if (opens(words, structure))
			depth++;
		else if (is_word(words, 0, structure->close))
			depth--;
		else if (!(close == SINUMERIK_ELSE && depth == 1 && is_word(words, 0, "ELSE")))
			continue;
		if (depth > 0 && !(close == SINUMERIK_ELSE && depth == 1 && is_word(words, 0, "ELSE")))
			continue;
		*behind = source_next(source);
		*found = true;
		return true;
	}
	return true;
}

bool sinumerik_seek_close_of(struct interp *interp, enum sinumerik_close close, const struct position *start,
			     int column, struct position *behind)
{
	const struct position next = source_next(interp->program.source);
	const char *key = close == SINUMERIK_ELSE ? "ELSE" : structures[close].close, *text;
	const long line = start->line;
	bool found = true, good;

	if (recall(interp, key, start->offset, behind))
		return true;
	keep_line(interp);
	good = program_jump(&interp->program, start, &interp->at, column) &&
	       reader_next(&interp->program.source->reader, &text) == READER_LINE &&
	       scan_close(interp, close, behind, &found) && come_back(interp, &next, column);
	if (!good)
		return false;
	if (!found)
		return fault(&interp->at, column, "%s in line %ld has no %s", structures[close].open, line,
			     structures[close].close);
	remember(interp, key, start->offset, behind);
	return true;
}

bool sinumerik_seek_close(struct interp *interp, enum sinumerik_close close, int column, struct position *behind)
{
	const struct position here = source_here(interp->program.source);

	return sinumerik_seek_close_of(interp, close, &here, column, behind);
}
