#include "cli/init/machine_plan_finish.h"

#include <math.h>
#include <string.h>

#include "control/dialects.h"
#include "machine/machine.h"

static const struct srcloc nowhere;

/* The order in which linear axes carry each other on the paper's machine. */
static const int linear_slots[] = {SLOT_Y, SLOT_X, SLOT_Z};
enum { LINEAR_COUNT = sizeof(linear_slots) / sizeof(linear_slots[0]) };

/* Linear axes that are missing in one chain belong to the other. */
static void add_rest(struct machine_plan_chain *chain, const struct machine_plan_chain *other)
{
	for (int i = 0; i < LINEAR_COUNT; i++) {
		if (!machine_plan_chain_has(other, linear_slots[i]))
			chain->slots[chain->count++] = linear_slots[i];
	}
}

static bool join_linear(struct machine_plan *plan, struct diag *diag)
{
	if (!plan->has_head)
		add_rest(&plan->head, &plan->table);
	else if (!plan->has_table)
		add_rest(&plan->table, &plan->head);
	for (int i = 0; i < LINEAR_COUNT; i++) {
		int slot = linear_slots[i];

		if (machine_plan_chain_has(&plan->head, slot) != machine_plan_chain_has(&plan->table, slot))
			continue;
		diag_error(diag, nowhere, "--head and --table must share X, Y and Z, but %c is in %s",
			   AXIS_LETTERS[slot], machine_plan_chain_has(&plan->head, slot) ? "both" : "neither");
		return false;
	}
	return true;
}

static void join_rotary(struct machine_plan *plan)
{
	for (size_t i = 0; i < plan->rotary.count; i++) {
		bool table = plan->family == FAMILY_TABLE_TABLE || plan->family == FAMILY_NUTATING_TABLE ||
			     (plan->family == FAMILY_HEAD_TABLE && i == 1);
		struct machine_plan_chain *chain = table ? &plan->table : &plan->head;

		chain->slots[chain->count++] = plan->rotary.slots[i];
	}
}

static bool is_told(const struct machine_plan_axis *axis)
{
	return axis->has_limits || axis->has_location || axis->has_direction || axis->has_inclination ||
	       axis->has_rate || axis->has_home || axis->has_change || axis->title;
}

/* Is the value of an option within the travel? False: reported. */
static bool is_within(const struct machine_plan_axis *axis, char letter, double value, const char *option,
		      struct diag *diag)
{
	if (!(axis->has_min && value < axis->min) && !(axis->has_max && value > axis->max))
		return true;
	diag_error(diag, nowhere, "the %s of %c, %g, is outside its travel: --%s=%c=VALUE", option, letter, value,
		   option, letter);
	return false;
}

static bool check_axis(const struct machine_plan *plan, int slot, struct diag *diag)
{
	const struct machine_plan_axis *axis = &plan->axes[slot];
	char letter = AXIS_LETTERS[slot];

	if (!machine_plan_has_axis(plan, slot)) {
		if (is_told(axis))
			diag_error(diag, nowhere, "an option names the axis %c, but the machine has X, Y, Z, %c and %c",
				   letter, AXIS_LETTERS[plan->rotary.slots[0]], AXIS_LETTERS[plan->rotary.slots[1]]);
		return !is_told(axis);
	}
	return is_within(axis, letter, axis->home, "home", diag) &&
	       (!axis->has_change || is_within(axis, letter, axis->change, "tool-change", diag));
}

static bool check_bodies(const struct machine_plan *plan, struct diag *diag)
{
	for (size_t i = 0; i < plan->body_count; i++) {
		const struct machine_plan_body *body = &plan->bodies[i];

		if (body_name_is_reserved(body->name)) {
			diag_error(diag, nowhere,
				   "--body: the name '%s' has another meaning in a machine file: give the file %s "
				   "another name",
				   body->name, body->path);
			return false;
		}
		if (body->slot >= 0 && !machine_plan_has_axis(plan, body->slot)) {
			diag_error(diag, nowhere, "--body: %s is on axis %c, which the machine does not have",
				   body->path, AXIS_LETTERS[body->slot]);
			return false;
		}
		for (size_t k = 0; k < i; k++) {
			if (strcmp(plan->bodies[k].name, body->name) != 0)
				continue;
			diag_error(diag, nowhere,
				   "--body: two bodies would have the name '%s': give the file %s another name",
				   body->name, body->path);
			return false;
		}
	}
	return true;
}

/* The default name of the body on a link; NULL: its name is that of the axis. */
static const char *usual_name(const struct machine_plan *plan, const struct machine_plan_chain *chain, size_t i)
{
	bool table = chain == &plan->table;

	if (i + 1 == chain->count)
		return table ? "table" : "head";
	if (slot_is_rotary(chain->slots[i]))
		return table ? "cradle" : "fork";
	return NULL;
}

/* Adds a body with a default file to the link unless the options gave it one. */
static void add_usual(struct machine_plan *plan, int slot, const char *name)
{
	struct strbuf text = {0};

	for (size_t i = 0; i < plan->body_count; i++) {
		if (plan->bodies[i].slot == slot)
			return;
	}
	if (name)
		strbuf_addf(&text, "%s", name);
	else
		strbuf_addf(&text, "%c_slide", AXIS_LETTERS[slot]);
	machine_plan_add_body(plan, slot, "stl/", strbuf_text(&text), ".stl");
	strbuf_release(&text);
}

static void add_usual_bodies(struct machine_plan *plan)
{
	const struct machine_plan_chain *chains[] = {&plan->head, &plan->table};

	add_usual(plan, -1, "bed");
	for (int c = 0; c < 2; c++) {
		for (size_t i = 0; i < chains[c]->count; i++)
			add_usual(plan, chains[c]->slots[i], usual_name(plan, chains[c], i));
	}
}

/* Degrees from Z: a smaller angle of an oblique axis is probably in radians, or mistyped. */
#define INCLINATION_LEAST 25

/* An axis may have a direction or an inclination, not both; C and the linear axes have no inclination. */
static bool check_inclinations(const struct machine_plan *plan, struct diag *diag)
{
	for (int slot = 0; slot < SLOT_COUNT; slot++) {
		const struct machine_plan_axis *axis = &plan->axes[slot];

		if (axis->has_inclination &&
		    (axis->inclination < INCLINATION_LEAST || axis->inclination > 180 - INCLINATION_LEAST))
			diag_warning(diag, nowhere,
				     "--inclination of %c: %c stands only %.6g degrees from Z, and so turns like C; "
				     "angles are in degrees, 45 for most nutating heads and tables",
				     AXIS_LETTERS[slot], AXIS_LETTERS[slot],
				     fmin(axis->inclination, 180 - axis->inclination));
		if (!axis->has_inclination || (!axis->has_direction && (slot == SLOT_A || slot == SLOT_B)))
			continue;
		diag_error(diag, nowhere, "--inclination of %c: %s", AXIS_LETTERS[slot],
			   axis->has_direction ? "its --direction is given as well" : "only A and B have one");
		return false;
	}
	return true;
}

/* C is already along Z. */
static bool check_tilted(const struct machine_plan *plan, struct diag *diag)
{
	int slot = machine_plan_tilted(plan);

	if (slot != SLOT_C || plan->axes[slot].has_direction)
		return true;
	diag_error(diag, nowhere,
		   "the oblique axis of a %s is its %s rotary axis, which is C here: exchange the axes, or give its "
		   "--direction",
		   machine_plan_families[plan->family], slot == plan->rotary.slots[0] ? "first" : "second");
	return false;
}

static bool check_tool_change(const struct machine_plan *plan, struct diag *diag)
{
	for (int slot = 0; slot < SLOT_COUNT; slot++) {
		if (!plan->changes_anywhere || !plan->axes[slot].has_change)
			continue;
		diag_error(diag, nowhere, "--tool-change: both none and a position of %c are given",
			   AXIS_LETTERS[slot]);
		return false;
	}
	return true;
}

/* The reader of machine files checks the meaning of a name; here: is it given only once? */
static bool check_answers(const struct machine_plan *plan, struct diag *diag)
{
	for (size_t i = 0; i < plan->answer_count; i++) {
		const char *name = plan->answers[i].name;

		if (!strcmp(name, "dialect") || !strcmp(name, "rapid")) {
			diag_error(diag, nowhere, "--controller: %s has its own option --%s=%s", name, name,
				   plan->answers[i].value);
			return false;
		}
		for (size_t k = 0; k < i; k++) {
			if (strcmp(plan->answers[k].name, name) != 0)
				continue;
			diag_error(diag, nowhere, "--controller: %s is given twice, as %s and %s", name,
				   plan->answers[k].value, plan->answers[i].value);
			return false;
		}
	}
	return true;
}

bool machine_plan_finish(struct machine_plan *plan, struct diag *diag)
{
	for (int slot = 0; slot < SLOT_COUNT; slot++) {
		if (!check_axis(plan, slot, diag))
			return false;
	}
	if (!join_linear(plan, diag) || !check_inclinations(plan, diag) || !check_tilted(plan, diag))
		return false;
	if (!check_tool_change(plan, diag) || !check_answers(plan, diag))
		return false;
	join_rotary(plan);
	add_usual_bodies(plan);
	if (!check_bodies(plan, diag))
		return false;
	if (plan->inch < 0)
		plan->inch = 0;
	if (plan->dialect < 0)
		plan->dialect = 0;
	/* If a parameter of the control decides how G0 moves, all possible paths are checked until it is known. */
	if (plan->rapid < 0)
		plan->rapid = dialect_rows[plan->dialect].straight_rapids ? RAPID_LINEAR : RAPID_ANY;
	return true;
}
