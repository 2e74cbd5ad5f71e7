#include "report/sensitivity_report.h"

#include <math.h>

#include "check/finding.h"
#include "report/format/format_units.h"
#include "report/format/json.h"

/* Rounded down, so that the printed number is proved, too. */
static void add_down(struct strbuf *out, double mm)
{
	strbuf_addf(out, "%.4f", floor(mm * 1e4 + 1e-6) / 1e4);
}

static void add_found(struct strbuf *out, const struct sensitivity *answer)
{
	if (answer->kind < 0) {
		strbuf_addf(out, "nothing is found");
		return;
	}
	strbuf_addf(out, "%s in line %ld: ", finding_kind_name((enum finding_kind)answer->kind), answer->line);
	if (answer->kind == FINDING_LIMIT) {
		strbuf_addf(out, "axis %c", AXIS_LETTERS[answer->slot]);
		return;
	}
	format_units_add_plain(out, answer->a ? answer->a : "");
	strbuf_addf(out, " - ");
	format_units_add_plain(out, answer->b ? answer->b : "");
}

/* "clear is proved up to 0.9961", and the largest change that was tried without a proof. */
static void add_extent(struct strbuf *out, const struct sensitivity *answer, bool clear)
{
	if (clear) {
		strbuf_addf(out, "clear is proved up to ");
		add_down(out, answer->proved);
	}
	if (answer->tried > answer->proved) {
		strbuf_addf(out, clear ? ", tried up to " : "found at the values tried up to ");
		add_down(out, answer->tried);
		strbuf_addf(out, " (no proof)");
	} else if (!clear) {
		strbuf_addf(out, "found");
	}
}

static void add_answer(struct strbuf *out, const struct sensitivity *answer, bool clear)
{
	static const char *const names[CHANGES] = {"work offset X", "work offset Y", "work offset Z", "tool length"};

	strbuf_addf(out, "    %-13s  %c  ", names[answer->quantity], answer->sign > 0 ? '+' : '-');
	if (answer->state == SENSITIVITY_NO_EFFECT) {
		strbuf_addf(out, "no effect: no axis moves differently\n");
		return;
	}
	add_extent(out, answer, clear);
	if (answer->state == SENSITIVITY_TURNS) {
		/* Rounded up: a change by the printed amount changes the verdict. */
		strbuf_addf(out, "; at %.4f ", ceil(answer->turn * 1e4 - 1e-6) / 1e4);
		add_found(out, answer);
	} else if (answer->state == SENSITIVITY_UNKNOWN && answer->why) {
		strbuf_addf(out, "; at %.4f it cannot be checked: ", answer->turn);
		format_units_add_plain(out, answer->why);
	} else if (answer->state == SENSITIVITY_UNKNOWN) {
		strbuf_addf(out, "; stopped there after too many runs");
	}
	strbuf_addf(out, "\n");
}

void sensitivity_report_text(struct strbuf *out, const struct sensitivity *answers, size_t count, bool clear)
{
	strbuf_addf(out, "    with one value of the setup changed (mm):\n");
	for (size_t i = 0; i < count; i++)
		add_answer(out, &answers[i], clear);
}

static json_t *json_answer(const struct sensitivity *answer)
{
	static const char *const names[CHANGES] = {"x", "y", "z", "length"};
	static const char *const states[] = {
		[SENSITIVITY_NO_EFFECT] = "no effect", [SENSITIVITY_HOLDS] = "holds", [SENSITIVITY_TURNS] = "turns",
		[SENSITIVITY_UNKNOWN] = "unknown",
	};
	bool turns = answer->state == SENSITIVITY_TURNS, found = turns && answer->kind >= 0;
	bool limit = found && answer->kind == FINDING_LIMIT;
	const char axis[2] = {limit ? AXIS_LETTERS[answer->slot] : '\0', '\0'};
	json_t *object = json_object();

	json_put(object, "quantity", json_string(names[answer->quantity]));
	json_put(object, "direction", json_string(answer->sign > 0 ? "+" : "-"));
	json_put(object, "range", json_real(answer->range));
	json_put(object, "result", json_string(states[answer->state]));
	json_put(object, "proved", json_real(answer->proved));
	json_put(object, "tried", json_real(answer->tried));
	json_put(object, "turn", turns ? json_real(answer->turn) : json_null());
	json_put(object, "kind", found ? json_string(finding_kind_name((enum finding_kind)answer->kind)) : json_null());
	json_put(object, "line", found ? json_integer(answer->line) : json_null());
	json_put(object, "a", json_text(found ? answer->a : NULL));
	json_put(object, "b", json_text(found ? answer->b : NULL));
	json_put(object, "axis", limit ? json_string(axis) : json_null());
	json_put(object, "why", json_text(answer->why));
	return object;
}

json_t *sensitivity_report_json(const struct sensitivity *answers, size_t count)
{
	json_t *array = json_array();

	for (size_t i = 0; i < count; i++)
		json_push(array, json_answer(&answers[i]));
	return array;
}
