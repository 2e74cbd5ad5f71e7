#include "cli/init/init_prompts.h"

#include <string.h>

#include "cli/init/init_options.h"
#include "cli/init/machine_plan_set.h"
#include "control/dialects.h"
#include "machine/machine.h"

static const struct srcloc nowhere;

struct prompt {
	enum machine_plan_key key;
	int slot;	/* the axis; -1: none */
	const char *text;	/* the question; %s stands for the unit */
	const char *example;	/* an answer, without the axis */
	bool optional;	/* there is a default, which the text mentions */
};

enum { PROMPTS_MAX = 32 };

struct prompts {
	struct prompt items[PROMPTS_MAX];
	size_t count;
};

static void add(struct prompts *list, bool open, struct prompt prompt)
{
	if (open)
		list->items[list->count++] = prompt;
}

static const char *unit_of(const struct machine_plan *plan, const struct prompt *prompt)
{
	if (prompt->slot >= 0 && slot_is_rotary(prompt->slot) && prompt->key != PLAN_LOCATION)
		return "degrees";
	return plan->inch == 1 ? "inches" : "mm";
}

static void add_axis(struct prompts *list, const struct machine_plan *plan, int slot)
{
	const struct machine_plan_axis *axis = &plan->axes[slot];
	bool rotary = slot_is_rotary(slot);
	bool without_zero = (axis->has_min && axis->min > 0) || (axis->has_max && axis->max < 0);

	add(list, !axis->has_limits,
	    (struct prompt){PLAN_LIMITS, slot, "the travel in %s, or none if there is no limit",
			      rotary ? "-120:30" : "-300:300", false});
	add(list, !axis->has_home && without_zero,
	    (struct prompt){PLAN_HOME, slot, "where programs start in %s (0 is outside the travel)", "100",
			      false});
	add(list, !axis->has_rate && plan->rapid == RAPID_DOGLEG,
	    (struct prompt){PLAN_RATES, slot, "the rate of rapids in %s per minute", rotary ? "7200" : "30000",
			      false});
	add(list, rotary && !axis->has_location,
	    (struct prompt){PLAN_LOCATION, slot, "a point on the axis of rotation in %s, with every axis at 0",
			      "0,0,120", false});
}

/* The usual oblique axis is halfway between its own letter and Z; C has no such direction. */
static void add_oblique(struct prompts *list, const struct machine_plan *plan)
{
	const int slot = machine_plan_tilted(plan);

	if (slot < 0 || plan->axes[slot].has_direction || plan->axes[slot].has_inclination)
		return;
	add(list, slot == SLOT_C,
	    (struct prompt){PLAN_DIRECTION, slot,
			    "the direction of this oblique axis; positive values turn right-handed about it",
			    "0,1,1", false});
	add(list, slot != SLOT_C,
	    (struct prompt){PLAN_DIRECTION, slot,
			    "the direction of this oblique axis; positive values turn right-handed about it "
			    "(by default it is at 45 degrees to Z)",
			    slot == SLOT_A ? "1,0,1" : "0,1,1", true});
}

/* Lists the missing values, as far as the answers so far determine them. */
static void list_open(struct prompts *list, const struct machine_plan *plan)
{
	list->count = 0;
	add(list, plan->family < 0,
	    (struct prompt){
		PLAN_FAMILY, -1,
		"the family (what the rotary axes turn): table-table, head-head or head-table; nutating-table or "
		"nutating-head if one rotary axis is oblique",
		"table-table", false});
	add(list, !plan->rotary.count,
	    (struct prompt){PLAN_ROTARY, -1,
			      "the rotary axes: first the axis that carries the other (head-table: the head's axis)",
			      "A,C", false});
	add(list, !plan->has_table && !plan->has_head,
	    (struct prompt){PLAN_TABLE, -1,
			      "the linear axes that move the table, in order from the base, or none (the default)",
			      "Y,X", true});
	for (int slot = 0; slot <= SLOT_C; slot++) {
		if (machine_plan_has_axis(plan, slot))
			add_axis(list, plan, slot);
	}
	add_oblique(list, plan);
	add(list, !plan->has_spindle,
	    (struct prompt){PLAN_SPINDLE, -1, "the gauge point of the spindle in %s, with every axis at 0", "0,0,520",
			      false});
	add(list, plan->dialect < 0,
	    (struct prompt){PLAN_DIALECT, -1, "the dialect of the programs", dialect_names[0], true});
}

/* "X: the travel in mm, or none if there is no limit" */
static void add_text(struct strbuf *out, const struct machine_plan *plan, const struct prompt *prompt)
{
	const char *const *choices = init_options_row(prompt->key)->choices;
	const char *unit = strstr(prompt->text, "%s");

	if (prompt->slot >= 0)
		strbuf_addf(out, "%c: ", AXIS_LETTERS[prompt->slot]);
	if (unit)
		strbuf_addf(out, "%.*s%s%s", (int)(unit - prompt->text), prompt->text, unit_of(plan, prompt),
			    unit + 2);
	else
		strbuf_addf(out, "%s", prompt->text);
	for (int i = 0; prompt->optional && choices && choices[i]; i++)
		strbuf_addf(out, "%s%s%s", i ? ", " : ": ", choices[i], i ? "" : " (the default)");
}

/* The answer in the form of the option's argument. */
static void add_answer(struct strbuf *out, const struct prompt *prompt, const char *answer)
{
	if (prompt->slot >= 0)
		strbuf_addf(out, "%c=", AXIS_LETTERS[prompt->slot]);
	strbuf_addf(out, "%s", answer);
}

bool init_prompts_are_missing(const struct machine_plan *plan)
{
	struct prompts list;

	list_open(&list, plan);
	for (size_t i = 0; i < list.count; i++) {
		if (!list.items[i].optional)
			return true;
	}
	return false;
}

bool init_prompts_report(const struct machine_plan *plan, struct diag *diag)
{
	struct prompts list;
	bool complete = true;

	list_open(&list, plan);
	for (size_t i = 0; i < list.count; i++) {
		const struct prompt *prompt = &list.items[i];
		struct strbuf text = {0}, example = {0};

		/* machine_plan_finish gives more details about a missing direction. */
		if (prompt->optional || prompt->key == PLAN_DIRECTION)
			continue;
		complete = false;
		add_text(&text, plan, prompt);
		add_answer(&example, prompt, prompt->example);
		if (prompt->key == PLAN_FAMILY)
			diag_error(diag, nowhere, "missing: %s", strbuf_text(&text));
		else
			diag_error(diag, nowhere, "missing: %s; like --%s %s", strbuf_text(&text),
				   init_options_row(prompt->key)->name, strbuf_text(&example));
		strbuf_release(&text);
		strbuf_release(&example);
	}
	return complete;
}

/* Reads one line without its end. False: the input has ended. */
static bool read_line(struct strbuf *line, FILE *in)
{
	int c;

	strbuf_clear(line);
	while ((c = getc(in)) != EOF && c != '\n') {
		char byte = (char)c;

		strbuf_add(line, &byte, 1);
	}
	return c != EOF;
}

/* False: the input has ended. */
static bool ask_prompt(struct machine_plan *plan, const struct prompt *prompt, FILE *in, struct diag *diag)
{
	struct strbuf text = {0}, line = {0}, answer = {0};
	bool good;

	add_text(&text, plan, prompt);
	fprintf(stderr, "%s\n  (like %s): ", strbuf_text(&text), prompt->example);
	fflush(stderr);
	good = read_line(&line, in);
	if (good && line.length) {
		/* A wrong answer is reported; the value is still missing, so the question is repeated. */
		add_answer(&answer, prompt, strbuf_text(&line));
		machine_plan_set(plan, init_options_row(prompt->key), strbuf_text(&answer), diag);
	}
	strbuf_release(&text);
	strbuf_release(&line);
	strbuf_release(&answer);
	return good;
}

bool init_prompts_ask(struct machine_plan *plan, FILE *in, struct diag *diag)
{
	bool asked[PLAN_KEY_END] = {false};
	struct prompts list;

	for (;;) {
		size_t i = 0;

		/* An answer may lead to further questions. */
		list_open(&list, plan);
		while (i < list.count && list.items[i].optional && asked[list.items[i].key])
			i++;
		if (i == list.count)
			return true;
		asked[list.items[i].key] = true;
		if (!ask_prompt(plan, &list.items[i], in, diag)) {
			diag_error(diag, nowhere,
				   "the input ended before all questions were answered: nothing was written");
			return false;
		}
	}
}
