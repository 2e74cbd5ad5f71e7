#include "cli/scan/scan_questions.h"

#include <stddef.h>
#include <stdlib.h>
#include <string.h>

#include "base/mem.h"
#include "cli/scan/any_machine.h"
#include "control/control_variable.h"

/* The largest number of questions for one set of programs; most are about M-codes and programs of the builder. */
#define QUESTIONS_MAX 400
/* A wrong assumed answer may make a loop endless: this number of blocks takes seconds. */
#define BLOCKS_MAX 3000000
#define TOOLS 999
/* G54 to G59.3, G54.1 P1 to P300, G54.4 P1 to P7. */
#define OFFSETS 316
#define OFFSET_NAME 16
/* The object of a question: a number, the name of a program, or the attributes of a variable. */
#define ASKED_NAME 200

struct asked {
	char *text;	/* the text for the machine file */
	char *place;	/* "part.nc:12" */
};

struct scan_questions {
	struct gcode_config config;
	struct asked asked[QUESTIONS_MAX];
	size_t count;
	struct mcode mcodes[QUESTIONS_MAX];
	struct builder_macro macros[QUESTIONS_MAX];
	char macro_names[QUESTIONS_MAX][ASKED_NAME];
	struct control_variable variables[QUESTIONS_MAX];
	char variable_names[QUESTIONS_MAX][CONTROL_VARIABLE_NAME];
	struct tool tools[TOOLS];
	struct length_offset lengths[TOOLS];
	struct radius_offset radii[TOOLS];
	struct work_offset offsets[OFFSETS];
	char names[OFFSETS][OFFSET_NAME];
};

/* Its size suits radius compensation on the outlines of most parts. */
static const struct tool any_tool = {.number = 1,
				     .name = "",
				     .length = 100,
				     .length_offset = 100,
				     .diameter = 1,
				     .point_angle = 2};

static void fill_tables(struct scan_questions *questions)
{
	static const char *const first[] = {"G54", "G55", "G56", "G57", "G58", "G59", "G59.1", "G59.2", "G59.3"};
	struct gcode_config *config = &questions->config;

	for (int i = 0; i < TOOLS; i++) {
		questions->tools[i] = (struct tool){.number = i + 1, .name = "", .length = 100, .length_offset = 100};
		questions->lengths[i] = (struct length_offset){i + 1, 100};
		questions->radii[i] = (struct radius_offset){i + 1, 0};
	}
	for (int i = 0; i < OFFSETS; i++) {
		snprintf(questions->names[i], OFFSET_NAME, "%s", i < 9 ? first[i] : "");
		if (i >= 9)
			snprintf(questions->names[i], OFFSET_NAME, i < 309 ? "G54.1 P%d" : "G54.4 P%d",
				 i < 309 ? i - 8 : i - 308);
		questions->offsets[i] = (struct work_offset){.name = questions->names[i]};
	}
	config->has_setup = true;
	config->tools = questions->tools;
	config->tool_count = TOOLS;
	config->lengths = questions->lengths;
	config->length_count = TOOLS;
	config->radii = questions->radii;
	config->radius_count = TOOLS;
	config->work_offsets = questions->offsets;
	config->work_offset_count = OFFSETS;
}

struct scan_questions *scan_questions_new(const struct dialect *dialect, int max_blocks,
					  const struct file_opened *opened)
{
	struct scan_questions *questions = mem_zalloc(1, sizeof(*questions));

	questions->config.dialect = dialect;
	questions->config.read.max_blocks = max_blocks ? max_blocks : BLOCKS_MAX;
	questions->config.read.opened = opened;
	questions->config.controller.mcodes = questions->mcodes;
	questions->config.controller.macros = questions->macros;
	questions->config.controller.variables = questions->variables;
	for (int slot = 0; slot < SLOT_COUNT; slot++)
		questions->config.has_axis[slot] = true;
	/* Controls without H have tools by name, edges and presets: for these, any tool will do without a setup. */
	if (dialect->traits.h_missing != H_MISSING_UNKNOWN)
		fill_tables(questions);
	else
		questions->config.any_tool = &any_tool;
	return questions;
}

void scan_questions_free(struct scan_questions *questions)
{
	if (!questions)
		return;
	for (size_t i = 0; i < questions->count; i++) {
		free(questions->asked[i].text);
		free(questions->asked[i].place);
	}
	free(questions);
}

/* The answers that need more than a field of the controller; `asked` is the text after `key` in the message. */
static void answer_half_turn(struct scan_questions *q, const char *asked)
{
	(void)asked;
	for (int slot = 0; slot < SLOT_COUNT; slot++)
		q->config.half_turn[slot] = 1;
}

static void answer_wrap(struct scan_questions *q, const char *asked)
{
	(void)asked;
	for (int slot = SLOT_A; slot <= SLOT_C; slot++)
		q->config.wrap[slot] = WRAP_SHORTEST;
}

static void answer_swivel_retract(struct scan_questions *q, const char *asked)
{
	struct control_place *place = &q->config.controller.swivel_retract;

	(void)asked;
	place->given = true;
	for (int slot = SLOT_X; slot <= SLOT_Z; slot++)
		place->has[slot] = true;
}

static void answer_tool_change(struct scan_questions *q, const char *asked)
{
	(void)asked;
	q->config.controller.tool_change.given = true;
}

static void answer_reference(struct scan_questions *q, const char *asked)
{
	const long number = strtol(asked, NULL, 10);
	struct control_place *place;

	if (number < 1 || number > REFERENCES_MAX)
		return;
	place = &q->config.controller.references[number - 1];
	place->given = true;
	for (int slot = 0; slot < SLOT_COUNT; slot++)
		place->has[slot] = true;
}

static void answer_mcode(struct scan_questions *q, const char *asked)
{
	const int number = (int)strtol(asked, NULL, 10);

	q->mcodes[q->config.controller.mcode_count++] = (struct mcode){number, MCODE_IGNORE};
}

/* The macro is given by its number or its name. */
static void answer_macro(struct scan_questions *q, const char *asked)
{
	const size_t i = q->config.controller.macro_count++;
	const int number = (int)strtol(asked, NULL, 10);

	snprintf(q->macro_names[i], ASKED_NAME, "%s", asked);
	q->macros[i] = (struct builder_macro){.program = number > 0 ? number : MACRO_OF_CODE,
					      .action = MACRO_NONE,
					      .name = number > 0 ? NULL : q->macro_names[i]};
}

/* name="NAME" and, for a new variable, type="" and size=",": two dimensions. */
static void answer_variable(struct scan_questions *q, const char *asked)
{
	static const int sizes[] = {1, 1000, 100, 20};
	const size_t i = q->config.controller.variable_count++;
	const char *name = asked + strcspn(asked, "\"") + 1, *size = strstr(asked, " size=\"");
	const char *type = strstr(asked, " type=\"");
	struct control_variable *variable = &q->variables[i];

	snprintf(q->variable_names[i], CONTROL_VARIABLE_NAME, "%.*s", (int)strcspn(name, "\""), name);
	/* "ID50 NR3 IDX12" without its blanks. */
	control_variable_name_normalise(q->variable_names[i], q->variable_names[i]);
	*variable = (struct control_variable){.name = q->variable_names[i], .typed = type != NULL, .number = 1};
	if (type && !strncmp(type, " type=\"STRING", 13))
		variable->type = CONTROL_STRING;
	if (size) {
		size += strlen(" size=\"");
		variable->dimensions = 1 + (int)strspn(size, ",");
	}
	for (int k = 0; k < variable->dimensions; k++)
		variable->size[k] = sizes[variable->dimensions];
	if (strstr(asked, " value=\""))
		variable->text = "1";
}

/* A field of the controller that is an enumeration, or a number. */
#define CHOICE(member, answer) .field = offsetof(struct controller, member), .choice = (answer)
#define NUMBER(member, answer) .field = offsetof(struct controller, member), .number = (answer)

/* The text in a message that marks the question, the line for the machine file, and any valid answer. */
static const struct question {
	const char *key;	/* in the message; a number or a name may follow */
	const char *line;	/* with %s for the text after the key, up to a quotation mark or to `end` */
	const char *end;
	/* NULL: the field gets the choice or the number */
	void (*take)(struct scan_questions *questions, const char *asked);
	size_t field;
	int choice;
	double number;
} questions_table[] = {
    {"<mcode number=\"", "<mcode number=\"%s\" action=\"\"/>", .take = answer_mcode},
    {"<macro program=\"", "<macro program=\"%s\" action=\"\"/>", .take = answer_macro},
    {"<variable ", "<variable %s/>", .end = "/>", .take = answer_variable},
    {"<reference number=\"", "<reference number=\"%s\" X=\"\" Y=\"\" Z=\"\"/>", .take = answer_reference},
    {"<tool_change Z=\"", "<tool_change Z=\"\"/>, or <tool_change/> if M6 moves no axis", .take = answer_tool_change},
    {"<swivel_retract ", "<swivel_retract X=\"\" Y=\"\" Z=\"\"/>", .take = answer_swivel_retract},
    {"wrap=\"shortest\"", "wrap=\"shortest\" of the rotary axis", .take = answer_wrap},
    {"half_turn=\"", "half_turn=\"positive\" or \"negative\" of the rotary axis", .take = answer_half_turn},
    {"least_input=\"", "least_input=\"1\" (whole units) or \"0.001\"", NUMBER(least_input, 1)},
    {"power_on_units=\"", "power_on_units=\"mm\" or \"inch\"", CHOICE(power_on_units, POWER_ON_MM)},
    {"power_on_distance=\"", "power_on_distance=\"absolute\" or \"incremental\"",
     CHOICE(power_on_distance, POWER_ON_ABSOLUTE)},
    {"power_on_plane=\"", "power_on_plane=\"xy\", \"zx\" or \"yz\"", CHOICE(power_on_plane, POWER_ON_XY)},
    {"cycle_19_angles=\"", "cycle_19_angles=\"spatial\" or \"axes\"",
     CHOICE(cycle_19_angles, CYCLE_19_ANGLES_SPATIAL)},
    {"cycle_11_axes=\"", "cycle_11_axes=\"plane\" or \"all\"", CHOICE(cycle_11_axes, CYCLE_11_AXES_ALL)},
    {"increments_after_shift=\"", "increments_after_shift=\"stay\" (or \"traverse\", where the control has it)",
     CHOICE(increments_after_shift, INCREMENTS_FROM_POSITION)},
    {"power_on_motion=\"", "power_on_motion=\"rapid\" or \"feed\"", CHOICE(power_on_motion, POWER_ON_RAPID)},
    {"cycle_axis=\"", "cycle_axis=\"plane\" or \"z\" (parameter 5101#0)", CHOICE(cycle_axis, CYCLE_AXIS_ACROSS)},
    {"cycle_repeats=\"", "cycle_repeats=\"K\" or \"L\"", CHOICE(cycle_repeats, CYCLE_REPEATS_L)},
    {"power_on_work_offset=\"", "power_on_work_offset=\"G500\", \"G54\" and so on", CHOICE(power_on_work_offset, 1)},
    {"length_offset_moves=\"", "length_offset_moves=\"yes\" or \"no\"", CHOICE(length_moves, ANSWER_NO)},
    {"length_after_reference=\"", "length_after_reference=\"keeps\" or \"cancels\"",
     CHOICE(length_after_reference, LENGTH_AFTER_REFERENCE_KEPT)},
    {"length_under_g68=\"", "length_under_g68=\"turned\" or \"straight\"",
     CHOICE(length_under_g68, LENGTH_UNDER_G68_TURNED)},
    {"polar_axes=\"", "polar_axes=\"XA\", \"XB\" or \"XC\"", CHOICE(polar_axis, SLOT_C)},
    {"g53_with_g91=\"", "g53_with_g91=\"absolute\" or \"incremental\"", CHOICE(g53_with_g91, G53_WITH_G91_ABSOLUTE)},
    {"path_tolerance=\"", "path_tolerance=\"\"", NUMBER(path_tolerance, 0.1)},
    {"unidirectional_overrun=\"", "unidirectional_overrun=\"\"", NUMBER(overrun, 1)},
    {"arc_radius_tolerance=\"", "arc_radius_tolerance=\"\" (parameter 3410)",
     NUMBER(arc_radius_tolerance, 1e6)},
    {"m6_with_move=\"", "m6_with_move=\"after\" or \"before\"", CHOICE(m6_with_move, M6_AFTER_MOVE)},
    {"m6_with_t=\"", "m6_with_t=\"own\", \"before\" or \"first\"", CHOICE(m6_with_t, M6_LOADS_FIRST_T)},
    {"semicolon=\"", "semicolon=\"comment\" or \"block-end\"", CHOICE(semicolon, SEMICOLON_STARTS_COMMENT)},
    {"colon=\"", "colon=\"program\" or \"block\"", CHOICE(colon, COLON_BLOCK)},
    {"cutter_comp_d=\"", "cutter_comp_d=\"radius\" or \"diameter\"", CHOICE(comp_d, COMP_D_RADIUS)},
    {"cutter_comp_start=\"", "cutter_comp_start=\"A\" or \"B\"", CHOICE(comp_start, COMP_START_A)},
    {"cutter_comp_corner=\"", "cutter_comp_corner=\"linear\" or \"circular\"",
     CHOICE(comp_corner, COMP_CORNER_CIRCULAR)},
    {"cutter_comp_idle_blocks=\"", "cutter_comp_idle_blocks=\"3\" (MD20250; 19625, less 2)",
     CHOICE(comp_idle_blocks, 9)},
    {"rotation_order=\"", "rotation_order=\"rpy\" or \"euler\"", CHOICE(rotation_order, ROTATION_ORDER_RPY)},
    {"orientation_interpolation=\"", "orientation_interpolation=\"axes\", \"vector\" or \"oriwks\"",
     CHOICE(orientation_interpolation, ORIENTATION_INTERPOLATION_AXES)},
    {"edge_after_tool_change=\"", "edge_after_tool_change=\"first\", \"none\" or \"keeps\"",
     CHOICE(edge_after_tool_change, EDGE_AFTER_TOOL_CHANGE_FIRST)},
    {"t_changes_tool=\"", "t_changes_tool=\"yes\" or \"no\"", CHOICE(t_changes_tool, ANSWER_NO)},
    {"mirror_toggle=\"", "mirror_toggle=\"yes\" or \"no\" (MD10612)", CHOICE(mirror_toggle, ANSWER_YES)},
    {"frames_outlive_traori=\"", "frames_outlive_traori=\"yes\" or \"no\"", CHOICE(frames_outlive_traori, ANSWER_YES)},
    {"frames_outlive_cycle800=\"", "frames_outlive_cycle800=\"yes\" or \"no\"",
     CHOICE(frames_outlive_cycle800, ANSWER_YES)},
    {"tcp_zero=\"machine", "tcp_zero=\"machine\" or \"offset\"", CHOICE(tcp_zero_given, ANSWER_YES)},
    {"swivel_axis=\"", "swivel_axis=\"A\", \"B\" or \"C\"", CHOICE(swivel_axis, SLOT_C)},
    {"orientation_pole=\"", "orientation_pole=\"axes\"", CHOICE(orientation_pole, ORIENTATION_POLE_AXES)},
    {"swivel_pole=\"", "swivel_pole=\"zero\" or \"stays\"", CHOICE(swivel_pole, SWIVEL_POLE_ZERO)},
    {"tool_def=\"", "tool_def=\"ignored\"", CHOICE(tool_def, TOOL_DEF_IGNORED)},
    {"rotary_way=\"", "rotary_way=\"plain\" or \"shorter\"", CHOICE(rotary_way, ROTARY_WAY_PLAIN)},
    {"rotary_angle=\"", "rotary_angle=\"as-written\" or \"reduced\"", CHOICE(rotary_angle, ROTARY_ANGLE_AS_WRITTEN)},
    {"m6=\"", "m6=\"ignored\"", CHOICE(m6, M6_IGNORED)},
    {"plane_rotation=\"", "plane_rotation=\"coordinates\" or \"table\"",
     CHOICE(plane_rotation, PLANE_ROTATION_COORDINATES)},
    {"plane_retract=\"", "plane_retract=\"always\" or \"turning\"", CHOICE(plane_retract, PLANE_RETRACT_ALWAYS)},
    {"shift_behind_plane=\"", "shift_behind_plane=\"keeps\" or \"cancelled\"",
     CHOICE(shift_behind_plane, SHIFT_BEHIND_PLANE_KEEPS)},
    {"tool_length_axis=\"", "tool_length_axis=\"z\"", CHOICE(length_along_z, ANSWER_YES)},
};

static void take(struct scan_questions *questions, const struct question *question, const char *asked)
{
	char *field = (char *)&questions->config.controller + question->field;

	if (question->take)
		question->take(questions, asked);
	else if (question->number > 0)
		memcpy(field, &question->number, sizeof(question->number));
	else
		memcpy(field, &question->choice, sizeof(question->choice));
}

/* The first error of one reading. */
struct first_error {
	struct diag diag;
	struct strbuf text, file;
	int column;
	long line;
};

static void keep_first(void *context, const struct diag_entry *entry)
{
	struct first_error *error = context;

	if (entry->severity != DIAG_ERROR || error->diag.errors > 1)
		return;
	strbuf_addf(&error->text, "%s", entry->text);
	strbuf_addf(&error->file, "%s", entry->loc.file ? entry->loc.file : "");
	error->line = entry->loc.line;
	error->column = entry->loc.column;
}

static bool is_asked(const struct scan_questions *questions, const char *text)
{
	for (size_t i = 0; i < questions->count; i++) {
		if (!strcmp(questions->asked[i].text, text))
			return true;
	}
	return false;
}

/* The line with its %s replaced by the object of the question. */
static void add_line(struct strbuf *out, const char *line, const char *asked)
{
	const char *mark = strstr(line, "%s");

	if (mark)
		strbuf_addf(out, "%.*s%s%s", (int)(mark - line), line, asked, mark + 2);
	else
		strbuf_addf(out, "%s", line);
}

/* Uses an answer to the question in the message. False: there is no question, or it has been answered. */
static bool take_answer(struct scan_questions *questions, const struct first_error *error)
{
	for (size_t i = 0; i < sizeof(questions_table) / sizeof(questions_table[0]); i++) {
		const struct question *question = &questions_table[i];
		const char *found = strstr(strbuf_text(&error->text), question->key);
		struct strbuf line = {0}, place = {0};
		char asked[ASKED_NAME];
		const char *end;
		bool fresh;

		if (!found)
			continue;
		found += strlen(question->key);
		end = question->end ? strstr(found, question->end) : NULL;
		snprintf(asked, sizeof(asked), "%.*s", end ? (int)(end - found) : (int)strcspn(found, "\""), found);
		add_line(&line, question->line, asked);
		fresh = questions->count < QUESTIONS_MAX && !is_asked(questions, strbuf_text(&line));
		if (fresh) {
			strbuf_addf(&place, "%s:%ld", strbuf_text(&error->file), error->line);
			questions->asked[questions->count++] =
				(struct asked){mem_strndup(strbuf_text(&line), line.length),
					       mem_strndup(strbuf_text(&place), place.length)};
			take(questions, question, asked);
		}
		strbuf_release(&line);
		strbuf_release(&place);
		return fresh;
	}
	return false;
}

/* True: the program was read to its end. */
static bool read_once(const struct scan_questions *questions, FILE *in, const char *name, struct first_error *error)
{
	*error = (struct first_error){.diag = {.handle = keep_first, .context = error}};
	return any_machine_read(&questions->config, in, name, &error->diag);
}

static void release(struct first_error *error)
{
	strbuf_release(&error->text);
	strbuf_release(&error->file);
}

bool scan_questions_read(struct scan_questions *questions, FILE *in, const char *name, struct diag *diag)
{
	struct first_error error;
	bool good, again;

	do {
		good = read_once(questions, in, name, &error);
		again = !good && take_answer(questions, &error);
		if (!good && !again)
			diag_error(diag, (struct srcloc){strbuf_text(&error.file), error.line, error.column}, "%s",
				   strbuf_text(&error.text));
		release(&error);
	} while (again);
	return good;
}

const struct gcode_config *scan_questions_config(const struct scan_questions *questions)
{
	return &questions->config;
}

void scan_questions_add(struct strbuf *out, const struct scan_questions *questions)
{
	for (size_t i = 0; i < questions->count; i++)
		strbuf_addf(out, "%s\t%s\n", questions->asked[i].text, questions->asked[i].place);
}
