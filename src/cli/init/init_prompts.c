#include "cli/init/init_prompts.h"

#include <string.h>

#include "cli/init/init.h"
#include "machine/machine.h"

static const struct srcloc nowhere;

struct question {
	enum plan_key key;
	int slot; /* the axis it is about; -1: none */
	const char *text; /* what is asked for; %s stands for the unit */
	const char *example; /* behind the axis */
	bool optional; /* what holds without an answer is said in the text; asked, but not missed */
};

enum { QUESTIONS_MAX = 32 };

struct questions {
	struct question items[QUESTIONS_MAX];
	size_t count;
};

static void add(struct questions *list, bool open, struct question question)
{
	if (open)
		list->items[list->count++] = question;
}

static const char *unit_of(const struct plan *plan, const struct question *question)
{
	if (question->slot >= 0 && slot_is_rotary(question->slot) && question->key != PLAN_LOCATION)
		return "degrees";
	return plan->inch == 1 ? "inches" : "mm";
}

static void add_axis(struct questions *list, const struct plan *plan, int slot)
{
	const struct plan_axis *axis = &plan->axes[slot];
	bool rotary = slot_is_rotary(slot);
	bool without_zero = (axis->has_min && axis->min > 0) || (axis->has_max && axis->max < 0);

	add(list, !axis->has_limits,
	    (struct question){PLAN_LIMITS, slot, "the travel in %s, or none where there is no limit",
			      rotary ? "-120:30" : "-300:300", false});
	add(list, !axis->has_home && without_zero,
	    (struct question){PLAN_HOME, slot, "where programs start, as 0 is outside of the travel, in %s", "100",
			      false});
	add(list, !axis->has_rate && plan->rapid == RAPID_DOGLEG,
	    (struct question){PLAN_RATES, slot, "the rate of rapids, in %s a minute", rotary ? "7200" : "30000",
			      false});
	add(list, rotary && !axis->has_location,
	    (struct question){PLAN_LOCATION, slot, "a point on the axis of rotation in %s, with every axis at 0",
			      "0,0,120", false});
}

/* What is open, as far as is known by now. */
static void list_open(struct questions *list, const struct plan *plan)
{
	list->count = 0;
	add(list, plan->family < 0,
	    (struct question){PLAN_FAMILY, -1,
			      "the family: do both rotary axes turn the table, both the head, or one each",
			      "table-table", false});
	add(list, !plan->rotary.count,
	    (struct question){PLAN_ROTARY, -1,
			      "the rotary axes, first the one that carries the other (head-table: the head's)", "A,C",
			      false});
	add(list, !plan->has_table && !plan->has_head,
	    (struct question){PLAN_TABLE, -1,
			      "the linear axes that move the table, from the base on, or none (the default)", "Y,X",
			      true});
	for (int slot = 0; slot <= SLOT_C; slot++) {
		if (plan_has_axis(plan, slot))
			add_axis(list, plan, slot);
	}
	add(list, !plan->has_spindle,
	    (struct question){PLAN_SPINDLE, -1, "the gauge point of the spindle in %s, with every axis at 0", "0,0,520",
			      false});
	add(list, plan->dialect < 0,
	    (struct question){PLAN_DIALECT, -1, "the dialect of the programs: linuxcnc (the default), fanuc or haas",
			      "fanuc", true});
}

/* "the travel of X in mm" would need grammar; "X: the travel in mm" does not. */
static void add_text(struct strbuf *out, const struct plan *plan, const struct question *question)
{
	const char *unit = strstr(question->text, "%s");

	if (question->slot >= 0)
		strbuf_addf(out, "%c: ", AXIS_LETTERS[question->slot]);
	if (unit)
		strbuf_addf(out, "%.*s%s%s", (int)(unit - question->text), question->text, unit_of(plan, question),
			    unit + 2);
	else
		strbuf_addf(out, "%s", question->text);
}

/* As the option takes it. */
static void add_answer(struct strbuf *out, const struct question *question, const char *answer)
{
	if (question->slot >= 0)
		strbuf_addf(out, "%c=", AXIS_LETTERS[question->slot]);
	strbuf_addf(out, "%s", answer);
}

bool question_is_open(const struct plan *plan)
{
	struct questions list;

	list_open(&list, plan);
	for (size_t i = 0; i < list.count; i++) {
		if (!list.items[i].optional)
			return true;
	}
	return false;
}

bool question_report(const struct plan *plan, struct diag *diag)
{
	struct questions list;
	bool complete = true;

	list_open(&list, plan);
	for (size_t i = 0; i < list.count; i++) {
		const struct question *question = &list.items[i];
		struct strbuf text = {0}, example = {0};

		if (question->optional)
			continue;
		complete = false;
		add_text(&text, plan, question);
		add_answer(&example, question, question->example);
		if (question->key == PLAN_FAMILY)
			diag_error(diag, nowhere, "missing: %s; one of table-table, head-head, head-table",
				   strbuf_text(&text));
		else
			diag_error(diag, nowhere, "missing: %s; like --%s %s", strbuf_text(&text),
				   init_row(question->key)->name, strbuf_text(&example));
		strbuf_release(&text);
		strbuf_release(&example);
	}
	return complete;
}

/* One line, without its end; false at the end of the input. */
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
static bool ask(struct plan *plan, const struct question *question, FILE *in, struct diag *diag)
{
	struct strbuf text = {0}, line = {0}, answer = {0};
	bool good;

	add_text(&text, plan, question);
	fprintf(stderr, "%s\n  (like %s): ", strbuf_text(&text), question->example);
	fflush(stderr);
	good = read_line(&line, in);
	if (good && line.length) {
		/* What makes no sense is said, stays open, and so is asked again. */
		add_answer(&answer, question, strbuf_text(&line));
		plan_set(plan, init_row(question->key), strbuf_text(&answer), diag);
	}
	strbuf_release(&text);
	strbuf_release(&line);
	strbuf_release(&answer);
	return good;
}

bool question_ask(struct plan *plan, FILE *in, struct diag *diag)
{
	bool asked[PLAN_HELP + 1] = {false};
	struct questions list;

	for (;;) {
		size_t i = 0;

		/* Each answer may open others. */
		list_open(&list, plan);
		while (i < list.count && list.items[i].optional && asked[list.items[i].key])
			i++;
		if (i == list.count)
			return true;
		asked[list.items[i].key] = true;
		if (!ask(plan, &list.items[i], in, diag)) {
			diag_error(diag, nowhere, "the questions were not answered: nothing is written");
			return false;
		}
	}
}
