#include "gcode/dialect/sinumerik/flow/sinumerik_part.h"

#include <string.h>

#include "base/ascii.h"
#include "gcode/dialect/sinumerik/flow/sinumerik_call.h"
#include "gcode/dialect/sinumerik/flow/sinumerik_seek.h"
#include "gcode/dialect/sinumerik/values/sinumerik_expr.h"
#include "gcode/dialect/sinumerik/words/sinumerik_name.h"
#include "gcode/eval/expr.h"
#include "gcode/program.h"

static bool at_end(struct lexer *lexer)
{
	const char byte = lexer_peek(lexer);

	return byte == '\0' || byte == ';' || fault(lexer->at, lexer_next_column(lexer), "nothing can follow here");
}

/* "Program section repetition": the label is first searched towards the start of the program. */
static bool find_first(struct interp *interp, const char *name, int column, struct position *to)
{
	bool found;

	if (!sinumerik_seek_label(interp, name, SINUMERIK_BACKWARD, column, to, &found) ||
	    (!found && !sinumerik_seek_label(interp, name, SINUMERIK_FORWARD, column, to, &found)))
		return false;
	return found || fault(&interp->at, column, "there is no label %s in this program", name);
}

/*
 * Finds the end of the part: the first label with this name after its start. Posts end all parts with one name after
 * M30; if several precede this line, it is not certain which one counts.
 */
static bool find_last(struct interp *interp, const struct position *first, const char *name, int column, long *last)
{
	struct position end;
	bool found;

	if (!sinumerik_seek_label_behind(interp, name, first, 0, false, column, &end, &found))
		return false;
	if (!found)
		return fault(&interp->at, column, "there is no label %s behind the start of this part", name);
	*last = end.line;
	return end.line >= interp->at.line ||
	       sinumerik_seek_label_behind(interp, name, first, interp->at.line, true, column, &end, &found);
}

/* Finds the end of a part that has only a start label: the first ENDLABEL after it, or this REPEAT. */
static bool find_own_end(struct interp *interp, const struct position *first, int column, long *last)
{
	struct position end;
	bool found;

	if (first->line >= interp->at.line)
		return fault(&interp->at, column,
			     "a part behind its REPEAT is not supported without a second label");
	if (!sinumerik_seek_label_behind(interp, "ENDLABEL", first, interp->at.line, false, column, &end, &found))
		return false;
	*last = found ? end.line : interp->at.line - 1;
	return true;
}

bool sinumerik_part_repeat(struct interp *interp, struct lexer *lexer, bool block)
{
	char first_name[SINUMERIK_NAME + 1], last_name[SINUMERIK_NAME + 1] = "";
	const int column = lexer_next_column(lexer);
	struct position first;
	int rounds = 1;
	long last;

	if (!sinumerik_name_read(lexer, first_name))
		return fault(lexer->at, column, "the label of the repeated part is needed here");
	if (!sinumerik_name_take(lexer, "P") && !block) {
		if (sinumerik_name_read(lexer, last_name) && !strcmp(last_name, "P"))
			last_name[0] = '\0';
		else if (last_name[0])
			sinumerik_name_take(lexer, "P");
	}
	if (sinumerik_name_take_byte(lexer, '=') && !sinumerik_expr_whole(interp, lexer, "P", 1, 9999, &rounds))
		return false;
	if (!at_end(lexer) || !find_first(interp, first_name, column, &first))
		return false;
	last = first.line;
	if (last_name[0] ? !find_last(interp, &first, last_name, column, &last)
			 : !block && !find_own_end(interp, &first, column, &last))
		return false;
	return program_count(&interp->program, interp->config->read.max_blocks, &interp->at) &&
	       sinumerik_call_repeat(interp, &first, last, rounds, column);
}

/* A label, or a text that names one, in upper case. */
static bool read_label(struct interp *interp, struct lexer *lexer, char name[SINUMERIK_NAME + 1])
{
	const int column = lexer_next_column(lexer);
	struct sinumerik_text text;
	size_t length;

	if (!sinumerik_expr_is_text(interp, lexer))
		return sinumerik_name_read(lexer, name) || fault(lexer->at, column, "a label is needed here");
	if (!sinumerik_expr_text(interp, lexer, &text))
		return false;
	length = strlen(text.bytes);
	if (length == 0 || length > SINUMERIK_NAME)
		return fault(lexer->at, column, "\"%s\" is no label", text.bytes);
	for (size_t i = 0; i <= length; i++)
		name[i] = ascii_upper(text.bytes[i]);
	return true;
}

bool sinumerik_part_call(struct interp *interp, struct lexer *lexer)
{
	char first_name[SINUMERIK_NAME + 1], last_name[SINUMERIK_NAME + 1];
	const int column = lexer_next_column(lexer);
	struct position first;
	long last;

	if (!read_label(interp, lexer, first_name))
		return false;
	if (!sinumerik_name_take(lexer, "TO"))
		return fault(lexer->at, lexer_next_column(lexer), "TO is needed here");
	return read_label(interp, lexer, last_name) && at_end(lexer) &&
	       find_first(interp, first_name, column, &first) &&
	       find_last(interp, &first, last_name, column, &last) &&
	       program_count(&interp->program, interp->config->read.max_blocks, &interp->at) &&
	       sinumerik_call_part(interp, &first, last, column);
}
