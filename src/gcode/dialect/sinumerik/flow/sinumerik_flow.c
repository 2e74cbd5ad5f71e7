#include "gcode/dialect/sinumerik/flow/sinumerik_flow.h"

#include <math.h>
#include <string.h>

#include "base/ascii.h"
#include "gcode/dialect/sinumerik/builder/sinumerik_gud.h"
#include "gcode/dialect/sinumerik/flow/sinumerik_call.h"
#include "gcode/dialect/sinumerik/flow/sinumerik_part.h"
#include "gcode/dialect/sinumerik/flow/sinumerik_seek.h"
#include "gcode/dialect/sinumerik/values/sinumerik_expr.h"
#include "gcode/dialect/sinumerik/values/sinumerik_variables.h"
#include "gcode/dialect/sinumerik/words/sinumerik_name.h"
#include "gcode/eval/expr.h"
#include "gcode/program.h"
#include "gcode/text/number.h"

struct flow {
	struct interp *interp;
	struct lexer *lexer;
	struct sinumerik *sinumerik;
	int column;	/* of the word of the statement */
};

static bool jump_to(const struct flow *flow, const struct position *to)
{
	return program_count(&flow->interp->program, flow->interp->config->read.max_blocks, &flow->interp->at) &&
	       program_jump(&flow->interp->program, to, &flow->interp->at, flow->column);
}

static bool at_end(const struct flow *flow)
{
	const char byte = lexer_peek(flow->lexer);

	return byte == '\0' || byte == ';' ||
	       fault(flow->lexer->at, lexer_next_column(flow->lexer), "nothing can follow here");
}

static bool condition(const struct flow *flow, bool *holds)
{
	double value;

	if (!sinumerik_expr_number(flow->interp, flow->lexer, &value))
		return false;
	*holds = fpclassify(value) != FP_ZERO;
	return true;
}

/* ------------------------------------------------------------------- loops */

static struct sinumerik_loop *top_loop(const struct flow *flow)
{
	struct sinumerik *sinumerik = flow->sinumerik;
	struct sinumerik_loop *loop =
	    sinumerik->loops.count ? &sinumerik->loops.items[sinumerik->loops.count - 1] : NULL;

	return loop && loop->level == sinumerik->calls.level ? loop : NULL;
}

/*
 * The loop that begins in the current line: the active one, or a new one. NULL: there are too many, which was
 * reported.
 */
static struct sinumerik_loop *begin(const struct flow *flow, enum sinumerik_loop_kind kind)
{
	struct sinumerik *sinumerik = flow->sinumerik;
	const struct position start = source_here(flow->interp->program.source);
	struct sinumerik_loop *loop;

	for (size_t i = sinumerik->loops.count; i-- > 0 && sinumerik->loops.items[i].level == sinumerik->calls.level;) {
		if (sinumerik->loops.items[i].start.line == start.line &&
		    sinumerik->loops.items[i].start.source == start.source) {
			sinumerik->loops.count = i + 1;
			return &sinumerik->loops.items[i];
		}
	}
	if (sinumerik->loops.count == SINUMERIK_LOOPS_MAX) {
		fault_report(flow->lexer->at, flow->column, "more than %d loops inside each other",
			     SINUMERIK_LOOPS_MAX);
		return NULL;
	}
	loop = &sinumerik->loops.items[sinumerik->loops.count++];
	*loop = (struct sinumerik_loop){.kind = kind, .start = start, .level = sinumerik->calls.level};
	return loop;
}

static bool jump_behind(const struct flow *flow, enum sinumerik_close close)
{
	struct position behind;

	flow->sinumerik->loops.count--;
	return sinumerik_seek_close(flow->interp, close, flow->column, &behind) && jump_to(flow, &behind);
}

static bool run_while(struct flow *flow)
{
	bool holds;

	if (!begin(flow, SINUMERIK_WHILE) || !condition(flow, &holds) || !at_end(flow))
		return false;
	return holds || jump_behind(flow, SINUMERIK_ENDWHILE);
}

static bool run_loop(struct flow *flow)
{
	return begin(flow, SINUMERIK_LOOP) && at_end(flow);
}

/* The variable that FOR counts: an R parameter, or an INT or REAL of the program. NULL: an error was reported. */
static double *counter(const struct flow *flow)
{
	const int column = lexer_next_column(flow->lexer);
	struct sinumerik_variable *variable;
	char name[SINUMERIK_NAME + 1];
	int found, number;

	if (!sinumerik_name_read(flow->lexer, name)) {
		fault_report(flow->lexer->at, column, "FOR needs a variable");
		return NULL;
	}
	if (name[0] == 'R' && name[1 + strspn(name + 1, "0123456789")] == '\0')
		return sinumerik_expr_r_number(flow->interp, flow->lexer, name, &number)
			   ? &flow->sinumerik->variables.r[number]
			   : NULL;
	found = sinumerik_variables_find(flow->sinumerik, name);
	variable = found < 0 ? NULL : &flow->sinumerik->variables.items[found];
	if (!variable && name[1]) {
		sinumerik_gud_ask(flow->lexer, name, false, column);
		return NULL;
	}
	if (!variable || !variable->numbers || variable->dimensions > 0) {
		fault_report(flow->lexer->at, column,
			     "%s is no variable of this program that FOR can count; DEF makes one", name);
		return NULL;
	}
	sinumerik_variables_mark(variable, 0);
	return &variable->numbers[0];
}

/* 840D sl, "Count loop (FOR ... TO ..., ENDFOR)": the variable grows by 1 in each round. */
static bool run_for(struct flow *flow)
{
	struct sinumerik_loop *loop = begin(flow, SINUMERIK_FOR);
	double *value = loop ? counter(flow) : NULL, first, last;
	int column;

	if (!value || !sinumerik_name_need(flow->lexer, '=', "the variable of FOR") ||
	    !sinumerik_expr_number(flow->interp, flow->lexer, &first))
		return false;
	if (!sinumerik_name_take(flow->lexer, "TO"))
		return fault(flow->lexer->at, lexer_next_column(flow->lexer), "TO is needed here");
	column = lexer_next_column(flow->lexer);
	if (!sinumerik_expr_number(flow->interp, flow->lexer, &last) || !at_end(flow))
		return false;
	if (loop->again && !(fabs(last - loop->last) <= 0))
		return fault(
		    flow->lexer->at, column,
		    "the end of this count has changed since its first round; whether a control heeds that is not "
		    "certain");
	*value = loop->again ? *value + 1 : first;
	loop->last = last;
	loop->again = false;
	return *value <= last || jump_behind(flow, SINUMERIK_ENDFOR);
}

static const struct closing {
	const char *word, *opening;
	enum sinumerik_loop_kind kind;
} closings[] = {{"ENDWHILE", "WHILE", SINUMERIK_WHILE},
		{"ENDFOR", "FOR", SINUMERIK_FOR},
		{"ENDLOOP", "LOOP", SINUMERIK_LOOP},
		{"UNTIL", "REPEAT", SINUMERIK_REPEAT}};

static bool run_closing(struct flow *flow, const struct closing *closing)
{
	struct sinumerik_loop *loop = top_loop(flow);
	bool ends = false;

	if (!loop || loop->kind != closing->kind)
		return fault(flow->lexer->at, flow->column, "%s closes no %s that has begun", closing->word,
			     closing->opening);
	if (closing->kind == SINUMERIK_REPEAT && !condition(flow, &ends))
		return false;
	if (!at_end(flow))
		return false;
	loop->again = true;
	/* After an error every block is read once, because the value of a condition is not known any more. */
	if (!ends && !flow->interp->faulty)
		return jump_to(flow, &loop->start);
	flow->sinumerik->loops.count--;
	return true;
}

/* ------------------------------------------------------------------- jumps */

static bool close_of(enum sinumerik_loop_kind kind, enum sinumerik_close *close)
{
	static const enum sinumerik_close closes[] = {[SINUMERIK_WHILE] = SINUMERIK_ENDWHILE,
						      [SINUMERIK_FOR] = SINUMERIK_ENDFOR,
						      [SINUMERIK_LOOP] = SINUMERIK_ENDLOOP,
						      [SINUMERIK_REPEAT] = SINUMERIK_UNTIL};

	*close = closes[kind];
	return true;
}

/* The jump leaves all loops that do not contain the line. */
static bool leave_loops(const struct flow *flow, long line)
{
	struct sinumerik_loop *loop;

	while ((loop = top_loop(flow)) != NULL) {
		enum sinumerik_close close;
		struct position behind;

		if (!loop->end && close_of(loop->kind, &close)) {
			if (!sinumerik_seek_close_of(flow->interp, close, &loop->start, flow->column, &behind))
				return false;
			loop->end = behind.line - 1;
		}
		if (line > loop->start.line && line <= loop->end)
			return true;
		flow->sinumerik->loops.count--;
	}
	return true;
}

struct jump {
	bool given;	/* a word of a jump */
	bool may_miss;	/* GOTOC */
	bool to_start;	/* GOTOS: it has no target */
	enum sinumerik_direction direction;
	char target[SINUMERIK_NAME + 1];
	int column;
};

/* Executes "GOTOF LABEL" if a jump comes next. False: an error was reported. */
static bool read_jump(const struct flow *flow, struct jump *jump)
{
	static const struct {
		const char *word;
		enum sinumerik_direction direction;
		bool may_miss;
	} words[] = {{"GOTOF", SINUMERIK_FORWARD, false}, {"GOTOB", SINUMERIK_BACKWARD, false},
		     {"GOTOC", SINUMERIK_ANYWHERE, true}, {"GOTO", SINUMERIK_ANYWHERE, false}};
	struct lexer *lexer = flow->lexer;
	struct sinumerik_text text;

	*jump = (struct jump){.given = false};
	for (size_t i = 0; i < sizeof(words) / sizeof(words[0]) && !jump->given; i++) {
		jump->given = sinumerik_name_take(lexer, words[i].word);
		jump->direction = words[i].direction;
		jump->may_miss = words[i].may_miss;
	}
	if (!jump->given)
		jump->given = jump->to_start = sinumerik_name_take(lexer, "GOTOS");
	if (!jump->given)
		return true;
	jump->column = lexer_next_column(lexer);
	if (jump->to_start)
		return true;
	if (lexer_peek(lexer) == '"' || sinumerik_expr_is_text(flow->interp, lexer)) {
		if (!sinumerik_expr_text(flow->interp, lexer, &text))
			return false;
		for (size_t i = 0; i <= strlen(text.bytes) && i < sizeof(jump->target) - 1; i++)
			jump->target[i] = ascii_upper(text.bytes[i]);
		return true;
	}
	return sinumerik_name_read(lexer, jump->target) ||
	       fault(lexer->at, jump->column, "the label or block number to jump to is needed here");
}

/* Back to the start of the main program. */
static bool start_again(const struct flow *flow, const struct jump *jump)
{
	const struct position top = sinumerik_seek_top(flow->interp);

	if (sinumerik_call_is_inside(flow->interp))
		return fault(flow->lexer->at, jump->column, "GOTOS in a subprogram is not supported");
	if (flow->interp->faulty)
		return true;
	flow->sinumerik->loops.count = 0;
	return sinumerik_call_jumped(flow->interp, top.line, jump->column) && jump_to(flow, &top);
}

static bool make_jump(const struct flow *flow, const struct jump *jump)
{
	struct position to;
	bool found;

	if (jump->to_start)
		return start_again(flow, jump);
	if (!sinumerik_seek_label(flow->interp, jump->target, jump->direction, jump->column, &to, &found))
		return false;
	if (!found && jump->may_miss)
		return true;
	if (found && flow->interp->faulty && to.line <= flow->interp->at.line)
		return true;
	if (!found)
		return fault(flow->lexer->at, jump->column, "there is no label %s %s", jump->target,
			     jump->direction == SINUMERIK_FORWARD    ? "from here on"
			     : jump->direction == SINUMERIK_BACKWARD ? "before this line"
								     : "in this program");
	return leave_loops(flow, to.line) && sinumerik_call_jumped(flow->interp, to.line, jump->column) &&
	       jump_to(flow, &to);
}

static bool run_goto(struct flow *flow, size_t word)
{
	struct jump jump;

	flow->lexer->position = word;
	return read_jump(flow, &jump) && at_end(flow) && make_jump(flow, &jump);
}

/* IF ... ENDIF, or IF condition GOTOF label. A line may have several of the latter. */
static bool run_if(struct flow *flow)
{
	struct position behind;
	struct jump jump;
	bool holds;

	do {
		if (!condition(flow, &holds) || !read_jump(flow, &jump))
			return false;
		if (jump.given && holds)
			return make_jump(flow, &jump);
	} while (jump.given && sinumerik_name_take(flow->lexer, "IF"));
	if (!at_end(flow))
		return false;
	if (jump.given)
		return true;
	if (!sinumerik_seek_close(flow->interp, SINUMERIK_ELSE, flow->column, &behind))
		return false;
	return holds || jump_to(flow, &behind);
}

static bool run_else(struct flow *flow)
{
	struct position behind;

	return at_end(flow) && sinumerik_seek_close(flow->interp, SINUMERIK_ENDIF, flow->column, &behind) &&
	       jump_to(flow, &behind);
}

static bool read_constant(const struct flow *flow, double *value)
{
	bool point;

	return number_read(flow->lexer->at->text, &flow->lexer->position, value, &point) == NUMBER_OK ||
	       fault(flow->lexer->at, lexer_next_column(flow->lexer), "a number is needed here");
}

/* CASE (value) OF 1 GOTOF A 2 GOTOF B DEFAULT GOTOF C */
static bool run_case(struct flow *flow)
{
	struct jump jump, taken = {.given = false};
	double value, constant;

	if (!sinumerik_expr_number(flow->interp, flow->lexer, &value))
		return false;
	if (!sinumerik_name_take(flow->lexer, "OF"))
		return fault(flow->lexer->at, lexer_next_column(flow->lexer), "OF is needed here");
	while (lexer_peek(flow->lexer) != '\0' && lexer_peek(flow->lexer) != ';') {
		const bool otherwise = sinumerik_name_take(flow->lexer, "DEFAULT");

		if (!otherwise && !read_constant(flow, &constant))
			return false;
		if (!read_jump(flow, &jump))
			return false;
		if (!jump.given)
			return fault(flow->lexer->at, lexer_next_column(flow->lexer),
				     "GOTOF, GOTOB, GOTO or GOTOC is needed here");
		if (!taken.given && (otherwise || fabs(value - constant) <= 0))
			taken = jump;
	}
	return !taken.given || make_jump(flow, &taken);
}

static bool run_repeat_word(struct flow *flow)
{
	const char byte = lexer_peek(flow->lexer);

	if (byte != '\0' && byte != ';')
		return sinumerik_part_repeat(flow->interp, flow->lexer, false);
	return begin(flow, SINUMERIK_REPEAT) != NULL;
}

bool sinumerik_flow_run(struct interp *interp, struct lexer *lexer, bool *done)
{
	static const struct {
		const char *word;
		bool (*run)(struct flow *flow);
	} words[] = {{"IF", run_if},   {"ELSE", run_else}, {"WHILE", run_while}, {"FOR", run_for},
		     {"LOOP", run_loop}, {"CASE", run_case}, {"REPEAT", run_repeat_word}};
	struct flow flow = {interp, lexer, sinumerik_of(interp), lexer_next_column(lexer)};
	const size_t start = lexer->position;
	char name[SINUMERIK_NAME + 1];

	*done = true;
	if (!sinumerik_name_read(lexer, name))
		name[0] = '\0';
	for (size_t i = 0; i < sizeof(words) / sizeof(words[0]); i++) {
		if (!strcmp(words[i].word, name))
			return words[i].run(&flow);
	}
	for (size_t i = 0; i < sizeof(closings) / sizeof(closings[0]); i++) {
		if (!strcmp(closings[i].word, name))
			return run_closing(&flow, &closings[i]);
	}
	if (!strcmp(name, "ENDIF"))
		return at_end(&flow);
	if (!strncmp(name, "GOTO", 4) && (name[4] == '\0' || (strchr("FBCS", name[4]) && name[5] == '\0')))
		return run_goto(&flow, start);
	if (!strcmp(name, "REPEATB"))
		return sinumerik_part_repeat(interp, lexer, true);
	*done = false;
	lexer->position = start;
	return true;
}
