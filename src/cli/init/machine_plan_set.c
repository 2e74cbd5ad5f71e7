#include "cli/init/machine_plan_set.h"

#include <stdlib.h>
#include <string.h>

#include "base/ascii.h"
#include "base/mem.h"
#include "cli/init/machine_plan_value.h"
#include "control/dialects.h"

static const struct srcloc nowhere;

/* Reads the value of one axis from `length` bytes of text. */
static bool set_axis_value(struct machine_plan_axis *axis, int key, const char *text, size_t length)
{
	switch (key) {
	case PLAN_LIMITS:
		return machine_plan_read_limits(axis, text, length);
	case PLAN_HOME:
		return axis->has_home = machine_plan_read_number(&axis->home, text, length);
	case PLAN_TOOL_CHANGE:
		return axis->has_change = machine_plan_read_number(&axis->change, text, length);
	case PLAN_INCLINATION:
		return axis->has_inclination = machine_plan_read_number(&axis->inclination, text, length) &&
					       axis->inclination > 0 && axis->inclination < 180;
	default:
		return axis->has_rate = machine_plan_read_number(&axis->rate, text, length) && axis->rate >= 1e-3;
	}
}

/* AXIS=VALUE,AXIS=VALUE */
static bool set_list(struct machine_plan *plan, int key, const char *text)
{
	for (;;) {
		const char *value;
		int slot = machine_plan_read_letter(text, &value);
		size_t length = strcspn(slot < 0 ? text : value, ",");

		if (slot < 0 || !set_axis_value(&plan->axes[slot], key, value, length))
			return false;
		if (!value[length])
			return true;
		text = value + length + 1;
	}
}

/* AXIS=X,Y,Z */
static bool set_axis_vector(struct machine_plan *plan, int key, const char *text)
{
	int slot = machine_plan_read_letter(text, &text);
	struct machine_plan_axis *axis = slot < 0 ? NULL : &plan->axes[slot];

	if (!axis)
		return false;
	if (key == PLAN_LOCATION)
		return axis->has_location = machine_plan_read_vector(&axis->location, text);
	return axis->has_direction =
		   machine_plan_read_vector(&axis->direction, text) && vec3_norm(axis->direction) >= 1e-6;
}

static bool set_title(struct machine_plan *plan, const char *text)
{
	int slot = machine_plan_read_letter(text, &text);

	if (slot < 0 || !machine_plan_is_text(text))
		return false;
	plan->axes[slot].title = arena_strdup(&plan->arena, text);
	return true;
}

/* LINK=FILE; the body gets the name of the file. */
static bool set_body(struct machine_plan *plan, const char *text)
{
	static const char base[] = "base=";
	bool fixed = !strncmp(text, base, sizeof(base) - 1);
	int slot = fixed ? -1 : machine_plan_read_letter(text, &text);
	const char *file, *dot;
	char *folder, *name;

	if (fixed)
		text += sizeof(base) - 1;
	if ((slot < 0 && !fixed) || !machine_plan_is_text(text))
		return false;
	file = strrchr(text, '/') ? strrchr(text, '/') + 1 : text;
	dot = strrchr(file, '.') ? strrchr(file, '.') : file + strlen(file);
	folder = mem_strndup(text, (size_t)(file - text));
	name = mem_strndup(file, (size_t)(dot - file));
	if (*name)
		machine_plan_add_body(plan, slot, folder, name, dot);
	free(folder);
	free(name);
	return dot > file;
}

/* NAME=VALUE */
static bool set_answer(struct machine_plan *plan, const char *text)
{
	const size_t length = strspn(text, "abcdefghijklmnopqrstuvwxyz0123456789_");
	char *name;

	if (!length || ascii_is_digit(*text) || text[length] != '=' ||
	    !machine_plan_is_text(text + length + 1))
		return false;
	name = arena_strdup(&plan->arena, text);
	name[length] = '\0';
	plan->answers =
	    mem_grow(plan->answers, &plan->answer_capacity, plan->answer_count + 1, sizeof(*plan->answers));
	plan->answers[plan->answer_count++] = (struct machine_plan_answer){name, name + length + 1};
	return true;
}

/* "none", or the positions of axes; machine_plan_finish rejects both together. */
static bool set_tool_change(struct machine_plan *plan, const char *text)
{
	bool none = !strcmp(text, "none");

	if (!none && !set_list(plan, PLAN_TOOL_CHANGE, text))
		return false;
	plan->changes_anywhere = plan->changes_anywhere || none;
	return plan->has_tool_change = true;
}

static bool set_choice(int *out, const char *const *choices, const char *text)
{
	for (int i = 0; choices[i]; i++) {
		if (!strcmp(choices[i], text)) {
			*out = i;
			return true;
		}
	}
	return false;
}

static bool set_rotary(struct machine_plan *plan, const char *text)
{
	struct machine_plan_chain chain;

	if (!machine_plan_read_chain(&chain, text, true) || chain.count != 2)
		return false;
	plan->rotary = chain;
	return true;
}

static bool set_value(struct machine_plan *plan, int key, const char *text)
{
	switch (key) {
	case PLAN_FAMILY:
		return set_choice(&plan->family, machine_plan_families, text);
	case PLAN_ROTARY:
		return set_rotary(plan, text);
	case PLAN_HEAD:
		return plan->has_head = machine_plan_read_chain(&plan->head, text, false);
	case PLAN_TABLE:
		return plan->has_table = machine_plan_read_chain(&plan->table, text, false);
	case PLAN_LIMITS:
	case PLAN_HOME:
	case PLAN_INCLINATION:
	case PLAN_RATES:
		return set_list(plan, key, text);
	case PLAN_LOCATION:
	case PLAN_DIRECTION:
		return set_axis_vector(plan, key, text);
	case PLAN_SPINDLE:
		return plan->has_spindle = machine_plan_read_vector(&plan->spindle, text);
	case PLAN_SPINDLE_DIRECTION:
		return machine_plan_read_vector(&plan->spindle_direction, text) &&
		       vec3_norm(plan->spindle_direction) >= 1e-6;
	case PLAN_WORKHOLDING:
		return plan->has_workholding = machine_plan_read_vector(&plan->workholding, text);
	case PLAN_TITLE:
		return set_title(plan, text);
	case PLAN_BODY:
		return set_body(plan, text);
	case PLAN_TOOL_CHANGE:
		return set_tool_change(plan, text);
	case PLAN_CONTROLLER:
		return set_answer(plan, text);
	case PLAN_NAME:
		plan->name = arena_strdup(&plan->arena, text);
		return machine_plan_is_text(text);
	case PLAN_UNITS:
		return set_choice(&plan->inch, machine_plan_units, text);
	case PLAN_DIALECT:
		return set_choice(&plan->dialect, dialect_names, text);
	case PLAN_RAPID:
		return set_choice(&plan->rapid, machine_plan_rapids, text);
	default:
		return false;
	}
}

/* Details that the form of the argument does not show. */
static const char *hint_of(int key)
{
	switch (key) {
	case PLAN_LIMITS:
		return ": MIN is less than MAX, both within 100000, or AXIS=none";
	case PLAN_ROTARY:
		return ": two of A, B and C";
	case PLAN_RATES:
		return ": more than 0, within 100000";
	case PLAN_INCLINATION:
		return ": more than 0, less than 180";
	case PLAN_DIRECTION:
	case PLAN_SPINDLE_DIRECTION:
		return ": not all three are 0";
	default:
		return "";
	}
}

bool machine_plan_set(struct machine_plan *plan, const struct option_row *row, const char *text, struct diag *diag)
{
	struct strbuf names = {0};

	if (set_value(plan, row->key, text))
		return true;
	if (row->choices) {
		for (int i = 0; row->choices[i]; i++)
			strbuf_addf(&names, "%s%s", i ? ", " : "", row->choices[i]);
		diag_error(diag, nowhere, "%s%s: '%s' is not one of %s", row->key == PLAN_FAMILY ? "" : "--", row->name,
			   text, strbuf_text(&names));
	} else {
		diag_error(diag, nowhere, "--%s: '%s' does not have the form %s%s", row->name, text, row->argument,
			   hint_of(row->key));
	}
	strbuf_release(&names);
	return false;
}
