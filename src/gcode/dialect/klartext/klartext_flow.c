#include "gcode/dialect/klartext/klartext_flow.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

#include "base/same_double.h"
#include "gcode/dialect/klartext/klartext_builder_cycle.h"
#include "gcode/dialect/klartext/klartext_comp.h"
#include "gcode/dialect/klartext/klartext_folder.h"
#include "gcode/dialect/klartext/klartext_formula.h"
#include "gcode/dialect/klartext/klartext_lexis.h"
#include "gcode/dialect/klartext/klartext_rest.h"
#include "gcode/dialect/klartext/klartext_skip.h"
#include "gcode/dialect/klartext/klartext_string.h"
#include "gcode/dialect/klartext/klartext_value.h"
#include "gcode/execute/motion_commands.h"
#include "gcode/text/line_search.h"

/* Bytes of the key of a label, which consists of its source and its name. */
#define KEY (KLARTEXT_NAME + 24)

enum { LABEL_FOUND, LABEL_TWICE };	/* twice: `body` is the line of the second one */

/* ------------------------------------------------------------------ labels */

/* A label's name: digits or a text in quotes. Leading zeros of a number do not count. */
static bool read_label(struct lexer *lexer, char name[KLARTEXT_NAME])
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

/* Reads the name after "LBL". False: the line has no label. */
static bool label_of_line(struct interp *interp, const char *text, char name[KLARTEXT_NAME])
{
	struct diag unheard = {0};
	const struct line_place at = {.diag = &unheard, .file = "", .text = text};
	struct lexer lexer = klartext_lexer(interp);
	bool slash;

	lexer.at = &at;
	klartext_skip_head(&lexer, &slash);
	return !(slash && interp->config->read.block_delete) && klartext_take(&lexer, "LBL") &&
	       lexer_peek(&lexer) != 'Q' && read_label(&lexer, name) && strcmp(name, "0") != 0;
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

/* Copies the text of the current line, because the reader will overwrite it. */
static void keep_line(struct interp *interp)
{
	struct klartext_lines *lines = &klartext_of(interp)->lines;

	if (interp->at.text == lines->text.text)
		return;
	strbuf_clear(&lines->text);
	strbuf_addf(&lines->text, "%s", interp->at.text);
	interp->at.text = strbuf_text(&lines->text);
}

static enum line_sought note_label(void *interp, const char *text, long line)
{
	char name[KLARTEXT_NAME];

	(void)line;
	return label_of_line(interp, text, name) && !add_label(interp, name) ? LINE_SOUGHT : LINE_OTHER;
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
	keep_line(interp);
	if (!line_search_run(&lines, source == interp->program.start.source ? &interp->program.start : &first))
		return lines.unfinished && line_search_refuse_pipe(&interp->at, column, title);
	return !lines.count && labels_add(&klartext_of(interp)->calls.labels, key, LABEL_FOUND);
}

static struct label *find_label(struct interp *interp, const char *name, int column)
{
	char key[KEY], title[KLARTEXT_NAME + 8];
	struct label *label;

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

/* Is it "LBL 0"? */
static bool ends_label(struct interp *interp, const char *text)
{
	struct diag unheard = {0};
	const struct line_place at = {.diag = &unheard, .file = "", .text = text};
	struct lexer lexer = klartext_lexer(interp);
	char name[KLARTEXT_NAME];
	bool slash;

	lexer.at = &at;
	klartext_skip_head(&lexer, &slash);
	return !(slash && interp->config->read.block_delete) && klartext_take(&lexer, "LBL") &&
	       read_label(&lexer, name) && !strcmp(name, "0");
}

bool klartext_flow_read_label(struct interp *interp, const char *name, int column, klartext_flow_line line,
			      void *context)
{
	struct reader *reader = &interp->program.source->reader;
	const struct position next = source_next(interp->program.source);
	const struct label *label = find_label(interp, name, column);
	const long furthest = reader->furthest;
	const char *text;
	bool good, ended = false;

	if (!label)
		return false;
	keep_line(interp);
	good = program_jump(&interp->program, &label->body, &interp->at, column);
	while (good && !ended && reader_next(reader, &text) == READER_LINE) {
		const struct line_place at = {
		    .diag = interp->diag, .file = interp->at.file, .line = reader->line, .text = text};
		struct lexer lexer = klartext_lexer(interp);

		lexer.at = &at;
		ended = ends_label(interp, text);
		good = ended || line(context, &lexer);
	}
	reader->furthest = furthest;
	if (good && !ended)
		good = fault(&interp->at, column, "LBL %s has no LBL 0 that ends it", name);
	return program_jump(&interp->program, &next, &interp->at, column) && good;
}

/* ------------------------------------------------------------------- levels */

static bool enter(struct interp *interp, enum klartext_call_kind kind, const char *title, const struct position *to,
		  int column)
{
	struct klartext *klartext = klartext_of(interp);
	struct klartext_call *call;
	const struct position back = source_next(interp->program.source);

	if (klartext->calls.level == KLARTEXT_CALLS_MAX)
		return fault(&interp->at, column, "more than %d calls inside each other", KLARTEXT_CALLS_MAX);
	call = &klartext->calls.items[++klartext->calls.level];
	*call = (struct klartext_call){
	    .kind = kind, .back = back, .file = interp->at.file, .line = interp->at.line, .column = column};
	snprintf(call->title, sizeof(call->title), "%s", title);
	klartext->calls.jumped = true;
	if (kind == KLARTEXT_PROGRAM) {
		klartext->calls.programs++;
		memset(klartext->values.ql[klartext->calls.programs], 0, sizeof(klartext->values.ql[0]));
	}
	return program_jump(&interp->program, to, &interp->at, column);
}

static bool leave(struct interp *interp, int column)
{
	struct klartext_calls *calls = &klartext_of(interp)->calls;
	const struct klartext_call *call = &calls->items[calls->level--];

	calls->programs -= call->kind == KLARTEXT_PROGRAM;
	while (calls->repeat_count && calls->repeats[calls->repeat_count - 1].level > calls->level)
		calls->repeat_count--;
	return program_jump(&interp->program, &call->back, &interp->at, column);
}

bool klartext_flow_label(struct lexer *lexer)
{
	struct interp *interp = lexer->context;
	const struct klartext_calls *calls = &klartext_of(interp)->calls;
	int column = klartext_column(lexer);
	char name[KLARTEXT_NAME];

	if (!read_label(lexer, name) || !klartext_expect_end(lexer))
		return false;
	if (strcmp(name, "0") != 0 || calls->level == 0 || calls->items[calls->level].kind != KLARTEXT_LABEL)
		return true;
	return leave(interp, column);
}

/* ------------------------------------------------------------------- CALL */

static bool same_place(const struct position *a, const struct position *b)
{
	return a->source == b->source && a->offset == b->offset;
}

/*
 * "Program section repeats": CALL LBL n REP m runs the section from the label to the call m more times. The manuals do
 * not say what REP does if the label is behind the call.
 */
static bool repeat(struct interp *interp, const struct position here, const struct label *label, int count, int column)
{
	struct klartext_calls *calls = &klartext_of(interp)->calls;
	struct klartext_repeat *item = NULL;

	if (label->at.source == here.source && label->at.offset > here.offset)
		return fault(&interp->at, column,
			     "REP repeats the section from the label to this block, but the label stands behind it: a "
			     "subprogram is called without REP, once for each time that it runs");
	for (int i = 0; i < calls->repeat_count; i++) {
		if (calls->repeats[i].level == calls->level && same_place(&calls->repeats[i].at, &here))
			item = &calls->repeats[i];
	}
	if (!item && calls->repeat_count == KLARTEXT_REPEATS_MAX)
		return fault(&interp->at, column, "more than %d program section repeats at a time",
			     KLARTEXT_REPEATS_MAX);
	if (!item) {
		item = &calls->repeats[calls->repeat_count++];
		*item = (struct klartext_repeat){
		    .at = here, .level = calls->level, .left = count, .start = label->at.offset};
	}
	if (item->left_by_jump)
		return fault(&interp->at, column,
			     "a jump has left this program section before its repeats were done: whether they are "
			     "counted anew is "
			     "not known here");
	if (item->left == 0) {
		*item = calls->repeats[--calls->repeat_count];
		return true;
	}
	item->left--;
	calls->jumped = true;
	return program_jump(&interp->program, &label->body, &interp->at, column);
}

static bool call_label(struct lexer *lexer)
{
	struct interp *interp = lexer->context;
	/* Taken before the search for labels moves the reader. */
	const struct position here = source_here(interp->program.source);
	int column = klartext_column(lexer), count = 0;
	char name[KLARTEXT_NAME], title[KLARTEXT_NAME + 8];
	const struct label *label;
	bool repeats;

	if (!read_label(lexer, name))
		return false;
	repeats = klartext_take(lexer, "REP");
	if (repeats) {
		/* Older controls list "REP 5/5"; the second number is the count of repeats that are left. */
		if (!klartext_integer(lexer, "REP", 0, 65534, &count))
			return false;
		if (lexer_peek(lexer) == '/') {
			int left;

			lexer_take(lexer);
			if (!klartext_integer(lexer, "REP", 0, 65534, &left))
				return false;
		}
	}
	if (!klartext_expect_end(lexer) || !(label = find_label(interp, name, column)))
		return false;
	if (repeats)
		return repeat(interp, here, label, count, column);
	snprintf(title, sizeof(title), "LBL %s", name);
	return enter(interp, KLARTEXT_LABEL, title, &label->body, column);
}

bool klartext_flow_call_program(struct interp *interp, const char *name, int column)
{
	static const char *const endings[] = {"", ".h", ".H"};
	struct source *source;
	struct position start = {.line = 1};

	if (klartext_comp_is_selected(interp))
		return fault(&interp->at, column,
			     "CALL PGM under radius compensation is not supported; R0 comes first");
	if (!klartext_folder_find(interp, name, endings, column, &source))
		return false;
	if (!source)
		return klartext_builder_program_run(interp, name, column);
	start.source = source;
	return enter(interp, KLARTEXT_PROGRAM, source->name, &start, column);
}

static bool call_program(struct lexer *lexer)
{
	int column = klartext_column(lexer);
	char name[KLARTEXT_NAME];

	return klartext_string_name(lexer, "a program's name", name) && klartext_expect_end(lexer) &&
	       klartext_flow_call_program(lexer->context, name, column);
}

/* "SEL PGM" names the program that "CALL SELECTED PGM" calls. */
bool klartext_flow_select(struct lexer *lexer)
{
	struct interp *interp = lexer->context;

	if (!klartext_take(lexer, "PGM"))
		return fault(lexer->at, 1, "SEL other than SEL PGM, SEL TABLE and SEL PATTERN is not supported");
	return klartext_string_name(lexer, "a program's name", klartext_of(interp)->calls.selected) &&
	       klartext_expect_end(lexer);
}

static bool call_selected(struct lexer *lexer)
{
	struct interp *interp = lexer->context;
	int column = klartext_column(lexer);

	if (!klartext_take(lexer, "PGM") || !klartext_expect_end(lexer))
		return fault(lexer->at, column, "CALL SELECTED needs PGM");
	return klartext_of(interp)->calls.selected[0] != '\0'
		   ? klartext_flow_call_program(interp, klartext_of(interp)->calls.selected, column)
		   : fault(lexer->at, column, "CALL SELECTED PGM, but no SEL PGM has named a program");
}

bool klartext_flow_call(struct lexer *lexer)
{
	if (klartext_take(lexer, "LBL"))
		return call_label(lexer);
	if (klartext_take(lexer, "PGM"))
		return call_program(lexer);
	if (klartext_take(lexer, "SELECTED"))
		return call_selected(lexer);
	return fault(lexer->at, klartext_column(lexer), "CALL needs LBL or PGM");
}

/* ------------------------------------------------------------------- jumps */

/* Notes which program section repeats the jump leaves unfinished. */
static void leave_sections(struct klartext *klartext, const struct position *to)
{
	for (int i = 0; i < klartext->calls.repeat_count; i++) {
		struct klartext_repeat *item = &klartext->calls.repeats[i];
		bool inside =
		    to->source == item->at.source && to->offset >= item->start && to->offset <= item->at.offset;

		if (item->level == klartext->calls.level && !inside)
			item->left_by_jump = true;
	}
}

bool klartext_flow_jump(struct lexer *lexer, int number)
{
	struct interp *interp = lexer->context;
	char name[KLARTEXT_NAME];
	bool holds;
	int column;
	const struct label *label;

	if (!klartext_formula_condition(lexer, number, &holds))
		return false;
	if (!klartext_take(lexer, "GOTO") || !klartext_take(lexer, "LBL"))
		return fault(lexer->at, klartext_column(lexer), "FN %d needs GOTO LBL here", number);
	column = klartext_column(lexer);
	if (!read_label(lexer, name) || !klartext_expect_end(lexer))
		return false;
	if (!holds)
		return true;
	label = find_label(interp, name, column);
	if (!label)
		return false;
	klartext_of(interp)->calls.jumped = true;
	leave_sections(klartext_of(interp), &label->at);
	return program_jump(&interp->program, &label->body, &interp->at, column);
}

/* -------------------------------------------------------------------- ends */

bool klartext_flow_end(struct lexer *lexer)
{
	struct interp *interp = lexer->context;
	struct klartext *klartext = klartext_of(interp);
	const struct klartext_call *call = &klartext->calls.items[klartext->calls.level];

	if (klartext->lines.behind_end || klartext->calls.level == 0) {
		interp->ended = true;
		return klartext_comp_end(interp, 1) && motion_commands_spindle_stops(interp) &&
		       klartext_rest_check(interp);
	}
	if (call->kind == KLARTEXT_LABEL)
		return fault(lexer->at, 1, "the program ends inside of the subprogram %s: its LBL 0 is missing",
			     call->title);
	return leave(interp, 1);
}

bool klartext_flow_end_of_file(struct interp *interp)
{
	const struct klartext *klartext = klartext_of(interp);
	const struct srcloc loc = {interp->program.source->name, interp->program.source->reader.line, 0};

	if (klartext->lines.behind_end) {
		interp->ended = true;
		return true;
	}
	if (!klartext->lines.begun && klartext->calls.level == 0)
		return true;
	diag_error(interp->diag, loc, "the file ends without END PGM: is it complete?");
	return false;
}

_Static_assert(KLARTEXT_CALLS_MAX <= CALLS_MAX, "every call has its place in a chain");

bool klartext_flow_caller(const struct interp *interp, size_t level, struct srcloc *at, struct strbuf *title)
{
	const struct klartext_calls *calls = &klartext_of(interp)->calls;
	const struct klartext_call *call;

	if ((size_t)calls->level <= level)
		return false;
	call = &calls->items[calls->level - (int)level];
	*at = (struct srcloc){call->file, call->line, call->column};
	if (title)
		strbuf_addf(title, "%s", call->title);
	return true;
}
