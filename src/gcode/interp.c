#include "gcode/interp.h"

#include <stdlib.h>
#include <string.h>

#include "base/apart.h"
#include "base/mem.h"
#include "gcode/dialect/family.h"
#include "gcode/execute/corner_insert.h"
#include "gcode/execute/cutter_comp/cutter_comp.h"
#include "gcode/execute/execute.h"
#include "gcode/execute/space_arc.h"
#include "gcode/execute/spline_move.h"
#include "gcode/fault_list.h"
#include "gcode/read_on.h"
#include "gcode/state.h"
#include "gcode/text/leader.h"
#include "gcode/text/line_shape.h"
#include "gcode/text/reader_fault.h"
#include "gcode/text/rest_of_file.h"

struct interp *interp_new(const struct gcode_config *config, const struct kinematics *kinematics,
			  const struct canon_sink *sink, struct diag *diag)
{
	struct interp *interp = mem_zalloc(1, sizeof(*interp));

	interp->config = config;
	interp->kinematics = kinematics;
	interp->sink = sink;
	interp->diag = diag;
	state_init(&interp->state, config);
	interp->comp.number = -1;
	tool_table_init(&interp->tools, config);
	interp->dialect_state = config->dialect->state_new ? config->dialect->state_new() : NULL;
	return interp;
}

void interp_free(struct interp *interp)
{
	program_release(&interp->program);
	tool_table_release(&interp->tools);
	comp_queue_release(&interp->comp.queue);
	free(interp->corner.text);
	free(interp->spline.points);
	free(interp->spline.knots);
	if (interp->dialect_state)
		interp->config->dialect->state_free(interp->dialect_state);
	free(interp);
}

long interp_lines(const struct interp *interp)
{
	return program_lines(&interp->program);
}

/*
 * B-64484EN, "Program Components Other Than Program Sections", and Haas, "Program Numbers": the text between the '%' at
 * the start of a file and the end of its line is a title, which controls ignore.
 */
static bool is_title(const struct interp *interp, const char *text)
{
	char squeezed[LINE_SHAPE_MAX];

	line_shape_squeeze(text, squeezed);
	return !interp->begun && traits_of(interp)->text_before_percent == ANSWER_YES &&
	       !line_shape_moves_axes(squeezed);
}

/*
 * A '%' line opens the program if it is the first line that is not blank; otherwise it closes the program. After M99
 * the line that opens it is read again.
 */
static bool take_percent(struct interp *interp, const char *text)
{
	const char *rest = text + 1;
	int column = (int)(rest - interp->at.text);

	if (interp->percent == interp->at.line && interp->program.source == interp->program.start.source)
		return true;
	if (rest[strspn(rest, " \t")] != '\0' && !is_title(interp, rest))
		return fault(&interp->at, column, "'%%' must be alone on its line");
	if (!interp->begun) {
		interp->begun = true;
		interp->percent = interp->at.line;
		return true;
	}
	if (!interp->percent)
		return fault(&interp->at, column, "'%%' ends a program only if one begins it");
	interp->ended = true;
	return true;
}

/* Reads the words of a block that is no plain move, and finds its motion. */
static APART bool take_words(struct interp *interp)
{
	const struct dialect *dialect = interp->config->dialect;
	struct block *block = &interp->block;
	struct block_modes modes = {
	    .motion = interp->state.motion,
	    .after_g80 = state_motion_after_g80(&interp->state, traits_of(interp)),
	    .incremental = interp->state.incremental,
	    .vectors = interp->state.length_code == G43_5,
	    .plane = interp->state.plane,
	};
	const size_t errors = interp->diag->errors;
	const struct line_place *checked = &interp->at;
	struct line_place again;
	struct diag unheard;

	if (!is_answered(interp, 1, dialect->read_block != NULL, "how a block is written") ||
	    (!block->plain && !dialect->read_block(interp)))
		return false;
	/* A word is missing after a fault: further faults of the block may only follow from this. */
	if (read_on(interp, errors)) {
		interp->lost = AXIS_BITS;
		unheard = (struct diag){0};
		again = interp->at;
		again.diag = &unheard;
		checked = &again;
	}
	interp->begun = interp->begun || block->words > 0 ||
			(traits_of(interp)->text_before_percent != ANSWER_YES && *line_start(&interp->at) != '\0');
	return block->words == 0 || block_check(block, checked, interp->config, &modes);
}

static bool run_block(struct interp *interp)
{
	const struct dialect *dialect = interp->config->dialect;
	struct block *block = &interp->block;

	if (block_is_plain_move(block, interp->state.motion, interp->state.length_code == G43_5))
		interp->begun = true;
	else if (!take_words(interp))
		return false;
	if (block->words == 0)
		return true;
	interp->moves = 0;
	if (dialect->before_block && !dialect->before_block(interp))
		return false;
	if (!execute_block(interp))
		return false;
	if (corner_insert_keeps_block(interp))
		return corner_insert_end_block(interp);
	return corner_insert_end_block(interp) && cutter_comp_end_block(interp);
}

static bool run_line(struct interp *interp)
{
	const struct dialect *dialect = interp->config->dialect;
	const char *text;
	bool done = false;

	interp->block.plain = dialect->read_block && block_read_plain(&interp->block, &interp->at, interp->config);
	if (dialect->statement && !dialect->statement(interp, &done))
		return false;
	interp->begun = interp->begun || done;
	if (done)
		return true;
	if (interp->block.plain)
		return run_block(interp);
	text = line_start(&interp->at);
	return *text == '%' ? take_percent(interp, text) : run_block(interp);
}

/* Adds the calls of the current block as notes to the last message. */
static void note_callers(struct interp *interp)
{
	const struct dialect *dialect = interp->config->dialect;
	struct strbuf title = {0};
	struct srcloc at;

	for (size_t level = 0; dialect->caller && dialect->caller(interp, level, &at, &title); level++) {
		diag_note(interp->diag, at, "%s is called from here", strbuf_text(&title));
		strbuf_clear(&title);
	}
	strbuf_release(&title);
}

/* Finds the callers before a line is carried out, because the line may be a call or return. */
static void find_callers(struct interp *interp)
{
	const struct dialect *dialect = interp->config->dialect;
	struct call_chain *chain = &interp->callers;

	chain->count = 0;
	while (dialect->caller && chain->count < CALLS_MAX &&
	       dialect->caller(interp, chain->count, &chain->calls[chain->count], NULL))
		chain->count++;
}

/*
 * Carries out a line; in a subprogram the calls that led there follow its messages. This must be a separate function:
 * browsers replace the slow first code of a function when it is called again, and the loop over all lines is called
 * only once.
 */
static APART bool run_line_called(struct interp *interp)
{
	size_t said = interp->diag->errors + interp->diag->warnings;
	bool good;

	find_callers(interp);
	if (interp->program.source == interp->program.sources.items[0] && interp->at.line > interp->furthest)
		interp->furthest = interp->at.line;
	good = run_line(interp);

	if (interp->diag->errors + interp->diag->warnings > said)
		note_callers(interp);
	return good;
}

static bool end_file(struct interp *interp)
{
	const struct dialect *dialect = interp->config->dialect;

	return !dialect->end_of_file || dialect->end_of_file(interp);
}

/* Lines between two calls of `cancel`; this includes blank lines, which cause no other events. */
#define QUIT_LINES 4096

/* Reads the next line of the file. False: the program has ended; *good is false after a fault or a cancellation. */
static bool next_line(struct interp *interp, bool *good)
{
	struct source *source = interp->program.source;
	enum reader_status status;

	if (++interp->program.lines % QUIT_LINES == 0 && cancel_asked(interp->config->read.cancel)) {
		*good = false;
		return false;
	}
	status = reader_next(&source->reader, &interp->at.text);
	interp->at.file = source->name;
	interp->at.line = source->reader.line;
	if (status == READER_LINE)
		return true;
	if (status == READER_STOPPED) {
		*good = false;
		return false;
	}
	*good = status == READER_END && end_file(interp);
	if (status != READER_END) {
		const struct reader_fault fault = reader_fault_of(&source->reader, status, interp->at.text);

		reader_fault_report(&fault, source->name, interp->diag);
	}
	if (!*good)
		note_callers(interp);
	/* At the end of a part that is repeated, reading continues elsewhere. */
	return *good && interp->program.source->reader.line != interp->at.line && next_line(interp, good);
}

/* The file was read to its end without an end of the program: perhaps the file was still being written. */
static void warn_of_missing_end(struct interp *interp, const struct reader *reader)
{
	struct srcloc loc = {interp->program.sources.items[0]->name, reader->line, 0};

	if (interp->percent)
		diag_warning(interp->diag, loc, "the program ends without M2, M30 or %%; is the file complete?");
	else if (reader->open_end)
		diag_warning(interp->diag, loc,
			     "the file stops in the middle of this line, without M2 or M30 before: if the file is "
			     "incomplete, write it again; otherwise end it with M2 or M30, or end this line with a "
			     "line feed");
}

/*
 * Text after the end is not carried out, but a reader of the file may believe that it was checked. False: it is a
 * program that a verdict has to be about.
 */
static bool check_rest(struct interp *interp, struct reader *reader)
{
	const long end = reader->line, lines = reader->furthest;
	struct srcloc loc = {interp->program.sources.items[0]->name, 0, 0};
	struct rest_of_file rest;
	const char *text;

	/* A jump or a repetition may have read lines after the end. */
	while (reader->line < interp->furthest && reader_next(reader, &text) == READER_LINE)
		continue;
	rest = rest_of_file_find(reader, interp->config->dialect->heads_main, interp->config->read.cancel);
	loc.line = rest.main ? rest.main : rest.program ? rest.program : rest.motion;

	/* Lines after the end are not counted as lines of the program. */
	reader->furthest = lines;
	if (rest.main)
		diag_error(interp->diag, loc,
			   "another main program begins here, after the end in line %ld: it was not checked; give it a "
			   "file of its own",
			   end);
	else if (rest.program)
		diag_warning(
		    interp->diag, loc,
		    "another program begins here, after the end in line %ld: it was not checked; give it a file of its "
		    "own",
		    end);
	else if (rest.motion)
		diag_warning(
		    interp->diag, loc,
		    "this line moves axes after the end of the program in line %ld: nothing was checked from here on",
		    end);
	return !rest.main;
}

/* A program for another control must not be misread: certain signs are an error. A pipe is not read ahead. */
static bool check_family(struct interp *interp, struct reader *reader)
{
	const char *dialect = interp->config->dialect->name;
	struct family_sign found;
	struct srcloc loc = {interp->at.file, 0, 0};

	if (reader->base < 0)
		return true;
	found = family_find(reader, dialect);
	loc.line = found.line;
	if (found.certain)
		diag_error(
		    interp->diag, loc,
		    "this looks like %s (%s), but the dialect is %s; set the right one by --dialect or in the machine "
		    "file's <controller>",
		    found.title, found.sign, dialect);
	else if (found.line)
		diag_warning(interp->diag, loc, "this looks like %s (%s), but the dialect is %s",
			     found.title, found.sign, dialect);
	return !found.certain;
}

static bool run_lines(struct interp *interp)
{
	bool good = true;

	while (good && !interp->ended && next_line(interp, &good)) {
		const size_t errors = interp->diag->errors;

		if (!interp->program.start.source)
			interp->program.start = source_here(interp->program.source);
		good = run_line_called(interp);
		if (!good)
			read_on_lose(interp);
		good = read_on(interp, errors) || good;
	}
	return good;
}

static bool run_program(struct interp *interp, FILE *in, const char *name)
{
	struct reader *reader;
	bool good = true;

	interp->program.sources.opened = interp->config->read.opened;
	sources_open_main(&interp->program.sources, in, name, interp->config->names);
	interp->program.source = interp->program.sources.items[0];
	reader = &interp->program.source->reader;
	reader->waiting = interp->config->read.waiting;
	interp->at = (struct line_place){.diag = interp->diag, .file = interp->program.source->name};
	good = check_family(interp, reader);
	if (good && traits_of(interp)->text_before_percent == ANSWER_YES)
		leader_skip(reader);
	good = good && run_lines(interp);
	if (good && !interp->ended) {
		/* The last line is not in the reader's buffer any more. */
		interp->at.text = "";
		good = corner_insert_end_block(interp) && cutter_comp_stop(interp);
	}
	good = good && spline_move_check_end(interp) && space_arc_check_end(interp);
	if (good && !interp->ended)
		warn_of_missing_end(interp, reader);
	else if (good)
		good = check_rest(interp, reader);
	sources_close(&interp->program.sources);
	return good && !interp->faulty;
}

bool interp_run(struct interp *interp, FILE *in, const char *name)
{
	struct diag *diag = interp->diag;
	struct fault_list faults;
	bool good;

	if (!interp->config->read.all_faults)
		return run_program(interp, in, name);
	fault_list_init(&faults, diag);
	interp->diag = &faults.diag;
	good = run_program(interp, in, name);
	fault_list_finish(&faults, interp->at.file);
	interp->diag = diag;
	return good;
}
