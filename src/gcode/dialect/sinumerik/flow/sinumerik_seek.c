#include "gcode/dialect/sinumerik/flow/sinumerik_seek.h"

#include <stdlib.h>
#include <string.h>

#include "base/ascii.h"
#include "gcode/dialect/sinumerik/flow/sinumerik_ahead.h"
#include "gcode/program.h"
#include "gcode/text/line_search.h"

/* Copies a name of digits, letters and '_' in upper case; a name that is too long becomes empty. */
static size_t copy_name(const char *text, size_t at, char name[SINUMERIK_NAME + 1])
{
	size_t length = 0;

	for (; sinumerik_is_name(text[at]); at++, length++) {
		if (length < SINUMERIK_NAME)
			name[length] = ascii_upper(text[at]);
	}
	name[length <= SINUMERIK_NAME ? length : 0] = '\0';
	return at;
}

struct sinumerik_head sinumerik_seek_head(const char *text)
{
	struct sinumerik_head head = {.rest = sinumerik_skip_blanks(text, 0)};
	char name[SINUMERIK_NAME + 1];
	size_t at;

	if (text[head.rest] == '/') {
		head.skipped = true;
		head.rest = sinumerik_skip_blanks(text, head.rest + 1 + ascii_is_digit(text[head.rest + 1]));
	}
	if ((ascii_upper(text[head.rest]) == 'N' || text[head.rest] == ':') && ascii_is_digit(text[head.rest + 1])) {
		size_t length = 0;

		head.number[length++] = ascii_upper(text[head.rest]);
		for (at = head.rest + 1; ascii_is_digit(text[at]); at++) {
			if (length < SINUMERIK_NAME)
				head.number[length++] = text[at];
		}
		head.rest = sinumerik_skip_blanks(text, at);
	}
	if (!sinumerik_starts_name(text[head.rest]))
		return head;
	at = sinumerik_skip_blanks(text, copy_name(text, head.rest, name));
	if (text[at] == ':' && text[at + 1] != '=' && name[0]) {
		strcpy(head.label, name);
		head.rest = sinumerik_skip_blanks(text, at + 1);
	}
	return head;
}

static bool is_word(const char *text, size_t at, const char *word)
{
	const size_t length = strlen(word);

	for (size_t i = 0; i < length; i++) {
		if (ascii_upper(text[at + i]) != word[i])
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
	return text[sinumerik_skip_blanks(text, 0)] == '%';
}

/* Reads the upper-case name in a head and returns its type, 'M' or 'S'; 0: the line is no head, or it has no type. */
static char read_head(const char *text, char name[SINUMERIK_NAME + 1])
{
	size_t at, length;
	char *end;

	name[0] = '\0';
	if (!is_head(text))
		return '\0';
	at = sinumerik_skip_blanks(text, sinumerik_skip_blanks(text, 0) + 1);
	if (text[at] == '_' && ascii_upper(text[at + 1]) == 'N' && text[at + 2] == '_')
		at += 3;
	copy_name(text, at, name);
	length = strlen(name);
	end = name + (length > 4 ? length - 4 : length);
	if (strcmp(end, "_SPF") != 0 && strcmp(end, "_MPF") != 0)
		return '\0';
	*end = '\0';
	return end[1];
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

/* Searches for the name, or for what it describes, from this line on. False: reported, or cancelled. */
static bool search_lines(struct interp *interp, struct line_search *lines, const char *name,
			 const struct position *from, int column)
{
	program_keep_line(&interp->program, &interp->at);
	lines->cancel = interp->config->read.cancel;
	return line_search_run(lines, from) ||
	       (lines->unfinished && line_search_refuse_pipe(&interp->at, column, name));
}

struct search {
	const char *name;	/* of a label, a block number, or a program */
	bool program;	/* heads of programs in the whole file; else labels and numbers of one program */
	char type;	/* of the program: 'M', 'S', or 0 */
	bool other_zeros;	/* a block was found whose number has other leading zeros */
	struct line_search lines;
};

/* A block number, N100 or :100; labels do not begin like this. */
static bool is_number(const char *name)
{
	return (name[0] == 'N' || name[0] == ':') && ascii_is_digit(name[1]);
}

/* The same number with other leading zeros? `number` may be empty. */
static bool is_same_number(const char *number, const char *name)
{
	return number[0] == name[0] && is_number(name) &&
	       !strcmp(number + 1 + strspn(number + 1, "0"), name + 1 + strspn(name + 1, "0"));
}

static enum line_sought judge_line(void *context, const char *text, long line)
{
	struct search *search = context;
	struct sinumerik_head head;

	(void)line;
	if (search->program) {
		char name[SINUMERIK_NAME + 1], type = read_head(text, name);

		return !strcmp(name, search->name) && (!type || !search->type || type == search->type) ? LINE_SOUGHT
											      : LINE_OTHER;
	}
	if (!search->lines.last && is_head(text))
		return LINE_BEHIND;
	head = sinumerik_seek_head(text);
	if (!strcmp(head.label, search->name) || !strcmp(head.number, search->name))
		return LINE_SOUGHT;
	if (!is_same_number(head.number, search->name))
		return LINE_OTHER;
	search->other_zeros = true;
	return LINE_SOUGHT;
}

static bool look_for(struct interp *interp, struct search *search, const struct position *from, int column)
{
	search->lines.judge = judge_line;
	search->lines.context = search;
	return search_lines(interp, &search->lines, search->name, from, column);
}

/* Takes the only match. */
static bool take_only_match(struct interp *interp, const struct search *search, int column, struct position *to,
			    bool *found)
{
	*found = search->lines.count > 0;
	*to = search->lines.first;
	if (search->lines.count == 1 && search->other_zeros)
		return fault(&interp->at, column, "%s has other leading zeros in line %ld: write both alike",
			     search->name, to->line);
	return search->lines.count <= 1 ||
	       line_search_refuse(&interp->at, column, search->name, to, &search->lines.second);
}

static enum line_sought note_label(void *context, const char *text, long line)
{
	const struct sinumerik_head head = sinumerik_seek_head(text);
	struct sinumerik_search *search = context;
	struct label *label = labels_find(&search->labels, head.label);

	(void)line;
	if (label)
		label->kind++;
	else if (head.label[0])
		labels_add(&search->labels, head.label, 0);
	if (head.number[0]) {
		const long number = strtol(head.number + 1, NULL, 10);

		search->numbers_repeat |= number <= search->last_number;
		search->last_number = number;
	}
	return LINE_OTHER;
}

/*
 * Has the file no second label or block number of this name from the next line on? Otherwise, and where this is not
 * known, the rest of the program has to be searched. The labels are read once: a program may have many jumps.
 */
static bool is_only(struct interp *interp, const char *name, const struct position *next)
{
	struct sinumerik_search *search = &sinumerik_of(interp)->search;
	struct line_search lines = {
	    .judge = note_label, .context = search, .cancel = interp->config->read.cancel, .most = 1};
	const struct label *label;

	if (search->labelled != next->source || next->offset < search->labelled_from) {
		labels_release(&search->labels);
		search->labelled = NULL;
		search->last_number = -1;
		search->numbers_repeat = false;
		if (!line_search_run(&lines, next))
			return false;
		search->labelled = next->source;
		search->labelled_from = next->offset;
	}
	if (is_number(name))
		return !search->numbers_repeat;
	label = labels_find(&search->labels, name);
	return label && label->kind == 0;
}

bool sinumerik_seek_label(struct interp *interp, const char *name, enum sinumerik_direction direction, int column,
			  struct position *to, bool *found)
{
	const struct position next = source_next(interp->program.source), top = sinumerik_seek_top(interp);
	const long long from = interp->program.source->reader.start;
	struct search search = {.name = name};
	char key[SINUMERIK_NAME + 2];

	key[0] = (char)('0' + direction);
	strcpy(key + 1, name);
	*found = true;
	if (recall(interp, key, from, to))
		return true;
	program_keep_line(&interp->program, &interp->at);
	if (direction != SINUMERIK_BACKWARD) {
		search.lines.most = is_only(interp, name, &next) ? 1 : 2;
		if (!look_for(interp, &search, &next, column))
			return false;
	}
	search.lines.most = 2;
	search.lines.last = interp->at.line;
	if (!search.lines.count && direction != SINUMERIK_FORWARD && !look_for(interp, &search, &top, column))
		return false;
	if (!take_only_match(interp, &search, column, to, found))
		return false;
	if (*found)
		remember(interp, key, from, to);
	return true;
}

bool sinumerik_seek_label_behind(struct interp *interp, const char *name, const struct position *start, long last,
				 bool only, int column, struct position *to, bool *found)
{
	struct search search = {.name = name, .lines = {.last = last, .most = only ? 2 : 1}};

	return look_for(interp, &search, start, column) && take_only_match(interp, &search, column, to, found);
}

bool sinumerik_seek_program(struct interp *interp, struct source *source, const char *name, char type, int column,
			    struct position *head, bool *found)
{
	const struct position top = {source, 0, 1};
	struct search search = {.name = name, .program = true, .type = type, .lines = {.most = 2}};

	return look_for(interp, &search, &top, column) && take_only_match(interp, &search, column, head, found);
}

bool sinumerik_seek_heads_main(const char *text)
{
	char name[SINUMERIK_NAME + 1];

	return read_head(text, name) == 'M';
}

static enum line_sought judge_main(void *context, const char *text, long line)
{
	(void)context;
	(void)line;
	return sinumerik_seek_heads_main(text) ? LINE_SOUGHT : LINE_OTHER;
}

bool sinumerik_seek_main(struct interp *interp)
{
	const struct position next = source_next(interp->program.source);
	struct line_search lines = {.judge = judge_main, .most = 1};
	char name[SINUMERIK_NAME + 1];

	if (read_head(line_start(&interp->at), name) != 'S')
		return true;
	if (!search_lines(interp, &lines, "the main program", &next, 1))
		return false;
	if (!lines.count)
		return true;
	interp->program.start = lines.behind;
	return program_jump(&interp->program, &lines.behind, &interp->at, 1);
}

static enum line_sought judge_change(void *context, const char *text, long line)
{
	const enum sinumerik_ahead ahead = sinumerik_ahead_of_line(text + sinumerik_seek_head(text).rest);

	(void)context;
	(void)line;
	if (is_head(text))
		return LINE_BEHIND;
	return ahead == SINUMERIK_AHEAD_CHANGE    ? LINE_SOUGHT
	       : ahead == SINUMERIK_AHEAD_NOTHING ? LINE_OTHER
						  : LINE_BEHIND;
}

bool sinumerik_seek_tool_change(struct interp *interp, int column, bool *found)
{
	const struct position next = source_next(interp->program.source);
	struct line_search lines = {.judge = judge_change, .most = 1};
	const bool good = search_lines(interp, &lines, "M6", &next, column);

	*found = lines.count > 0;
	return good;
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
	at = sinumerik_skip_blanks(words, strlen(structure->open));
	if (structure == &structures[SINUMERIK_UNTIL])
		return !sinumerik_starts_name(words[at]);
	return structure->open[0] != 'I' || !has_jump(words);
}

struct close_search {
	enum sinumerik_close close;
	int depth;	/* 0: the line that opens the structure has not been read */
};

static enum line_sought judge_close(void *context, const char *text, long line)
{
	struct close_search *search = context;
	const char *words = text + sinumerik_seek_head(text).rest;
	const struct structure *structure = &structures[search->close];

	(void)line;
	if (search->depth == 0) {
		search->depth++;
		return LINE_OTHER;
	}
	if (is_head(text))
		return LINE_BEHIND;
	if (opens(words, structure))
		search->depth++;
	else if (is_word(words, 0, structure->close))
		search->depth--;
	else if (search->close == SINUMERIK_ELSE && search->depth == 1 && is_word(words, 0, "ELSE"))
		search->depth = 0;
	return search->depth ? LINE_OTHER : LINE_SOUGHT;
}

bool sinumerik_seek_close_of(struct interp *interp, enum sinumerik_close close, const struct position *start,
			     int column, struct position *behind)
{
	const char *key = close == SINUMERIK_ELSE ? "ELSE" : structures[close].close;
	struct close_search search = {.close = close};
	struct line_search lines = {.judge = judge_close, .context = &search, .most = 1};

	if (recall(interp, key, start->offset, behind))
		return true;
	if (!search_lines(interp, &lines, key, start, column))
		return false;
	if (!lines.count)
		return fault(&interp->at, column, "%s in line %ld has no %s", structures[close].open, start->line,
			     structures[close].close);
	*behind = lines.behind;
	remember(interp, key, start->offset, behind);
	return true;
}

bool sinumerik_seek_close(struct interp *interp, enum sinumerik_close close, int column, struct position *behind)
{
	const struct position here = source_here(interp->program.source);

	return sinumerik_seek_close_of(interp, close, &here, column, behind);
}
