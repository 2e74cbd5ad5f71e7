#include "cli/scan/scan_questions.h"

#include <stdlib.h>
#include <string.h>

#include "base/mem.h"
#include "gcode/interp.h"

/* Questions that one set of programs can have; M-codes and programs of the builder are most of them. */
#define QUESTIONS_MAX 400
#define TOOLS 999
#define OFFSETS 108
#define OFFSET_NAME 16

struct asked {
	char *text;	/* what the machine file is to say */
	char *place;	/* "part.nc:12" */
};

struct scan_questions {
	struct gcode_config config;
	struct asked asked[QUESTIONS_MAX];
	size_t count;
	struct mcode mcodes[QUESTIONS_MAX];
	struct builder_macro macros[QUESTIONS_MAX];
	struct tool tools[TOOLS];
	struct length_offset lengths[TOOLS];
	struct radius_offset radii[TOOLS];
	struct work_offset offsets[OFFSETS];
	char names[OFFSETS][OFFSET_NAME];
};

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
			snprintf(questions->names[i], OFFSET_NAME, "G54.1 P%d", i - 8);
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

struct scan_questions *scan_questions_new(const struct dialect *dialect)
{
	struct scan_questions *questions = mem_zalloc(1, sizeof(*questions));

	questions->config.dialect = dialect;
	questions->config.controller.mcodes = questions->mcodes;
	questions->config.controller.macros = questions->macros;
	for (int slot = 0; slot < SLOT_COUNT; slot++)
		questions->config.has_axis[slot] = true;
	fill_tables(questions);
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

/* The answers that are taken; `number` stands in the message behind `key`. Which answer it is matters little. */
static void answer_least_input(struct scan_questions *q, int number)
{
	(void)number;
	q->config.controller.least_input = 1;
}

static void answer_units(struct scan_questions *q, int number)
{
	(void)number;
	q->config.controller.power_on_units = POWER_ON_MM;
}

static void answer_distance(struct scan_questions *q, int number)
{
	(void)number;
	q->config.controller.power_on_distance = POWER_ON_ABSOLUTE;
}

static void answer_plane(struct scan_questions *q, int number)
{
	(void)number;
	q->config.controller.power_on_plane = POWER_ON_XY;
}

static void answer_length_moves(struct scan_questions *q, int number)
{
	(void)number;
	q->config.controller.length_moves = ANSWER_NO;
}

static void answer_length_after(struct scan_questions *q, int number)
{
	(void)number;
	q->config.controller.length_after_reference = LENGTH_AFTER_REFERENCE_KEPT;
}

static void answer_g53(struct scan_questions *q, int number)
{
	(void)number;
	q->config.controller.g53_with_g91 = G53_WITH_G91_ABSOLUTE;
}

static void answer_comp_start(struct scan_questions *q, int number)
{
	(void)number;
	q->config.controller.comp_start = COMP_START_A;
}

static void answer_comp_corner(struct scan_questions *q, int number)
{
	(void)number;
	q->config.controller.comp_corner = COMP_CORNER_CIRCULAR;
}

static void answer_half_turn(struct scan_questions *q, int number)
{
	(void)number;
	for (int slot = 0; slot < SLOT_COUNT; slot++)
		q->config.half_turn[slot] = 1;
}

static void answer_tool_change(struct scan_questions *q, int number)
{
	(void)number;
	q->config.controller.tool_change.given = true;
}

static void answer_reference(struct scan_questions *q, int number)
{
	if (number >= 1 && number <= REFERENCES_MAX)
		q->config.controller.references[number - 1].given = true;
}

static void answer_mcode(struct scan_questions *q, int number)
{
	q->mcodes[q->config.controller.mcode_count++] = (struct mcode){number, MCODE_IGNORE};
}

static void answer_macro(struct scan_questions *q, int number)
{
	q->macros[q->config.controller.macro_count++] = (struct builder_macro){.program = number, .action = MACRO_NONE};
}

/* How a message asks, and the line of the machine file. */
static const struct question {
	const char *key;	/* in the message; a number may follow */
	bool numbered;
	const char *line;	/* %d: the number */
	void (*take)(struct scan_questions *questions, int number);
} questions_table[] = {
	{"<mcode number=\"", true, "<mcode number=\"%d\" action=\"\"/>", answer_mcode},
	{"<macro program=\"", true, "<macro program=\"%d\" action=\"\"/>", answer_macro},
	{"<reference number=\"", true, "<reference number=\"%d\" X=\"\" Y=\"\" Z=\"\"/>", answer_reference},
	{"<tool_change Z=\"", false, "<tool_change Z=\"\"/>, or <tool_change/> if M6 moves no axis", answer_tool_change},
	{"half_turn=\"", false, "half_turn=\"positive\" or \"negative\" of the rotary axis", answer_half_turn},
	{"least_input=\"", false, "least_input=\"1\" (whole units) or \"0.001\"", answer_least_input},
	{"power_on_units=\"", false, "power_on_units=\"mm\" or \"inch\"", answer_units},
	{"power_on_distance=\"", false, "power_on_distance=\"absolute\" or \"incremental\"", answer_distance},
	{"power_on_plane=\"", false, "power_on_plane=\"xy\", \"zx\" or \"yz\"", answer_plane},
	{"length_offset_moves=\"", false, "length_offset_moves=\"yes\" or \"no\"", answer_length_moves},
	{"length_after_reference=\"", false, "length_after_reference=\"keeps\" or \"cancels\"", answer_length_after},
	{"g53_with_g91=\"", false, "g53_with_g91=\"absolute\" or \"incremental\"", answer_g53},
	{"cutter_comp_start=\"", false, "cutter_comp_start=\"A\" or \"B\"", answer_comp_start},
	{"cutter_comp_corner=\"", false, "cutter_comp_corner=\"linear\" or \"circular\"", answer_comp_corner},
};

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

/* Takes an answer to the question that the message asks. False: it asks none, or one that has been answered. */
static bool take_answer(struct scan_questions *questions, const struct first_error *error)
{
	for (size_t i = 0; i < sizeof(questions_table) / sizeof(questions_table[0]); i++) {
		const struct question *question = &questions_table[i];
		const char *found = strstr(strbuf_text(&error->text), question->key);
		int number = found && question->numbered ? (int)strtol(found + strlen(question->key), NULL, 10) : 0;
		struct strbuf line = {0}, place = {0};
		bool fresh;

		if (!found)
			continue;
		if (question->numbered)
			strbuf_addf(&line, question->line, number);
		else
			strbuf_addf(&line, "%s", question->line);
		fresh = questions->count < QUESTIONS_MAX && !is_asked(questions, strbuf_text(&line));
		if (fresh) {
			strbuf_addf(&place, "%s:%ld", strbuf_text(&error->file), error->line);
			questions->asked[questions->count++] =
				(struct asked){mem_strndup(strbuf_text(&line), line.length),
					       mem_strndup(strbuf_text(&place), place.length)};
			question->take(questions, number);
		}
		strbuf_release(&line);
		strbuf_release(&place);
		return fresh;
	}
	return false;
}

static bool hear_nothing(void *context, const struct canon_event *event)
{
	(void)context;
	(void)event;
	return true;
}

/* A machine that can do all that it is asked for; what it answers stands in no report. */
static bool switch_tcp(void *context, const struct kinematics_tcp *tcp, struct srcloc loc, axis_values *position)
{
	(void)context;
	(void)tcp;
	(void)loc;
	(void)position;
	return true;
}

static bool orient(void *context, struct srcloc loc, struct kinematics_orientation *orientation)
{
	(void)context;
	(void)loc;
	(void)orientation;
	return true;
}

static bool orientations(void *context, struct srcloc loc, const struct kinematics_orientation *orientation,
			 struct kinematics_solutions *solutions)
{
	(void)context;
	(void)loc;
	*solutions = (struct kinematics_solutions){.count = 1, .primary = SLOT_A};
	solutions->items[0].rotary = orientation->rotary;
	solutions->items[0].within_limits = true;
	return true;
}

static bool retract(void *context, struct srcloc loc, struct kinematics_retract *move)
{
	(void)context;
	(void)loc;
	(void)move;
	return true;
}

static bool table_point(void *context, struct srcloc loc, axis_values *place)
{
	(void)context;
	(void)loc;
	(void)place;
	return true;
}

/* True: it was read to its end. */
static bool read_once(const struct scan_questions *questions, FILE *in, const char *name, struct first_error *error)
{
	static const struct canon_sink sink = {NULL, hear_nothing};
	static const struct kinematics kinematics = {NULL, switch_tcp, orient, orientations, retract, table_point};
	struct interp *interp;
	bool good;

	*error = (struct first_error){.diag = {.handle = keep_first, .context = error}};
	rewind(in);
	interp = interp_new(&questions->config, &kinematics, &sink, &error->diag);
	good = interp_run(interp, in, name);
	interp_free(interp);
	return good;
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

void scan_questions_add(struct strbuf *out, const struct scan_questions *questions)
{
	for (size_t i = 0; i < questions->count; i++)
		strbuf_addf(out, "%s\t%s\n", questions->asked[i].text, questions->asked[i].place);
}
