#include "gcode/dialect/fanuc/macro_b.h"

#include <math.h>
#include <string.h>

#include "base/apart.h"
#include "base/ascii.h"
#include "gcode/dialect/fanuc/builder_macro.h"
#include "gcode/dialect/fanuc/macro_b_call.h"
#include "gcode/dialect/fanuc/macro_b_expr.h"
#include "gcode/dialect/fanuc/macro_b_seek.h"
#include "gcode/dialect/fanuc/macro_b_vars.h"
#include "gcode/text/line_shape.h"
#include "gcode/text/number.h"

/* On some controls the first two letters are enough (B-63944EN, abbreviation). */
static bool keyword(struct interp *interp, struct lexer *lexer, const char *word)
{
	const char two[3] = {word[0], word[1], '\0'};

	return lexer_keyword(lexer, word) ||
	       (macro_b_of(interp)->rules->keywords_short && lexer_keyword(lexer, two));
}

static bool end_statement(struct lexer *lexer)
{
	if (!lexer_skip_comments(lexer))
		return false;
	if (lexer_peek(lexer) == '\0')
		return true;
	return fault(lexer->at, lexer_column(lexer), "a macro statement needs a block of its own");
}

/* Skips a statement whose condition is false. Words of a block after it would be lost, so they are refused. */
static bool pass_over(struct lexer *lexer)
{
	int depth = 0, letters;

	while (lexer_skip_comments(lexer) && lexer_peek(lexer) != '\0') {
		char byte = lexer_peek(lexer);
		int column = lexer_column(lexer);

		if (depth > 0 || !ascii_is_letter(byte)) {
			depth += (byte == '[') - (byte == ']');
			lexer_take(lexer);
			continue;
		}
		if (lexer_keyword(lexer, "and") || lexer_keyword(lexer, "or") || lexer_keyword(lexer, "xor") ||
		    lexer_keyword(lexer, "mod"))
			continue;
		for (letters = 0; ascii_is_letter(lexer_peek(lexer)); letters++)
			lexer_take(lexer);
		if (letters < 2 || lexer_peek(lexer) != '[')
			return fault(lexer->at, column, "a macro statement needs a block of its own");
	}
	return end_statement(lexer);
}

/* ------------------------------------------------------------- assignments */

static bool assign(struct interp *interp, struct lexer *lexer)
{
	double value = 0;
	int number, column;

	lexer_peek(lexer);
	column = lexer_column(lexer);
	if (!macro_b_expr_variable_number(lexer, &number))
		return false;
	if (lexer_peek(lexer) != '=')
		return fault(lexer->at, lexer_column(lexer), "'=' is missing after the variable");
	lexer_take(lexer);
	return macro_b_expr_sum(lexer, &value) && macro_b_vars_write(interp, number, column, value);
}

/* One or more assignments, "#1=2". */
static bool do_assignments(struct interp *interp, struct lexer *lexer)
{
	do {
		if (!assign(interp, lexer) || !lexer_skip_comments(lexer))
			return false;
	} while (lexer_peek(lexer) == '#');
	return end_statement(lexer);
}

/* --------------------------------------------------------------- branches */

static bool do_goto(struct interp *interp, struct lexer *lexer)
{
	int number, column;

	lexer_peek(lexer);
	column = lexer_column(lexer);
	return macro_b_expr_integer(lexer, "the block number of GOTO", &number) && end_statement(lexer) &&
	       macro_b_seek_goto(interp, number, column);
}

static bool do_if(struct interp *interp, struct lexer *lexer)
{
	bool holds;

	if (!macro_b_expr_condition(lexer, "IF", &holds))
		return false;
	if (keyword(interp, lexer, "goto"))
		return holds ? do_goto(interp, lexer) : pass_over(lexer);
	lexer_peek(lexer);
	if (!keyword(interp, lexer, "then"))
		return fault(lexer->at, lexer_column(lexer), "IF [...] needs GOTO or THEN");
	if (lexer_peek(lexer) != '#')
		return fault(lexer->at, lexer_column(lexer),
			     "THEN is supported only with an assignment");
	return holds ? do_assignments(interp, lexer) : pass_over(lexer);
}

/* ------------------------------------------------------------------- loops */

static bool read_loop_number(struct lexer *lexer, const char *what, int *number)
{
	int column;

	lexer_peek(lexer);
	column = lexer_column(lexer);
	if (!macro_b_expr_integer(lexer, what, number))
		return false;
	if (*number >= 1 && *number <= MACRO_B_LOOPS)
		return true;
	return fault(lexer->at, column, "%s must be from 1 to %d", what, MACRO_B_LOOPS);
}

static bool open_loop(struct interp *interp, int number, int column)
{
	struct macro_b_call *call = macro_b_call_in_hand(interp);
	struct macro_b_loop new = {.number = number, .start = source_here(interp->program.source)};

	for (int i = 0; i < call->loop_count; i++) {
		if (call->loops[i].number == number)
			return fault(&interp->at, column, "DO%d inside the DO%d of line %ld", number, number,
				     call->loops[i].start.line);
	}
	if (!macro_b_seek_end(interp, number, column, &new.end))
		return false;
	call->loops[call->loop_count++] = new;
	return true;
}

/* WHILE [...] DO1; DO1 alone is endless. */
static bool do_while(struct interp *interp, struct lexer *lexer, bool condition)
{
	struct macro_b_call *call = macro_b_call_in_hand(interp);
	const struct position here = source_here(interp->program.source);
	bool holds = true;
	int number, column;

	if (condition && !macro_b_expr_condition(lexer, "WHILE", &holds))
		return false;
	lexer_peek(lexer);
	if (condition && !lexer_keyword(lexer, "do"))
		return fault(lexer->at, lexer_column(lexer), "WHILE [...] needs DO");
	lexer_peek(lexer);
	column = lexer_column(lexer);
	if (!read_loop_number(lexer, "the number of DO", &number) || !end_statement(lexer))
		return false;
	if (!(call->loop_count > 0 && position_is_same(&call->loops[call->loop_count - 1].start, &here)) &&
	    !open_loop(interp, number, column))
		return false;
	macro_b_of(interp)->jumped = true;
	if (holds)
		return true;
	call->loop_count--;
	/* Continues after END: the line of END itself would return to the start of the loop. */
	if (!macro_b_seek_jump(interp, &call->loops[call->loop_count].end, column))
		return false;
	reader_next(&interp->program.source->reader, &interp->at.text);
	return true;
}

static bool do_end(struct interp *interp, struct lexer *lexer, int column)
{
	struct macro_b_call *call = macro_b_call_in_hand(interp);
	const struct macro_b_loop *top = call->loop_count > 0 ? &call->loops[call->loop_count - 1] : NULL;
	const struct position here = source_here(interp->program.source);
	int number;

	if (!read_loop_number(lexer, "the number of END", &number) || !end_statement(lexer))
		return false;
	if (!top || !position_is_same(&top->end, &here))
		return fault(lexer->at, column, "END%d without DO%d; a jump into a loop is not allowed",
			     number, number);
	return macro_b_seek_jump(interp, &top->start, column);
}

/* ---------------------------------------------------------------- the line */

/* The program's number is allowed on its first line. A later number starts another program before M30 or M99. */
static bool check_program_number(struct interp *interp, struct lexer *lexer)
{
	const struct macro_b_call *call = macro_b_call_in_hand(interp);
	const struct position here = source_here(interp->program.source);
	char title[MACRO_B_TITLE];

	if (macro_b_of(interp)->level == 0 && !macro_b_of(interp)->started)
		macro_b_of(interp)->calls[0].program = here;
	macro_b_of(interp)->started = true;
	if (position_is_same(&call->program, &here))
		return true;
	if (macro_b_of(interp)->level == 0)
		return fault(lexer->at, lexer_column(lexer), "another program begins here before M2, M30 or M99%s",
			     lexer_peek(lexer) != ':' ? ""
						      : "; if ':' means N on this control, set colon=\"block\" in the "
							"machine file's <controller>");
	return fault(lexer->at, lexer_column(lexer),
		     "another program begins here, but %s has not ended: its M99 is missing",
		     macro_b_call_title(call, title));
}

static bool is_letters(const char *text)
{
	while (ascii_is_letter(*text))
		text++;
	return *text == '\0';
}

/*
 * The head of a program with a name instead of a number: "<PART-1>" (30i-B operator's manual B-64484EN, program name),
 * an O with text that a post processor left to be filled in, or "OCIRCLE" of controls that allow names there. None of
 * these contains a motion.
 */
static bool take_name(struct interp *interp, bool *done)
{
	struct macro_b *macro = macro_b_of(interp);
	const char *text = line_start(&interp->at);
	size_t length = strcspn(text, ">");
	char squeezed[LINE_SHAPE_MAX];
	struct lexer lexer;

	if (macro->started || macro->level > 0)
		return true;
	line_shape_squeeze(text, squeezed);
	if (*text == '<' && text[length] == '>') {
		lexer_init(&lexer, &interp->at, macro_b_word_rules(interp), interp);
		lexer.position = (size_t)(text - interp->at.text) + length + 1;
		if (!end_statement(&lexer))
			return false;
	} else if ((*text == 'O' || *text == 'o') && ascii_is_letter(squeezed[1]) &&
		   (is_letters(squeezed) ||
		    ((text[1] == ' ' || text[1] == '\t') && !line_shape_moves_axes(text)))) {
		caution(&interp->at, 1, "no program number after O; this line is ignored");
	} else {
		return true;
	}
	macro->calls[0].program = source_here(interp->program.source);
	macro->started = *done = true;
	return true;
}

/* Reads the whole number after a letter; nothing is consumed if there is none. */
static bool take_number(struct lexer *lexer, double *value)
{
	size_t position = lexer->position + 1;
	bool point;

	if (number_read(lexer->at->text, &position, value, &point) != NUMBER_OK || point)
		return false;
	lexer->position = position;
	return true;
}

/* Reads the number of a G-code, which may have tenths; nothing is consumed if there is none. */
static bool take_code(struct lexer *lexer, double *value)
{
	size_t position = lexer->position + 1;
	bool point;

	if (number_read(lexer->at->text, &position, value, &point) != NUMBER_OK)
		return false;
	lexer->position = position;
	return true;
}

/* Skips '/', '/2', or several of them. */
static void skip_slash(struct lexer *lexer)
{
	while (lexer_peek(lexer) == '/') {
		lexer_take(lexer);
		if (ascii_is_digit(lexer_peek(lexer)))
			lexer_take(lexer);
	}
}

/* Skips '/', O and N in the same way as block_read, which reports their faults. */
static bool skip_start(struct interp *interp, struct lexer *lexer, bool *skipped)
{
	double value;
	char byte;

	if (lexer_peek(lexer) == '/')
		skip_slash(lexer);
	if (!lexer_skip_comments(lexer))
		return false;
	byte = lexer_peek(lexer);
	if (byte == 'O' || byte == 'o' || byte == ':') {
		bool block = byte == ':' && interp->config->controller.colon == COLON_BLOCK;

		if (!block && !check_program_number(interp, lexer))
			return false;
		take_number(lexer, &value);
	}
	byte = lexer_peek(lexer);
	if (byte == 'N' || byte == 'n')
		take_number(lexer, &value);
	if (lexer_peek(lexer) == '/') {
		skip_slash(lexer);
		*skipped = interp->config->read.block_delete;
	}
	return lexer_skip_comments(lexer);
}

/* "SETVN 101[DEPTH,WIDTH]". */
static bool is_naming(const struct interp *interp, struct lexer *lexer)
{
	return macro_b_of(interp)->rules->names_variables && lexer_keyword(lexer, "setvn");
}

/*
 * B-63944EN, external output commands, and names of common variables for the screen; Haas, DPRNT: text to a port or a
 * file.
 */
static bool is_text(const struct interp *interp, struct lexer *lexer)
{
	return lexer_keyword(lexer, "popen") || lexer_keyword(lexer, "pclos") || lexer_keyword(lexer, "bprnt") ||
	       lexer_keyword(lexer, "dprnt") || is_naming(interp, lexer);
}

/* Carries out G65, G66 and G67; their words are not those of a block. */
static bool do_g(struct interp *interp, struct lexer *lexer, bool *done)
{
	bool modal = macro_b_of(interp)->rules->modal_calls;
	const struct builder_macro *code;
	size_t position = lexer->position;
	int column = lexer_column(lexer);
	double value;

	*done = take_code(lexer, &value);
	code = *done ? builder_macro_of_code(interp, value) : NULL;
	if (code)
		return macro_b_call_by_code(interp, lexer, column, code, done);
	*done = *done && value > 64 && fabs(value - round(value)) < 1e-9 &&
		(lround(value) == 65 || (modal && (lround(value) == 66 || lround(value) == 67)));
	if (!*done) {
		lexer->position = position;
		return true;
	}
	if (lround(value) == 65)
		return macro_b_call_g65(interp, lexer, column, done);
	if (lround(value) == 66)
		return macro_b_call_g66(interp, lexer, column);
	macro_b_of(interp)->modal = false;
	return end_statement(lexer);
}

/* Haas: "[#1 LT 10] M99 P10" (operator's manual, "Conditional Expressions"). */
static bool do_conditional_m99(struct interp *interp, struct lexer *lexer)
{
	bool holds;
	int number, column;

	if (!macro_b_expr_condition(lexer, "M99", &holds))
		return false;
	lexer_peek(lexer);
	if (!lexer_keyword(lexer, "m99") || !lexer_keyword(lexer, "p"))
		return fault(lexer->at, lexer_column(lexer),
			     "a condition at the start of a block must be followed by M99 P");
	lexer_peek(lexer);
	column = lexer_column(lexer);
	return macro_b_expr_integer(lexer, "the block number of M99", &number) && end_statement(lexer) &&
	       (!holds || macro_b_seek_goto(interp, number, column));
}

static bool do_statement(struct interp *interp, struct lexer *lexer, bool *done)
{
	char byte = lexer_peek(lexer);
	int column = lexer_column(lexer);

	/* Most blocks start with another letter. */
	*done = byte != '\0' && strchr("#[GgIiWwDdEePpBbSs", byte);
	if (!*done)
		return true;
	/* G-codes first: they are the most frequent. */
	if ((byte == 'G' || byte == 'g') && ascii_is_digit(lexer->at->text[lexer->position + 1]))
		return do_g(interp, lexer, done);
	if (byte == '#')
		return do_assignments(interp, lexer);
	if (byte == '[' && macro_b_of(interp)->rules->conditional_m99)
		return do_conditional_m99(interp, lexer);
	if (keyword(interp, lexer, "goto"))
		return do_goto(interp, lexer);
	if (byte == 'G' || byte == 'g')
		return do_g(interp, lexer, done);
	if (lexer_keyword(lexer, "if"))
		return do_if(interp, lexer);
	if (keyword(interp, lexer, "while"))
		return do_while(interp, lexer, true);
	if (lexer_keyword(lexer, "do"))
		return do_while(interp, lexer, false);
	if (keyword(interp, lexer, "end"))
		return do_end(interp, lexer, column);
	*done = is_text(interp, lexer);
	return true;
}

/* '%' in the file of a subprogram: it may be at its start; elsewhere it ends the file too early. */
static bool do_percent(struct interp *interp, bool *done)
{
	*done = macro_b_of(interp)->level > 0;
	if (!*done || (interp->program.source != interp->program.sources.items[0] && interp->at.line == 1))
		return true;
	return macro_b_call_end_of_file(interp);
}

/* Carries out a line that is no plain block. */
static APART bool take_line(struct interp *interp, bool *done)
{
	struct macro_b *macro = macro_b_of(interp);
	const char *text = line_start(&interp->at);
	bool skipped = false;
	struct lexer lexer;

	if (*text == '\0' || (*text == '/' && interp->config->read.block_delete))
		return true;
	if (*text == '%')
		return do_percent(interp, done);
	if (!take_name(interp, done) || *done)
		return *done;
	lexer_init(&lexer, &interp->at, macro_b_word_rules(interp), interp);
	if (!skip_start(interp, &lexer, &skipped))
		return false;
	if (skipped)
		return true;
	macro->started = macro->started || lexer_peek(&lexer) != '\0';
	return do_statement(interp, &lexer, done);
}

bool macro_b_line(struct interp *interp, bool *done)
{
	struct macro_b *macro = macro_b_of(interp);

	*done = false;
	macro->assigned_count = 0;
	macro->builder.macro = NULL;
	if ((macro->jumped || interp->program.repeated) &&
	    !program_count(&interp->program, interp->config->read.max_blocks, &interp->at))
		return false;
	/* The machine builder may have assigned the block's G-code to a macro. */
	if (interp->block.plain && builder_macro_of_code(interp, interp->block.g[G_MOTION] / 10.0))
		interp->block.plain = false;
	if (!interp->block.plain)
		return take_line(interp, done);
	macro->started = true;
	return true;
}

bool macro_b_read_block(struct interp *interp)
{
	const struct block_rules rules = {
		.lexer = macro_b_word_rules(interp), .program_numbers = true, .numbered_switches = true};

	if (macro_b_of(interp)->builder.macro) {
		builder_macro_begin(interp);
		return true;
	}
	return block_read(&interp->block, &interp->at, interp->config, &rules, interp, &interp->cautions);
}
