#include "gcode/dialect/klartext/klartext_line.h"

#include <string.h>

#include "base/ascii.h"
#include "gcode/dialect/klartext/klartext_approach.h"
#include "gcode/dialect/klartext/klartext_call.h"
#include "gcode/dialect/klartext/klartext_circle.h"
#include "gcode/dialect/klartext/klartext_comp.h"
#include "gcode/dialect/klartext/klartext_contour.h"
#include "gcode/dialect/klartext/klartext_corner.h"
#include "gcode/dialect/klartext/klartext_define.h"
#include "gcode/dialect/klartext/klartext_flow.h"
#include "gcode/dialect/klartext/klartext_formula.h"
#include "gcode/dialect/klartext/klartext_frame.h"
#include "gcode/dialect/klartext/klartext_free.h"
#include "gcode/dialect/klartext/klartext_function.h"
#include "gcode/dialect/klartext/klartext_join.h"
#include "gcode/dialect/klartext/klartext_kept.h"
#include "gcode/dialect/klartext/klartext_lexis.h"
#include "gcode/dialect/klartext/klartext_straight.h"
#include "gcode/dialect/klartext/klartext_pattern_define.h"
#include "gcode/dialect/klartext/klartext_plane.h"
#include "gcode/dialect/klartext/klartext_point_table.h"
#include "gcode/dialect/klartext/klartext_skip.h"
#include "gcode/dialect/klartext/klartext_string.h"
#include "gcode/dialect/klartext/klartext_tool.h"
#include "gcode/dialect/klartext/klartext_transform.h"
#include "gcode/execute/cutter_comp/cutter_comp.h"

/* ------------------------------------------------------------------ blocks */

static bool round_corner(struct lexer *lexer)
{
	return klartext_corner_read(lexer, false);
}

static bool chamfer_corner(struct lexer *lexer)
{
	return klartext_corner_read(lexer, true);
}

/* "BEGIN PGM NAME MM": the unit of lengths. */
static bool begin(struct lexer *lexer)
{
	struct interp *interp = lexer->context;
	struct klartext *klartext = klartext_of(interp);
	int column = lexer_next_column(lexer);
	const char *text = lexer->at->text, *unit;
	size_t length = strcspn(text, ";");

	if (!klartext_take(lexer, "PGM"))
		return fault(lexer->at, column, "BEGIN needs PGM");
	while (length > 0 && (text[length - 1] == ' ' || text[length - 1] == '\t'))
		length--;
	unit = text + length;
	while (unit > text && unit[-1] != ' ' && unit[-1] != '\t')
		unit--;
	length = (size_t)(text + length - unit);
	if (klartext->lines.begun && klartext->calls.programs == 0)
		return fault(lexer->at, column, "a second BEGIN PGM before END PGM");
	if (length == 2 && !strncmp(unit, "MM", 2)) {
		if (klartext->calls.programs && klartext->inch)
			return fault(lexer->at, column,
				     "a program in mm that one in inches calls is not supported");
		klartext->inch = false;
	} else if ((length == 4 && !strncmp(unit, "INCH", 4)) || (length == 2 && !strncmp(unit, "IN", 2))) {
		if (klartext->calls.programs && !klartext->inch)
			return fault(lexer->at, column,
				     "a program in inches that one in mm calls is not supported");
		klartext->inch = true;
	} else {
		return fault(lexer->at, (int)(unit - text) + 1,
			     "BEGIN PGM ends with the unit of the program, MM or INCH");
	}
	klartext->lines.begun = true;
	interp->state.scale = klartext->inch ? state_unit(G20) : state_unit(G21);
	if (klartext->calls.programs == 0)
		klartext->programmed = klartext_frame_point(interp);
	return klartext->calls.programs > 0 || klartext_kept_load(lexer);
}

static bool end(struct lexer *lexer)
{
	return klartext_take(lexer, "PGM") ? klartext_flow_end(lexer)
					   : fault(lexer->at, lexer_next_column(lexer), "END needs PGM");
}

/* Blocks that neither move anything nor change what moves do. */
static bool ignore(struct lexer *lexer)
{
	(void)lexer;
	return true;
}

/*
 * TNC7 user's manual, "Process monitoring": "SECTION MONITORING START" and "STOP", on older ones "MONITORING SECTION".
 */
static bool section(struct lexer *lexer)
{
	return klartext_take(lexer, "MONITORING") ||
	       fault(lexer->at, lexer_next_column(lexer), "SECTION needs MONITORING");
}

static bool tool(struct lexer *lexer)
{
	if (klartext_take(lexer, "CALL"))
		return klartext_tool_call(lexer);
	if (klartext_take(lexer, "DEF"))
		return klartext_tool_define(lexer);
	return fault(lexer->at, lexer_next_column(lexer), "TOOL needs CALL or DEF");
}

static bool cycle(struct lexer *lexer)
{
	if (klartext_take(lexer, "DEF"))
		return klartext_define_read(lexer);
	if (klartext_take(lexer, "CALL"))
		return klartext_call_run(lexer);
	return fault(lexer->at, lexer_next_column(lexer), "CYCL needs DEF or CALL");
}

/* Some posts write CYCLE for CYCL. A control that does not accept it stops there, so nothing moves. */
static bool cycle_in_full(struct lexer *lexer)
{
	struct klartext_lines *lines = &klartext_of(lexer->context)->lines;

	if (!lines->cautioned_cycle)
		caution(lexer->at, 1, "CYCLE is read as CYCL, which is how this control writes it");
	lines->cautioned_cycle = true;
	return cycle(lexer);
}

static bool choose(struct lexer *lexer)
{
	if (klartext_take(lexer, "TABLE"))
		return klartext_transform_table(lexer);
	return klartext_take(lexer, "PATTERN") ? klartext_point_table_select(lexer) : klartext_flow_select(lexer);
}

static bool probe(struct lexer *lexer)
{
	return klartext_take(lexer, "PROBE") ? klartext_define_probe(lexer)
					     : fault(lexer->at, lexer_next_column(lexer), "TCH needs PROBE");
}

/* The most frequent statements come first. `bare`: no event is sent for such a block. */
static const struct statement {
	const char *word;
	bool (*run)(struct lexer *lexer);
	bool bare;
	bool compensated; /* is allowed under radius compensation */
} statements[] = {
    {"L", klartext_straight_run, false, true},
    {"CC", klartext_circle_pole, false, true},
    {"C", klartext_circle_about_pole, false, true},
    {"CR", klartext_circle_by_radius, false, true},
    {"CT", klartext_circle_tangential, false, true},
    {"LN", klartext_straight_run_normal, false, false},
    {"LP", klartext_circle_polar_line, false, true},
    {"CP", klartext_circle_polar, false, true},
    {"CTP", klartext_circle_tangential_polar, false, true},
    {"RND", round_corner, false, true},
    {"CHF", chamfer_corner, false, true},
    {"CYCL", cycle, false, false},
    {"CYCLE", cycle_in_full, false, false},
    {"LBL", klartext_flow_label, true, true},
    {"CALL", klartext_flow_call, true, true},
    {"FN", klartext_function_run, true, true},
    {"TOOL", tool, false, false},
    {"PLANE", klartext_plane_run, false, false},
    {"FUNCTION", klartext_function_mode, false, false},
    {"STOP", klartext_straight_run, false, false},
    {"BEGIN", begin, true, true},
    {"END", end, true, true},
    {"BLK", ignore, true, true},
    {"MONITORING", ignore, true, true},
    {"SECTION", section, true, true},
    {"APPR", klartext_approach_read, false, true},
    {"DEP", klartext_approach_depart, false, true},
    {"TCH", probe, false, false},
    {"GLOBAL", klartext_define_read_global, false, false},
    {"PATTERN", klartext_pattern_define_read, true, false},
    {"POS", klartext_pattern_define_go_on, true, false},
    {"ROW", klartext_pattern_define_go_on, true, false},
    {"PAT", klartext_pattern_define_go_on, true, false},
    {"FRAME", klartext_pattern_define_go_on, true, false},
    {"CIRC", klartext_pattern_define_go_on, true, false},
    {"PITCHCIRC", klartext_pattern_define_go_on, true, false},
    {"DECLARE", klartext_string_declare, true, true},
    {"CONTOUR", klartext_contour_define, true, false},
    {"SEL", choose, true, false},
    {"TRANS", klartext_transform_run, false, false},
    {"PRESET", klartext_transform_preset, false, false},
    {"FL", klartext_free_line, false, true},
    {"FLT", klartext_free_line_tangential, false, true},
    {"FC", klartext_free_circle, false, true},
    {"FCT", klartext_free_circle_tangential, false, true},
    {"FPOL", klartext_free_pole, true, true},
    {"FSELECT", klartext_free_select, true, true},
};

static const struct statement *find_statement(const char *word)
{
	for (size_t i = 0; i < sizeof(statements) / sizeof(statements[0]); i++)
		if (!strcmp(statements[i].word, word))
			return &statements[i];
	return NULL;
}

/* Is this the first word of a block? The further lines of a pattern's definition are not blocks. */
static bool begins_block(const char *word)
{
	const struct statement *statement = find_statement(word);

	return statement && statement->run != klartext_pattern_define_go_on;
}

/*
 * Under radius compensation the next corner determines where a block ends: no statement before the corner may need
 * that end.
 */
static bool check_comp(struct lexer *lexer, const struct statement *statement)
{
	return statement->compensated || !klartext_comp_is_selected(lexer->context) ||
	       fault(lexer->at, lexer_column(lexer),
		     "%s under radius compensation is not supported; a block with R0 comes first", statement->word);
}

/* ------------------------------------------------------------------- lines */

/* Words of a positioning block without L: "X+10 R0 FMAX", "R0 FMAX M99", "M3". */
static bool starts_word(const char *word, char behind)
{
	bool value = ascii_is_digit(behind) || (behind != '\0' && strchr("+-.,Qq", behind) != NULL);
	bool blank = behind == '\0' || behind == ' ' || behind == '\t' || behind == ';';

	if (word[0] == '\0' || (word[0] == 'I' && slot_of_letter(*++word) < 0))
		return false;
	/* "FMAX", "M" and "R" may also have no value. */
	if (!strcmp(word, "FMAX") || !strcmp(word, "RL") || !strcmp(word, "RR"))
		return blank;
	if (word[1] != '\0' && strcmp(word, "MQ") != 0 && strcmp(word, "SQ") != 0 && strcmp(word, "FQ") != 0)
		return word[1] == 'Q' && slot_of_letter(word[0]) >= 0;
	return strchr("MSFR", word[0]) ? value || blank : slot_of_letter(word[0]) >= 0 && value;
}

/* The points of a pattern begin with their own word. */
static bool run_statement(struct lexer *lexer, const struct statement *statement, size_t start)
{
	if (statement->run == klartext_pattern_define_go_on)
		lexer->position = start;
	return statement->run(lexer);
}

/* Carries out a block that begins with a letter. */
static bool run_block(struct lexer *lexer, bool *bare)
{
	const size_t start = lexer->position;
	const struct statement *statement;
	char word[KLARTEXT_WORD], behind;

	klartext_word(lexer, word);
	behind = lexer->at->text[lexer->position];
	statement = find_statement(word);
	*bare = statement && statement->bare;
	/* "C+45" is an axis; "C X+5" is a circle. */
	if (statement && !(word[1] == '\0' && word[0] == 'C' && starts_word(word, behind)))
		return check_comp(lexer, statement) && run_statement(lexer, statement, start);
	lexer->position = start;
	if (word[0] == 'Q') {
		*bare = true;
		return klartext_formula_assign(lexer);
	}
	if (starts_word(word, behind))
		return klartext_straight_run(lexer);
	return fault(lexer->at, lexer_next_column(lexer), "%s is no block of this control", word[0] ? word : "this");
}

/* "%NAME G71" begins a program in DIN/ISO, which these controls read as well. */
static bool refuse_iso(struct lexer *lexer)
{
	return fault(lexer->at, lexer_next_column(lexer),
		     "this is a DIN/ISO program of the control (%%NAME G71); only Klartext is supported");
}

/* Blocks of loops and calls are counted. */
static bool count_block(struct interp *interp)
{
	return !klartext_of(interp)->calls.jumped ||
	       program_count(&interp->program, interp->config->read.max_blocks, &interp->at);
}

/* After M2 and M30 only subprograms follow, up to END PGM: their lines are skipped. */
static bool pass_by(struct lexer *lexer)
{
	return !klartext_take(lexer, "END") || end(lexer);
}

static bool check_begun(struct lexer *lexer)
{
	struct interp *interp = lexer->context;
	const struct klartext *klartext = klartext_of(interp);
	char byte = lexer_peek(lexer);

	if (klartext->lines.begun || klartext_take(lexer, "BEGIN"))
		return true;
	if (byte == '%')
		return refuse_iso(lexer);
	return fault(lexer->at, lexer_next_column(lexer),
		     "a Klartext program begins with BEGIN PGM, which says MM or INCH");
}

/*
 * May this block stand between a corner, or APPR, and the path after it? The block that waits needs that path: blocks
 * between them may change Q parameters, but must not move an axis.
 */
static bool may_follow_corner(const struct lexer *before)
{
	static const char *const words[] = {"RND", "CHF", "CC", "L", "LP", "C", "CR", "CT", "CP", "CTP",
					    "FL",  "FLT", "FC", "FCT", "LBL", "FN"};
	struct lexer lexer = *before;
	char word[KLARTEXT_WORD];

	klartext_word(&lexer, word);
	for (size_t i = 0; i < sizeof(words) / sizeof(words[0]); i++) {
		if (!strcmp(word, words[i]))
			return true;
	}
	return word[0] == 'Q';
}

static bool is_like_block(const struct lexer *before)
{
	struct lexer lexer = *before;
	char word[KLARTEXT_WORD];

	klartext_word(&lexer, word);
	return word[0] == 'Q' || find_statement(word) || starts_word(word, lexer.at->text[lexer.position]);
}

/*
 * Is this line a comment, or does it continue a comment that ends in '~'? Only a line without a block number continues
 * a comment, and only a comment with a block number. So a numbered block is never taken for a comment.
 */
static bool is_comment(struct lexer *lexer, bool numbered)
{
	struct klartext_lines *lines = &klartext_of(lexer->context)->lines;
	const char byte = lexer_peek(lexer);
	const bool begins = byte == ';' || byte == '*', goes_on = lines->comment_goes_on && !numbered;

	lines->comment_goes_on = (goes_on || (begins && numbered)) && klartext_continues(lexer->at->text);
	return byte == '\0' || begins || goes_on;
}

/*
 * Does this line hold words without a block, behind a block whose comment ends in '~'? The words may belong to the
 * comment or to the block, and they would change the block's move.
 */
static bool may_belong_before(struct lexer *lexer, bool numbered)
{
	struct klartext *klartext = klartext_of(lexer->context);
	const char *text = lexer->at->text;
	const bool behind = klartext->lines.tail_goes_on && !numbered;
	struct lexer look = *lexer;
	char word[KLARTEXT_WORD];

	klartext->lines.tail_goes_on = strchr(text, ';') && klartext_continues(text);
	if (behind)
		klartext_word(&look, word);
	return behind && !klartext->cycles.definition.open && !find_statement(word) &&
	       starts_word(word, text[look.position]);
}

static bool take_line(struct lexer *lexer, bool *bare)
{
	struct interp *interp = lexer->context;
	bool numbered = klartext_skip_number(lexer);
	const size_t start = lexer->position;
	char byte = lexer_peek(lexer);

	klartext_of(interp)->lines.numbered = numbered;
	*bare = true;
	if (klartext_of(interp)->lines.comment_goes_on && !numbered && is_like_block(lexer))
		return fault(lexer->at, lexer_next_column(lexer),
			     "'~' has this line belong to the comment before it, but it reads like a block: take the "
			     "'~' away, or begin the line with ';'");
	if (is_comment(lexer, numbered)) {
		klartext_of(interp)->lines.tail_goes_on = false;
		return true;
	}
	if (may_belong_before(lexer, numbered))
		return fault(lexer->at, lexer_next_column(lexer),
			     "'~' behind the comment of the block before leaves open whether this line belongs to it: "
			     "take the '~' away, or write it before the comment's ';' and without the comment");
	if (klartext_of(interp)->lines.behind_end)
		return pass_by(lexer);
	if (!count_block(interp) || !check_begun(lexer))
		return false;
	lexer->position = start;
	lexer_peek(lexer);
	if (byte == '/' && interp->config->read.block_delete)
		return true;
	if (byte == '/') {
		lexer_take(lexer);
		klartext_of(interp)->lines.numbered |= klartext_skip_number(lexer);
		if (klartext_ends(lexer) || lexer_peek(lexer) == '*')
			return true;
	}
	if (klartext_of(interp)->corner.waits && !may_follow_corner(lexer))
		return klartext_corner_check_none(interp);
	if (klartext_of(interp)->approach.waits && !may_follow_corner(lexer))
		return klartext_approach_check_none(interp);
	if (klartext_define_goes_on(lexer, numbered)) {
		*bare = false;
		return klartext_define_line(lexer);
	}
	return run_block(lexer, bare);
}

/*
 * Ends a definition before this line unless the line continues it. Without '~' only a line of parameters continues it.
 */
static bool end_definition(struct interp *interp, const struct lexer *before)
{
	struct lexer lexer = *before;
	struct klartext_cycle *definition = &klartext_of(interp)->cycles.definition;
	bool numbered, slash;

	numbered = klartext_skip_head(&lexer, &slash);
	if (klartext_ends(&lexer) || klartext_define_goes_on(&lexer, numbered))
		return true;
	if ((klartext_take(&lexer, "CYCL") || klartext_take(&lexer, "CYCLE")) && !definition->by_q &&
	    !klartext_take(&lexer, "CALL"))
		return true;
	return klartext_define_end(interp);
}

/* An empty line, or a comment without a block number, which may stand between the lines of a definition. */
static bool says_nothing(const char *text)
{
	const char first = text[strspn(text, " \t")];

	return first == '\0' || first == ';';
}

/* Is this a definition in one line, or the last line of a definition with '~'? */
static bool ends_definition(const struct interp *interp)
{
	const struct klartext_cycle *definition = &klartext_of(interp)->cycles.definition;
	const bool in_one = definition->count > 0 && definition->line == interp->at.line;

	return definition->open && definition->by_q && !klartext_continues(interp->at.text) &&
	       (in_one || (definition->continued && !says_nothing(interp->at.text)));
}

bool klartext_line_run(struct interp *interp, bool *done)
{
	struct klartext_cycle *definition = &klartext_of(interp)->cycles.definition;
	struct lexer lexer;
	bool bare, good;

	*done = true;
	interp->moves = 0;
	if (klartext_skip_definition(interp))
		return true;
	if (!klartext_join(interp, begins_block))
		return false;
	lexer = klartext_lexer(interp);
	/*
	 * A fault of the definition is not a fault of the current line, which may be a label. So the line is carried
	 * out.
	 */
	good = !definition->open || end_definition(interp, &lexer);
	if (!good && !interp->config->read.all_faults)
		return false;
	if (!take_line(&lexer, &bare) || !good)
		return false;
	klartext_of(interp)->sync.holds &= interp->moves == 0;
	definition->continued |= definition->open && definition->count > 0 && klartext_continues(interp->at.text);
	if (ends_definition(interp) && !klartext_define_end(interp))
		return false;
	if (klartext_of(interp)->corner.waits && !bare) {
		klartext_corner_keep_line(interp);
		return true;
	}
	if (klartext_of(interp)->approach.waits && !bare) {
		klartext_approach_keep_line(interp);
		return true;
	}
	/* A block without any move does not count as a block without a move in the plane. */
	interp->comp.moved |= interp->moves == 0;
	return bare || cutter_comp_end_block(interp);
}
