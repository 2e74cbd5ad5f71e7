#include "gcode/dialect/klartext/klartext_statement.h"

#include <string.h>

#include "base/ascii.h"
#include "gcode/dialect/klartext/cycles/klartext_contour.h"
#include "gcode/dialect/klartext/cycles/klartext_define.h"
#include "gcode/dialect/klartext/cycles/klartext_pattern_define.h"
#include "gcode/dialect/klartext/cycles/klartext_point_table.h"
#include "gcode/dialect/klartext/flow/klartext_flow.h"
#include "gcode/dialect/klartext/frames/klartext_frame.h"
#include "gcode/dialect/klartext/frames/klartext_transform.h"
#include "gcode/dialect/klartext/machine/klartext_function.h"
#include "gcode/dialect/klartext/machine/klartext_tool.h"
#include "gcode/dialect/klartext/moves/klartext_comp.h"
#include "gcode/dialect/klartext/path/klartext_approach.h"
#include "gcode/dialect/klartext/path/klartext_call.h"
#include "gcode/dialect/klartext/path/klartext_circle.h"
#include "gcode/dialect/klartext/path/klartext_corner.h"
#include "gcode/dialect/klartext/path/klartext_free.h"
#include "gcode/dialect/klartext/path/klartext_straight.h"
#include "gcode/dialect/klartext/planes/klartext_plane.h"
#include "gcode/dialect/klartext/text/klartext_lexis.h"
#include "gcode/dialect/klartext/values/klartext_formula.h"
#include "gcode/dialect/klartext/values/klartext_kept.h"
#include "gcode/dialect/klartext/values/klartext_string.h"

static bool round_corner(struct lexer *lexer)
{
	return klartext_corner_read(lexer, false);
}

static bool chamfer_corner(struct lexer *lexer)
{
	return klartext_corner_read(lexer, true);
}

/* The unit of lengths is the last word before a comment. *column: of this word. False: it is no unit. */
static bool read_unit(const char *text, int *column, bool *inch)
{
	size_t end = strcspn(text, ";"), start;

	while (end > 0 && (text[end - 1] == ' ' || text[end - 1] == '\t'))
		end--;
	for (start = end; start > 0 && text[start - 1] != ' ' && text[start - 1] != '\t'; start--)
		;
	*column = (int)start + 1;
	*inch = (end - start == 4 && !strncmp(text + start, "INCH", 4)) ||
		(end - start == 2 && !strncmp(text + start, "IN", 2));
	return *inch || (end - start == 2 && !strncmp(text + start, "MM", 2));
}

/* "BEGIN PGM NAME MM" */
static bool begin(struct lexer *lexer)
{
	struct interp *interp = lexer->context;
	struct klartext *klartext = klartext_of(interp);
	int column = lexer_next_column(lexer), unit_column;
	bool inch;

	if (!klartext_take(lexer, "PGM"))
		return fault(lexer->at, column, "BEGIN needs PGM");
	if (klartext->lines.begun && klartext->calls.programs == 0)
		return fault(lexer->at, column, "a second BEGIN PGM before END PGM");
	if (!read_unit(lexer->at->text, &unit_column, &inch))
		return fault(lexer->at, unit_column, "BEGIN PGM ends with the unit of the program, MM or INCH");
	if (klartext->calls.programs && inch != klartext->inch)
		return fault(lexer->at, column, "a program in %s that one in %s calls is not supported",
			     inch ? "inches" : "mm", inch ? "mm" : "inches");
	klartext->inch = inch;
	klartext->lines.begun = true;
	interp->state.scale = inch ? state_unit(G20) : state_unit(G21);
	if (klartext->calls.programs == 0)
		klartext->programmed = klartext_frame_point(interp);
	return klartext->calls.programs > 0 || klartext_kept_load(lexer);
}

bool klartext_statement_end(struct lexer *lexer)
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
    {"END", klartext_statement_end, true, true},
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

bool klartext_statement_is_known(const char *word)
{
	return find_statement(word) != NULL;
}

bool klartext_statement_begins(const char *word)
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

bool klartext_statement_starts_word(const char *word, char behind)
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

bool klartext_statement_run(struct lexer *lexer, bool *bare)
{
	const size_t start = lexer->position;
	const struct statement *statement;
	char word[KLARTEXT_WORD], behind;

	klartext_word(lexer, word);
	behind = lexer->at->text[lexer->position];
	statement = find_statement(word);
	*bare = statement && statement->bare;
	/* "C+45" is an axis; "C X+5" is a circle. */
	if (statement && !(word[1] == '\0' && word[0] == 'C' && klartext_statement_starts_word(word, behind)))
		return check_comp(lexer, statement) && run_statement(lexer, statement, start);
	lexer->position = start;
	if (word[0] == 'Q') {
		*bare = true;
		return klartext_formula_assign(lexer);
	}
	if (klartext_statement_starts_word(word, behind))
		return klartext_straight_run(lexer);
	return fault(lexer->at, lexer_next_column(lexer), "%s is no block of this control", word[0] ? word : "this");
}
