#include "gcode/interp.h"

#include <errno.h>
#include <stdlib.h>
#include <string.h>

#include "base/mem.h"
#include "gcode/dialect/linuxcnc/system_params.h"
#include "gcode/execute/cutter_comp/cutter_comp.h"
#include "gcode/execute/execute.h"
#include "gcode/state.h"

struct interp *interp_new(const struct gcode_config *config, const struct kinematics *kinematics,
			  const struct canon_sink *sink, struct diag *diag)
{
	struct interp *interp = mem_zalloc(1, sizeof(*interp));

	interp->config = config;
	interp->kinematics = kinematics;
	interp->sink = sink;
	interp->diag = diag;
	state_init(&interp->state, config);
	tool_table_init(&interp->tools, config);
	macro_b_init(&interp->macro);
	interp->params.numbered[5599] = 1;	/* LinuxCNC: DEBUG comments speak */
	return interp;
}

void interp_free(struct interp *interp)
{
	sources_release(&interp->sources);
	tool_table_release(&interp->tools);
	params_release(&interp->params);
	comp_queue_release(&interp->comp.queue);
	control_flow_release(&interp->flow);
	macro_b_release(&interp->macro);
	free(interp);
}

long interp_lines(const struct interp *interp)
{
	return interp->sources.count ? interp->sources.items[0]->reader.furthest : 0;
}

/* A '%' line opens the program if it is the first that is not blank, and else closes it. */
static bool take_percent(struct interp *interp, int column)
{
	const char *rest = interp->at.text + column;

	if (rest[strspn(rest, " \t")] != '\0')
		return fault(&interp->at, column, "'%%' stands alone on its line");
	if (!interp->begun) {
		interp->begun = interp->percent = true;
		return true;
	}
	if (!interp->percent)
		return fault(&interp->at, column, "'%%' ends a program only if one opens it");
	interp->ended = true;
	return true;
}

/* A subprogram's file may begin with one, too. */
static bool take_called_percent(struct interp *interp)
{
	return interp->source != interp->sources.items[0] && interp->at.line == 1 ? true : macro_b_end_of_file(interp);
}

/* What the block has assigned takes effect before its codes do, but after all of its words were read. */
static void assign(struct interp *interp)
{
	struct params *params = &interp->params;

	for (size_t i = 0; i < params->pending_count; i++) {
		const struct assignment *new = &params->pending[i];

		if (new->number > 0)
			system_params_set_number(interp, new->number, new->value);
		else
			params_make(params, new->name)->value = new->value;
	}
	params->pending_count = 0;
}

static bool run_block(struct interp *interp)
{
	struct block *block = &interp->block;
	struct block_modes modes = {interp->state.motion, interp->state.incremental};
	int blanks = (int)strspn(interp->at.text, " \t");

	if (!block_read(block, &interp->at, interp->config, &interp->cautions, interp))
		return false;
	/* LinuxCNC skips nothing but blank lines before '%', the others whatever is not a block. */
	interp->begun = interp->begun || block->words > 0 ||
			(interp->config->dialect->legacy == GCODE_LINUXCNC && interp->at.text[blanks] != '\0');
	if (block->words == 0)
		return true;
	interp->moves = 0;
	if (!block_check(block, &interp->at, interp->config, &modes))
		return false;
	assign(interp);
	if (!execute_block(interp))
		return false;
	return cutter_comp_end_block(interp);
}

static bool run_line(struct interp *interp)
{
	bool done = false;
	int blanks = (int)strspn(interp->at.text, " \t");

	if (interp->at.text[blanks] == '%' && interp->macro.level > 0)
		return take_called_percent(interp);
	if (interp->at.text[blanks] == '%' && interp->flow.skip == SKIP_NOTHING)
		return take_percent(interp, blanks + 1);
	if (interp->config->dialect->statement && !interp->config->dialect->statement(interp, &done))
		return false;
	interp->begun = interp->begun || done;
	return done || run_block(interp);
}

static void note_callers(struct interp *interp)
{
	control_flow_note_callers(interp);
	macro_b_note_callers(interp);
}

/* A line with its messages: in a subprogram, they are followed by the calls that led there. */
static bool run_line_called(struct interp *interp)
{
	size_t said = interp->diag->errors + interp->diag->warnings;
	bool good = control_flow_count(interp) && run_line(interp);

	if (interp->diag->errors + interp->diag->warnings > said)
		note_callers(interp);
	return good;
}

/* What is wrong with the bytes of the file; false. */
static bool fault_of_reader(struct interp *interp, enum reader_status status, const char *text)
{
	struct srcloc loc = {interp->at.file, interp->source->reader.line, 0};

	switch (status) {
	case READER_TOO_LONG:
		diag_error(interp->diag, loc, "a line of more than %d bytes is no NC block", LINE_LENGTH_MAX);
		break;
	case READER_NUL_BYTE:
		loc.column = (int)strlen(text) + 1;
		diag_error(interp->diag, loc, "a NUL byte; is this an NC program?");
		break;
	case READER_MIXED_ENDS:
		loc.column = (int)strlen(text) + 1;
		diag_error(interp->diag, loc, "line ends are mixed: a carriage return alone, and line feeds");
		break;
	case READER_UTF16:
		diag_error(interp->diag, loc, "the file is UTF-16; save it as plain text");
		break;
	default:
		loc.line = 0;
		diag_error(interp->diag, loc, "cannot read the program: %s", strerror(errno));
		break;
	}
	return false;
}

/* Lines between two questions whether to go on; blank ones, which nobody else hears of, count as well. */
#define QUIT_LINES 4096

/* The next line of the file in hand. False: the program has ended, or *good: a fault was reported, or the run was cancelled. */
static bool next_line(struct interp *interp, bool *good)
{
	struct source *source = interp->source;
	enum reader_status status;

	if (++interp->lines % QUIT_LINES == 0 && cancel_asked(interp->config->read.cancel)) {
		*good = false;
		return false;
	}
	status = reader_next(&source->reader, &interp->at.text);
	interp->at.file = source->name;
	interp->at.line = source->reader.line;
	if (status == READER_LINE)
		return true;
	*good = status == READER_END ? control_flow_end_of_file(interp) && macro_b_end_of_file(interp)
				     : fault_of_reader(interp, status, interp->at.text);
	if (!*good)
		note_callers(interp);
	return false;
}

/* All of the file was read, and nothing in it ended the program: perhaps it was still being written. */
static void warn_of_missing_end(struct interp *interp, const struct line_reader *reader)
{
	struct srcloc loc = {interp->sources.items[0]->name, reader->line, 0};

	if (interp->percent)
		diag_warning(interp->diag, loc, "the program ends without M2, M30 or %%; is the file complete?");
	else if (reader->open_end)
		diag_warning(interp->diag, loc,
			     "the file stops in the middle of this line, and no M2 or M30 came before: if it is not "
			     "complete, write it again; if it is, end it with M2 or M30, or the line with a line feed");
}

bool interp_run(struct interp *interp, FILE *in, const char *name)
{
	struct line_reader *reader;
	bool good = true;

	interp->sources.opened = interp->config->read.opened;
	sources_open_main(&interp->sources, in, name);
	interp->source = interp->sources.items[0];
	reader = &interp->source->reader;
	interp->at = (struct line_place){.diag = interp->diag, .file = interp->source->name};
	while (good && !interp->ended && next_line(interp, &good)) {
		if (!interp->first_line) {
			interp->first_line = reader->line;
			interp->first_offset = reader->start;
		}
		good = run_line_called(interp);
	}
	if (good && !interp->ended) {
		/* The last line is no longer in the reader's buffer. */
		interp->at.text = "";
		good = cutter_comp_stop(interp);
	}
	if (good && !interp->ended)
		warn_of_missing_end(interp, reader);
	sources_close(&interp->sources);
	return good;
}
