#include "gcode/dialect/fanuc/macro_b_seek.h"

#include <stdio.h>
#include <string.h>

#include "base/ascii.h"
#include "gcode/dialect/fanuc/macro_b_state.h"
#include "gcode/dialect/fanuc/program_files.h"
#include "gcode/text/line_search.h"

/* The start of a line for searches: without blanks and comments, in capitals. */
#define GIST_MAX 256

struct gist {
	bool percent;
	bool has_program, has_block;
	long program, block;	/* O and N */
	char rest[GIST_MAX];	/* the text after them */
};

/* The target of a search. */
enum aim { AIM_BLOCK, AIM_PROGRAM, AIM_ANY_PROGRAM, AIM_END };

struct search {
	enum aim aim;
	long number;
	long after;	/* AIM_PROGRAM, AIM_BLOCK: lines up to this one are ignored */
	int open[MACRO_B_LOOPS];	/* AIM_END: the loops in between */
	int open_count;
	bool own_line;	/* the search starts at the program's first line, which has the program's number */
	bool failed;	/* reported */
	bool unfinished;	/* a pipe's window ended the search */
};

/* ------------------------------------------------------------------- lines */

static long take_digits(const char **at)
{
	long value = 0;

	for (; ascii_is_digit(**at); ++*at)
		value = value < 100000000 ? value * 10 + (**at - '0') : value;
	return value;
}

static void condense(const char *text, char *out)
{
	size_t length = 0;

	for (; *text && *text != ';' && length < GIST_MAX - 1; text++) {
		if (*text == '(') {
			text += strcspn(text, ")");
			if (*text == '\0')
				break;
		} else if (*text != ' ' && *text != '\t') {
			out[length++] = ascii_upper(*text);
		}
	}
	out[length] = '\0';
}

static void read_gist(const char *text, enum colon colon, struct gist *gist)
{
	char buffer[GIST_MAX] = "";
	const char *at = buffer;

	condense(text, buffer);
	*gist = (struct gist){.percent = *at == '%'};
	if (*at == '/')
		at += ascii_is_digit(at[1]) ? 2 : 1;
	if ((*at == 'O' || (*at == ':' && colon != COLON_BLOCK)) && ascii_is_digit(at[1])) {
		at++;
		gist->has_program = true;
		gist->program = take_digits(&at);
	}
	if ((*at == 'N' || *at == ':') && ascii_is_digit(at[1])) {
		at++;
		gist->has_block = true;
		gist->block = take_digits(&at);
	}
	snprintf(gist->rest, sizeof(gist->rest), "%s", at);
}

/* May a search look for the line? For most lines the first byte excludes this. */
static bool may_matter(const char *text)
{
	text += strspn(text, " \t");
	return *text && strchr("NnOo:%/(WwDdEe", *text);
}

/* The number of the line's DO or END, or 0. */
static int loop_number(const char *rest, bool end)
{
	const char *at = rest;

	if (end)
		return !strncmp(rest, "EN", 2) && ascii_is_digit(rest[rest[2] == 'D' ? 3 : 2])
			   ? rest[rest[2] == 'D' ? 3 : 2] - '0'
			   : 0;
	if (!strncmp(rest, "WHILE[", 6) || !strncmp(rest, "WH[", 3)) {
		at = strrchr(rest, ']');
		at = at ? at + 1 : rest;
	}
	return !strncmp(at, "DO", 2) && ascii_is_digit(at[2]) ? at[2] - '0' : 0;
}

/* ------------------------------------------------------------------ a search */

/* The loops of B-63944EN, nesting: up to three nested loops, which do not cross. */
static bool meet_loop(struct interp *interp, struct search *search, const struct gist *gist, long line, int column)
{
	int opens = loop_number(gist->rest, false), closes = loop_number(gist->rest, true);

	if (opens > 0) {
		for (int i = 0; i < search->open_count; i++) {
			if (search->open[i] != opens)
				continue;
			search->failed = true;
			return fault(&interp->at, column,
				     "line %ld has DO%d inside this loop, which is also DO%d", line, opens,
				     opens);
		}
		if (search->open_count < MACRO_B_LOOPS && opens <= MACRO_B_LOOPS)
			search->open[search->open_count++] = opens;
		return false;
	}
	if (closes == 0)
		return false;
	if (search->open[search->open_count - 1] != closes) {
		search->failed = true;
		return fault(&interp->at, column, "END%d in line %ld crosses this loop: DO%d is still open there",
			     closes, line, search->open[search->open_count - 1]);
	}
	return --search->open_count == 0;
}

static bool meets(struct interp *interp, struct search *search, const char *text, long line, int column, bool *over)
{
	struct gist gist;

	*over = false;
	if (!may_matter(text))
		return false;
	read_gist(text, interp->config->controller.colon, &gist);
	if (search->aim == AIM_PROGRAM || search->aim == AIM_ANY_PROGRAM)
		return gist.has_program && line > search->after &&
		       (search->aim == AIM_ANY_PROGRAM || gist.program == search->number);
	*over = gist.percent || gist.has_program;
	if (search->aim == AIM_BLOCK)
		return gist.has_block && gist.block == search->number && line > search->after;
	if (*over || (*gist.rest && text[strspn(text, " \t")] == '/' && interp->config->read.block_delete))
		return false;
	return meet_loop(interp, search, &gist, line, column);
}

/* A line of a search. */
struct judged {
	struct interp *interp;
	struct search *search;
	int column;
	bool first;	/* no line that matters has been met */
};

static enum line_sought judge_line(void *context, const char *text, long line)
{
	struct judged *judged = context;
	bool over, met = meets(judged->interp, judged->search, text, line, judged->column, &over);

	/* The program's own first line is not that of the next program. */
	over = over && !judged->first;
	judged->first = judged->first && !may_matter(text);
	if (over || judged->search->failed)
		return LINE_BEHIND;
	return met ? LINE_SOUGHT : LINE_OTHER;
}

/*
 * Finds the first line of the search's target from `from` up to the line `to` (0: the end of the program, or of the
 * file). The position of the reader does not change.
 */
static bool search_lines(struct interp *interp, struct search *search, const struct position *from, long to, int column,
			 struct position *found)
{
	struct judged judged = {interp, search, column, search->own_line};
	struct line_search lines = {.judge = judge_line, .context = &judged, .last = to, .most = 1};

	program_keep_line(&interp->program, &interp->at);
	line_search_run(&lines, from);
	search->unfinished |= lines.unfinished;
	if (lines.count)
		*found = lines.first;
	return lines.count > 0;
}

/* ------------------------------------------------------------ what was found */

/* The search for the end of a loop is made only once: its result depends only on the file. */
static struct label *remembered(struct interp *interp, const struct position *from, const char *what, long number,
				char *key)
{
	snprintf(key, 96, "%p %lld %s%ld", (void *)from->source, from->offset, what, number);
	return labels_find(&macro_b_of(interp)->found, key);
}

static void remember(struct interp *interp, const char *key, const struct position *found)
{
	struct label *label = labels_add(&macro_b_of(interp)->found, key, 0);

	/* If the list is full, the next jump searches again. */
	if (label)
		label->at = *found;
}

static bool fault_window(struct interp *interp, const char *what, int number, int column)
{
	char name[24];

	snprintf(name, sizeof(name), "%.8s%d", what, number);
	line_search_refuse_pipe(&interp->at, column, name);
	return false;
}

static struct position program_start(struct interp *interp)
{
	const struct macro_b_call *call = macro_b_call_in_hand(interp);

	if (call->program.source)
		return call->program;
	return (struct position)interp->program.start;
}

bool macro_b_seek_only(struct interp *interp, int number, int column, struct position *found)
{
	const struct position start = program_start(interp);
	struct search search = {.aim = AIM_BLOCK, .number = number, .own_line = true};
	struct position second;
	struct label *label;
	char key[96];

	if ((label = remembered(interp, &start, "only N", number, key))) {
		*found = label->at;
		return true;
	}
	if (!search_lines(interp, &search, &start, 0, column, found))
		return search.unfinished ? fault_window(interp, "N", number, column)
					 : fault(&interp->at, column, "the program has no block N%d", number);
	search.after = found->line;
	if (search_lines(interp, &search, &start, 0, column, &second))
		return fault(&interp->at, column, "N%d occurs in lines %ld and %ld, so the jump is ambiguous",
			     number, found->line, second.line);
	if (search.unfinished)
		return fault_window(interp, "N", number, column);
	remember(interp, key, found);
	return true;
}

static bool seek_forward_first(struct interp *interp, int number, int column, struct position *found)
{
	const struct position next = source_next(interp->program.source), start = program_start(interp);
	struct search search = {.aim = AIM_BLOCK, .number = number};
	long here = interp->at.line;

	if (search_lines(interp, &search, &next, 0, column, found))
		return true;
	search.own_line = true;
	if (!search.unfinished && search_lines(interp, &search, &start, here, column, found))
		return true;
	return search.unfinished ? fault_window(interp, "N", number, column)
				 : fault(&interp->at, column, "the program has no block N%d", number);
}

bool macro_b_seek_goto(struct interp *interp, int number, int column)
{
	const struct position here = source_here(interp->program.source);
	struct position target;
	struct label *label;
	char key[96];

	macro_b_of(interp)->jumped = true;
	if (number == 0)
		return fault(&interp->at, column, "block numbers start at 1");
	if (!macro_b_of(interp)->rules->goto_forward_first)
		return macro_b_seek_only(interp, number, column, &target) && macro_b_seek_jump(interp, &target, column);
	if ((label = remembered(interp, &here, "N", number, key)))
		return macro_b_seek_jump(interp, &label->at, column);
	if (!seek_forward_first(interp, number, column, &target))
		return false;
	remember(interp, key, &target);
	return macro_b_seek_jump(interp, &target, column);
}

bool macro_b_seek_end(struct interp *interp, int number, int column, struct position *found)
{
	const struct position here = source_here(interp->program.source), next = source_next(interp->program.source);
	struct search search = {.aim = AIM_END, .number = number, .open = {number}, .open_count = 1};
	struct label *label;
	char key[96];

	if ((label = remembered(interp, &here, "END", number, key))) {
		*found = label->at;
		return true;
	}
	if (!search_lines(interp, &search, &next, 0, column, found)) {
		if (search.failed)
			return false;
		return search.unfinished ? fault_window(interp, "END", number, column)
					 : fault(&interp->at, column, "this loop is not closed: END%d is missing",
						 number);
	}
	remember(interp, key, found);
	return true;
}

/* Searches in a file of the program's name: its O-number, or the first line if the file has no O-number. */
static bool look_in_folders(struct interp *interp, int number, int column, struct position *found)
{
	struct search search = {.aim = AIM_PROGRAM, .number = number}, any = {.aim = AIM_ANY_PROGRAM};
	struct position start = {NULL, 0, 1};

	if (!program_files_find(interp, number, column, &start.source))
		return false;
	if (!start.source && number >= 8000 && number <= 9999)
		return fault(&interp->at, column,
			     "program O%d is neither in %s nor in a file of its own beside it or in an --include "
			     "folder; for a macro of the machine builder, set <macro program=\"%d\" action=\"\"/> "
			     "(none, move or around) in the machine file's <controller>",
			     number, interp->program.sources.items[0]->name, number);
	if (!start.source)
		return fault(&interp->at, column,
			     "program O%d is neither in %s nor in a file of its own beside it or in an --include "
			     "folder",
			     number, interp->program.sources.items[0]->name);
	if (search_lines(interp, &search, &start, 0, column, found))
		return true;
	if (search_lines(interp, &any, &start, 0, column, found))
		return fault(&interp->at, column, "%s does not contain program O%d", start.source->name, number);
	*found = start;
	return true;
}

/* Searches in the main program's file; *unfinished: a pipe, whose window lacks its start or enough lines ahead. */
static bool look_in_main(struct interp *interp, int number, int column, struct position *found, bool *unfinished)
{
	struct source *main = interp->program.sources.items[0];
	const struct position start = interp->program.start, forward = source_next(main);
	struct search search = {.aim = AIM_PROGRAM, .number = number}, rest = search;

	*unfinished = false;
	if (search_lines(interp, &search, &start, 0, column, found))
		return true;
	if (search.unfinished && search_lines(interp, &rest, &forward, 0, column, found))
		return true;
	*unfinished = search.unfinished;
	return false;
}

/* Which of two programs with one number a control keeps depends on a parameter (3201#2, REP). */
static bool is_only(struct interp *interp, int number, int column, const struct position *found)
{
	struct search search = {.aim = AIM_PROGRAM, .number = number, .after = found->line};
	struct position second;

	if (search_lines(interp, &search, found, 0, column, &second))
		return fault(&interp->at, column, "O%d occurs in lines %ld and %ld of %s, so the call is ambiguous",
			     number, found->line, second.line, found->source->name);
	return !search.unfinished || fault_window(interp, "O", number, column);
}

bool macro_b_seek_program(struct interp *interp, int number, int column, struct position *found)
{
	const struct position in_hand = {interp->program.source, 0, 1};
	struct search search = {.aim = AIM_PROGRAM, .number = number};
	struct label *label;
	bool unfinished;
	char key[96];

	if ((label = remembered(interp, &in_hand, "O", number, key))) {
		*found = label->at;
		return true;
	}
	if (!look_in_main(interp, number, column, found, &unfinished) &&
	    (unfinished || !search_lines(interp, &search, &in_hand, 0, column, found))) {
		if (unfinished)
			return fault_window(interp, "O", number, column);
		if (!look_in_folders(interp, number, column, found))
			return false;
	}
	if (!is_only(interp, number, column, found))
		return false;
	remember(interp, key, found);
	return true;
}

bool macro_b_seek_has_program(struct interp *interp, int number, int column, bool *has)
{
	const struct position in_hand = {interp->program.source, 0, 1};
	struct search search = {.aim = AIM_PROGRAM, .number = number};
	struct position found = in_hand;
	struct source *file = NULL;
	bool unfinished;
	char key[96];

	*has = remembered(interp, &in_hand, "O", number, key) != NULL;
	/* A missing program is remembered, too, for calls in a loop. */
	if (*has || remembered(interp, &in_hand, "no O", number, key))
		return true;
	*has = look_in_main(interp, number, column, &found, &unfinished) ||
	       search_lines(interp, &search, &in_hand, 0, column, &found);
	if (!*has && !program_files_find(interp, number, column, &file))
		return false;
	*has = *has || file;
	if (!*has)
		remember(interp, key, &found);
	return true;
}

bool macro_b_seek_jump(struct interp *interp, const struct position *to, int column)
{
	struct macro_b_call *call = macro_b_call_in_hand(interp);

	program_keep_line(&interp->program, &interp->at);
	while (call->loop_count > 0) {
		const struct macro_b_loop *top = &call->loops[call->loop_count - 1];

		if (to->source == top->start.source && to->offset >= top->start.offset && to->offset <= top->end.offset)
			break;
		call->loop_count--;
	}
	return program_jump(&interp->program, to, &interp->at, column);
}
