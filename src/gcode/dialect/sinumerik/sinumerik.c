#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "base/mem.h"
#include "gcode/dialect/dialects.h"
#include "gcode/dialect/sinumerik/block/sinumerik_synchronous.h"
#include "gcode/dialect/sinumerik/builder/sinumerik_gud.h"
#include "gcode/dialect/sinumerik/cycles/sinumerik_contour.h"
#include "gcode/dialect/sinumerik/cycles/sinumerik_pattern.h"
#include "gcode/dialect/sinumerik/flow/sinumerik_call.h"
#include "gcode/dialect/sinumerik/flow/sinumerik_flow.h"
#include "gcode/dialect/sinumerik/flow/sinumerik_part.h"
#include "gcode/dialect/sinumerik/flow/sinumerik_proc.h"
#include "gcode/dialect/sinumerik/flow/sinumerik_program.h"
#include "gcode/dialect/sinumerik/flow/sinumerik_seek.h"
#include "gcode/dialect/sinumerik/path/sinumerik_comp.h"
#include "gcode/dialect/sinumerik/path/sinumerik_soft.h"
#include "gcode/dialect/sinumerik/sinumerik_run.h"
#include "gcode/dialect/sinumerik/values/sinumerik_assign.h"
#include "gcode/dialect/sinumerik/values/sinumerik_expr.h"
#include "gcode/dialect/sinumerik/values/sinumerik_macro.h"
#include "gcode/dialect/sinumerik/values/sinumerik_variables.h"
#include "gcode/dialect/sinumerik/words/sinumerik_name.h"
#include "gcode/dialect/standard_codes.h"
#include "gcode/eval/expr.h"
#include "gcode/execute/corner_insert.h"
#include "gcode/execute/cutter_comp/cutter_comp.h"
#include "gcode/execute/motion_commands.h"
#include "gcode/program.h"

/* At the first line: the modes that this control has at power-on, beside those of state_init. */
static void begin(struct interp *interp)
{
	struct sinumerik *sinumerik = sinumerik_of(interp);
	const double basic = interp->config->controller.unit;

	/* Group 1: G1 is active after power-on and reset. */
	interp->state.motion = G1;
	interp->state.system = SYSTEM_NONE;
	if (interp->config->controller.power_on_work_offset > 1)
		interp->state.system = interp->config->controller.power_on_work_offset - 2;
	sinumerik->frames.work_selected = interp->config->controller.power_on_work_offset > 0;
	state_update_offset(&interp->state);
	sinumerik->feed_scale = basic > 0 ? basic : 1;
	sinumerik->path.code = SINUMERIK_G(64);
	sinumerik->comp.approach = sinumerik->comp.corner = CODE_NONE;
	sinumerik->tool.edge_unsure = interp->state.tool != 0;
	for (int group = 0; group < G_GROUPS; group++)
		interp->block.g[group] = CODE_NONE;
	for (int group = 0; group < M_GROUPS; group++)
		interp->block.m[group] = CODE_NONE;
	interp->block.words = 1;
}

static bool ends_block(struct lexer *lexer)
{
	const char byte = lexer_peek(lexer);

	return byte == '\0' || byte == ';' ||
	       fault(lexer->at, lexer_next_column(lexer), "what follows here is not supported");
}

/* CALL "NAME", EXTCALL("NAME") */
static bool call_by_text(struct interp *interp, struct lexer *lexer)
{
	const bool brackets = sinumerik_name_take_byte(lexer, '(');
	const int column = lexer_next_column(lexer);
	struct sinumerik_text path;
	char name[SINUMERIK_NAME + 1], type;

	if (!brackets && sinumerik_name_take(lexer, "BLOCK"))
		return sinumerik_part_call(interp, lexer);
	if (!sinumerik_expr_text(interp, lexer, &path) ||
	    (brackets && !sinumerik_name_need(lexer, ')', "the name of the subprogram")) ||
	    !sinumerik_program_name(interp, path.bytes, column, name, &type))
		return false;
	if (sinumerik_name_take(lexer, "BLOCK"))
		return fault(lexer->at, column,
			     "CALL BLOCK of a part of another program is not supported; CALL BLOCK of a part of this "
			     "one is, and so is a call of the whole other one");
	if (!ends_block(lexer))
		return false;
	sinumerik_of(interp)->passed.count = 0;
	return sinumerik_call_run(interp, name, type, 1, column);
}

/* PCALL/_N_WKS_DIR/_N_PART_WPD/NAME(1,2): the path has no quotes. */
static bool call_by_path(struct interp *interp, struct lexer *lexer)
{
	const int column = lexer_next_column(lexer);
	char path[SINUMERIK_TEXT + 1], name[SINUMERIK_NAME + 1], type;
	size_t length = 0;

	if (lexer_peek(lexer) == '"')
		return fault(lexer->at, column, "the path of PCALL stands without quotes");
	while (sinumerik_is_name(lexer->at->text[lexer->position]) || lexer->at->text[lexer->position] == '/') {
		if (length == SINUMERIK_TEXT)
			return fault(lexer->at, column, "a path of more than %d bytes", SINUMERIK_TEXT);
		path[length++] = lexer->at->text[lexer->position++];
	}
	path[length] = '\0';
	return sinumerik_program_name(interp, path, column, name, &type) && sinumerik_call_arguments(interp, lexer) &&
	       ends_block(lexer) && sinumerik_call_run(interp, name, type, 1, column);
}

/* Declarations and calls. They are not words of a block. */
static bool run_declaration(struct interp *interp, struct lexer *lexer, bool *done)
{
	const size_t start = lexer->position;
	const int column = lexer_next_column(lexer);
	char name[SINUMERIK_NAME + 1];

	if (!sinumerik_name_read(lexer, name))
		name[0] = '\0';
	if (!sinumerik_synchronous_take(interp, lexer, name, done))
		return false;
	if (*done)
		return true;
	*done = true;
	if (!strcmp(name, "DEF"))
		return sinumerik_assign_define(interp, lexer);
	if (!strcmp(name, "DEFINE"))
		return sinumerik_macro_define(interp, lexer);
	if (!strcmp(name, "PROC"))
		return sinumerik_proc_take(interp, lexer);
	if (!strcmp(name, "CALL") || !strcmp(name, "EXTCALL"))
		return call_by_text(interp, lexer);
	if (!strcmp(name, "PCALL"))
		return call_by_path(interp, lexer);
	if (!strcmp(name, "RET")) {
		/* "RET": it stands in a block of its own; its form with arguments is not supported. */
		if (!ends_block(lexer) || !sinumerik_call_check_end(interp, column))
			return false;
		/* A subprogram that was started as the main program ends the program here. */
		if (!sinumerik_call_is_inside(interp)) {
			if (sinumerik_contour_is_read(interp))
				return fault(lexer->at, column, "the program ends in the contour of CYCLE72");
			interp->ended = true;
			return sinumerik_comp_stop(interp, column, true) && motion_commands_spindle_stops(interp);
		}
		return sinumerik_call_return(interp, column);
	}
	*done = false;
	lexer->position = start;
	return true;
}

/* The words of a line: a statement or a block. */
static bool run_words(struct interp *interp, struct lexer *lexer)
{
	const char *text = lexer->at->text + lexer->position;
	struct sinumerik_block block;
	bool done = false;

	interp->moves = 0;
	/* Every statement begins with two letters or more. */
	if (sinumerik_starts_name(text[0]) && sinumerik_starts_name(text[1])) {
		if (!run_declaration(interp, lexer, &done) || (!done && !sinumerik_flow_run(interp, lexer, &done)))
			return false;
	}
	if (done)
		return true;
	sinumerik_block_clear(&block);
	return sinumerik_block_read(interp, lexer, &block) && sinumerik_run(interp, lexer, &block);
}

/*
 * "%" or "%_N_NAME_MPF". Before the first block it is the head of the program; blank lines and comments may precede
 * it.
 */
static bool take_percent(struct interp *interp)
{
	const char *rest = line_start(&interp->at) + 1;
	const bool first = !sinumerik_of(interp)->headed, head = first || sinumerik_of(interp)->calls.entering;

	sinumerik_of(interp)->headed = true;
	if (head)
		return !first || sinumerik_seek_main(interp);
	/*
	 * Alone, '%' is the end of the tape. With a name another program begins. Both end this program like the end
	 * of the file.
	 */
	if (!sinumerik_call_is_inside(interp) && sinumerik_seek_heads_main(line_start(&interp->at)))
		return fault(&interp->at, 1,
			     "another main program begins here, which is not checked: give it a file of its own");
	if (rest[strspn(rest, " \t")] != '\0' || !sinumerik_call_is_inside(interp)) {
		interp->ended = true;
		return sinumerik_call_end_of_file(interp);
	}
	return fault(&interp->at, 1,
		     "'%%' ends the tape, but a subprogram is being carried out: M17 or RET is missing");
}

static bool is_proc(const char *words)
{
	return !strncmp(words, "PROC", 4) || !strncmp(words, "proc", 4);
}

/* This dialect reads every line itself, so the common reader of words never runs. */
static bool read_line(struct interp *interp, bool *done)
{
	const struct line_place at = interp->at;
	struct sinumerik_head head;
	struct lexer lexer;
	bool left;

	if (!sinumerik_of(interp)->begun) {
		begin(interp);
		sinumerik_of(interp)->begun = true;
		if (!sinumerik_gud_make(interp))
			return false;
	}
	*done = true;
	if (!sinumerik_call_round(interp, &left))
		return false;
	if (left)
		return true;
	if (*line_start(&at) == '%')
		return take_percent(interp);
	if (sinumerik_pattern_waits(interp))
		return sinumerik_pattern_go_on(interp);
	if (sinumerik_contour_waits(interp))
		return sinumerik_contour_end(interp);
	head = sinumerik_seek_head(at.text);
	if (at.text[head.rest] == ';' || at.text[head.rest] == '\0') {
		if (!head.number[0] && !head.label[0])
			return true;
	} else if (!sinumerik_call_check_last(interp, (int)head.rest + 1)) {
		return false;
	}
	sinumerik_of(interp)->headed = true;
	if (head.skipped && interp->config->read.block_delete)
		return true;
	if (sinumerik_of(interp)->calls.entering && !is_proc(at.text + head.rest) && !sinumerik_proc_none(interp))
		return false;
	if (sinumerik_of(interp)->calls.depth &&
	    !program_count(&interp->program, interp->config->read.max_blocks, &interp->at))
		return false;
	sinumerik_macro_expand(interp, head.rest);
	lexer = (struct lexer){.at = &interp->at, .position = head.rest};
	if (!run_words(interp, &lexer))
		return false;
	if (sinumerik_soft_keeps_block(interp))
		return true;
	if (!sinumerik_soft_end_block(interp))
		return false;
	if (corner_insert_keeps_block(interp))
		return corner_insert_end_block(interp);
	return corner_insert_end_block(interp) && cutter_comp_end_block(interp);
}

/* SUPA, G74, G75 and M6 do not change the tool length; only D does. */
static void keep_length(struct interp *interp, int code, const bool moved[SLOT_COUNT])
{
	(void)interp;
	(void)code;
	(void)moved;
}

static void *new_state(void)
{
	struct sinumerik *sinumerik = mem_zalloc(1, sizeof(*sinumerik));

	sinumerik->frames.programmed.matrix = sinumerik->frames.swivel.matrix = mat3_identity();
	sinumerik->frames.even = true;
	for (size_t i = 0; i < SINUMERIK_R_COUNT; i++)
		sinumerik->variables.r[i] = NAN;
	return sinumerik;
}

static void free_state(void *state)
{
	struct sinumerik *sinumerik = state;

	sinumerik_variables_leave(sinumerik, SINUMERIK_LEVEL_OF_CONTROL - 1);
	free(sinumerik->variables.items);
	free(sinumerik->tool.names);
	labels_release(&sinumerik->search.labels);
	labels_release(&sinumerik->calls.folders);
	labels_release(&sinumerik->calls.programs);
	sinumerik_macro_release(sinumerik);
	sinumerik_soft_release(sinumerik);
	free(sinumerik);
}

const struct dialect dialect_sinumerik = {
	.name = "sinumerik",
	.manual = "Siemens SINUMERIK 840D sl, programming manuals \"Fundamentals\", \"Job planning\", \"Cycles\"",
	.g_codes = {&sinumerik_g_codes, &sinumerik_offset_codes},
	.m_codes = {&basic_m_codes, &sinumerik_m_codes},
	.words = {&sinumerik_word_set, &sinumerik_cycle_set},
	.traits = {
		/*
		 * MD20150 sets the other modes at power-on. G64 is assumed because it lets the control leave the path
		 * the farthest.
		 */
		.power_on = {.feed_mode = G94, .path = G64},
		.whole_numbers = WHOLE_NUMBERS_UNITS,
		.known_order = ANSWER_YES,
		.text_before_percent = ANSWER_NO,
		.arc_centre = ARC_CENTRE_INCREMENTAL,
		.arcs_have_turns = ANSWER_NO,
		.wrap_below_turn = ANSWER_NO,
		.g53_under_tcp = G53_UNDER_TCP_AXES,
		.t_word = T_WORD_SELECTS,
		/* SD42110 is the feed of a program that gives none; where it is 0, the control stops (alarm 10860). */
		.feed_missing = FEED_MISSING_KEPT,
		.corner_words = CORNER_WORDS_WITH_ARCS,
		.idle_blocks_parameter = "MD20250",
		.corner_names = "CHF, CHR or RND",
		.tool_change_stays = ANSWER_NO,
	},
	.after_machine_move = keep_length,
	.state_new = new_state,
	.state_free = free_state,
	.statement = read_line,
	.end_of_file = sinumerik_call_end_of_file,
	.heads_main = sinumerik_seek_heads_main,
	.caller = sinumerik_call_caller,
};
