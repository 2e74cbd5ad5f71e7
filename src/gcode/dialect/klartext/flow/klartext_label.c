#include "gcode/dialect/klartext/flow/klartext_label.h"

#include <stdio.h>
#include <string.h>

#include "gcode/dialect/klartext/text/klartext_lexis.h"
#include "gcode/dialect/klartext/text/klartext_skip.h"
#include "gcode/dialect/klartext/values/klartext_string.h"
#include "gcode/dialect/klartext/values/klartext_value.h"
#include "gcode/text/line_search.h"

/* Bytes of the key of a label, which consists of its source and its name. */
#define KEY (KLARTEXT_NAME + 24)

enum { LABEL_FOUND, LABEL_TWICE };	/* twice: `body` is the line of the second one */

bool klartext_label_read_name(struct lexer *lexer, char name[KLARTEXT_NAME])
{
	char byte = lexer_peek(lexer);
	int number;

	if (byte == '"' || byte == '\'')
		return klartext_name(lexer, "a label's name", name, KLARTEXT_NAME);
	if (klartext_string_follows(lexer))
		return klartext_string_name(lexer, "a label's name", name);
	if (!klartext_value_follows(lexer))
		return klartext_name(lexer, "a label", name, KLARTEXT_NAME);
	if (!klartext_integer(lexer, "a label", 0, 65535, &number))
		return false;
	snprintf(name, KLARTEXT_NAME, "%d", number);
	return true;
}

static void make_key(char key[KEY], const struct sources *sources, const struct source *source, const char *name)
{
	size_t index = 0;

	while (index < sources->count && sources->items[index] != source)
		index++;
	snprintf(key, KEY, "%zu %s", index, name);
}

/* Reads the name after "LBL", with `by_parameter` also "LBL Q5", in a line that is read ahead. False: another line. */
static bool name_of_line(struct interp *interp, const char *text, bool by_parameter, char name[KLARTEXT_NAME])
{
	struct diag unheard = {0};
	const struct line_place at = {.diag = &unheard, .file = "", .text = text};
	struct lexer lexer = klartext_lexer(interp);
	bool slash;

	lexer.at = &at;
	klartext_skip_head(&lexer, &slash);
	return !(slash && interp->config->read.block_delete) && klartext_take(&lexer, "LBL") &&
	       (by_parameter || lexer_peek(&lexer) != 'Q') && klartext_label_read_name(&lexer, name);
}

static bool add_label(struct interp *interp, const char *name)
{
	struct klartext_calls *calls = &klartext_of(interp)->calls;
	struct source *source = interp->program.source;
	struct label *label;
	char key[KEY];

	make_key(key, &interp->program.sources, source, name);
	label = labels_find(&calls->labels, key);
	if (label && label->kind == LABEL_FOUND && label->at.line != source->reader.line) {
		label->kind = LABEL_TWICE;
		label->body = source_here(source);
	}
	if (label)
		return true;
	label = labels_add(&calls->labels, key, LABEL_FOUND);
	if (!label)
		return fault(&interp->at, 1, "more than %d labels", LABELS_MAX);
	label->at = source_here(source);
	label->body = source_next(source);
	return true;
}

static enum line_sought note_label(void *interp, const char *text, long line)
{
	char name[KLARTEXT_NAME];

	(void)line;
	return name_of_line(interp, text, false, name) && strcmp(name, "0") != 0 && !add_label(interp, name)
		       ? LINE_SOUGHT
		       : LINE_OTHER;
}

/* Reads the whole current file once, for this label, and notes all its labels. False: reported. */
static bool scan_labels(struct interp *interp, const char *title, int column)
{
	struct source *source = interp->program.source;
	const struct position first = {source, 0, 1};
	struct line_search lines = {
	    .judge = note_label, .context = interp, .cancel = interp->config->read.cancel, .most = 1};
	char key[KEY];

	make_key(key, &interp->program.sources, source, "");
	if (labels_find(&klartext_of(interp)->calls.labels, key))
		return true;
	program_keep_line(&interp->program, &interp->at);
	if (!line_search_run(&lines, source == interp->program.start.source ? &interp->program.start : &first))
		return lines.unfinished && line_search_refuse_pipe(&interp->at, column, title);
	return !lines.count && labels_add(&klartext_of(interp)->calls.labels, key, LABEL_FOUND);
}

const struct label *klartext_label_find(struct interp *interp, const char *name, int column)
{
	char key[KEY], title[KLARTEXT_NAME + 8];
	const struct label *label;

	if (!strcmp(name, "0")) {
		fault_report(&interp->at, column, "LBL 0 ends subprograms: nothing can call it or jump there");
		return NULL;
	}
	snprintf(title, sizeof(title), "LBL %s", name);
	if (!scan_labels(interp, title, column))
		return NULL;
	make_key(key, &interp->program.sources, interp->program.source, name);
	label = labels_find(&klartext_of(interp)->calls.labels, key);
	if (!label)
		fault_report(&interp->at, column, "the program has no %s", title);
	else if (label->kind == LABEL_TWICE)
		line_search_refuse(&interp->at, column, title, &label->at, &label->body);
	return label && label->kind == LABEL_FOUND ? label : NULL;
}

static bool is_end(struct interp *interp, const char *text)
{
	char name[KLARTEXT_NAME];

	return name_of_line(interp, text, true, name) && !strcmp(name, "0");
}

bool klartext_label_read_section(struct interp *interp, const char *name, int column, klartext_label_line line,
				 void *context)
{
	struct reader *reader = &interp->program.source->reader;
	const struct position next = source_next(interp->program.source);
	const struct label *label = klartext_label_find(interp, name, column);
	const long furthest = reader->furthest;
	const char *text;
	bool good, ended = false;

	if (!label)
		return false;
	program_keep_line(&interp->program, &interp->at);
	good = program_jump(&interp->program, &label->body, &interp->at, column);
	while (good && !ended && reader_next(reader, &text) == READER_LINE) {
		const struct line_place at = {
		    .diag = interp->diag, .file = interp->at.file, .line = reader->line, .text = text};
		struct lexer lexer = klartext_lexer(interp);

		lexer.at = &at;
		ended = is_end(interp, text);
		good = ended || line(context, &lexer);
	}
	reader->furthest = furthest;
	if (good && !ended)
		good = fault(&interp->at, column, "LBL %s has no LBL 0 that ends it", name);
	return program_jump(&interp->program, &next, &interp->at, column) && good;
}
