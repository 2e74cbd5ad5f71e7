#include "gcode/interp.h"

#include <errno.h>
#include <stdlib.h>
#include <string.h>

#include "base/mem.h"
#include "gcode/convert.h"
#include "gcode/state.h"

struct interp *interp_new(const struct gcode_config *config, const struct canon_sink *sink, struct diag *diag)
{
	struct interp *interp = mem_zalloc(1, sizeof(*interp));

	interp->config = config;
	interp->sink = sink;
	interp->diag = diag;
	state_init(&interp->state, config);
	return interp;
}

void interp_free(struct interp *interp)
{
	free(interp);
}

long interp_lines(const struct interp *interp)
{
	return interp->reader.line;
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

static bool run_line(struct interp *interp)
{
	struct block *block = &interp->block;
	struct block_modes modes = {interp->state.motion, interp->state.incremental};
	int blanks = (int)strspn(interp->at.text, " \t");

	if (interp->at.text[blanks] == '%')
		return take_percent(interp, blanks + 1);
	if (!block_read(block, &interp->at, interp->config, &interp->cautions))
		return false;
	/* LinuxCNC skips nothing but blank lines before '%', the others whatever is not a block. */
	interp->begun = interp->begun || block->words > 0 ||
			(interp->config->dialect == GCODE_LINUXCNC && interp->at.text[blanks] != '\0');
	if (block->words == 0)
		return true;
	interp->moves = 0;
	if (!block_check(block, &interp->at, interp->config, &modes) || !convert_block(interp))
		return false;
	return interp->sink->block(interp->sink->context, interp->at.line, interp->at.text, interp->moves);
}

/* What is wrong with the bytes of the file; false. */
static bool fault_of_reader(struct interp *interp, enum reader_status status, const char *text)
{
	struct srcloc loc = {interp->at.file, interp->reader.line, 0};

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

bool interp_run(struct interp *interp, FILE *in, const char *name)
{
	enum reader_status status;
	const char *text = NULL;
	bool good = true;

	interp->at = (struct line_place){.diag = interp->diag, .file = name};
	reader_init(&interp->reader, in);
	while (good && !interp->ended && (status = reader_next(&interp->reader, &text)) != READER_END) {
		if (status != READER_LINE) {
			good = fault_of_reader(interp, status, text);
			break;
		}
		interp->at.line = interp->reader.line;
		interp->at.text = text;
		good = run_line(interp);
	}
	if (good && !interp->ended && interp->percent)
		diag_warning(interp->diag, (struct srcloc){name, interp->reader.line, 0},
			     "the program ends without M2, M30 or %%; is the file complete?");
	reader_release(&interp->reader);
	return good;
}
