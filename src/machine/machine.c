#include "machine/machine.h"

#include <stdlib.h>
#include <string.h>

#include "base/spelling.h"
#include "base/units.h"
#include "geom/tolerance.h"
#include "machine/setup.h"

void machine_free(struct machine *machine)
{
	if (!machine)
		return;
	setup_free(machine->setup);
	arena_release(&machine->arena);
	free(machine);
}

const struct axis *machine_axis(const struct machine *machine, int slot)
{
	for (size_t i = 0; i < machine->axis_count; i++)
		if (machine->axes[i].slot == slot)
			return &machine->axes[i];
	return NULL;
}

bool axis_allows(const struct axis *axis, double position)
{
	double tolerance = axis->rotary ? radians(LIMIT_TOLERANCE) : LIMIT_TOLERANCE;

	return position >= axis->limit_min - tolerance && position <= axis->limit_max + tolerance;
}

const char *machine_link_name(const struct machine *machine, int link)
{
	return link > 0 ? machine->axes[link - 1].name : "base";
}

axis_values machine_home(const struct machine *machine)
{
	axis_values home = {{0}};

	for (size_t i = 0; i < machine->axis_count; i++)
		home.v[machine->axes[i].slot] = machine->axes[i].home;
	return home;
}

/* At most this number of unknown names is listed. */
#define UNKNOWN_MAX 20

struct body_list {
	const struct body *bodies;
	size_t count;
};

static bool knows_body(const struct body_list *list, const char *name)
{
	for (size_t i = 0; i < list->count; i++)
		if (strcmp(list->bodies[i].name, name) == 0)
			return true;
	return false;
}

/* The bodies of the machine, of its own setup and of another setup; the last two may be empty. */
static bool check_name(const struct body_list lists[3], const struct pair_name *name, bool any_setup,
		       struct srcloc loc, struct diag *diag)
{
	struct spelling nearest;

	if (name->kind != NAME_BODY)
		return true;
	for (int k = 0; k < 3; k++)
		if (knows_body(&lists[k], name->body))
			return true;
	if (!any_setup) {
		diag_warning(diag, loc,
			     "<pair>: the machine has no body '%s', and there is no setup that could have one",
			     name->body);
		return false;
	}
	spelling_init(&nearest, name->body);
	for (int k = 0; k < 3; k++)
		for (size_t i = 0; i < lists[k].count; i++)
			spelling_offer(&nearest, lists[k].bodies[i].name);
	if (nearest.best)
		diag_error(diag, loc, "<pair>: neither the machine nor the setup has a body '%s'; did you mean '%s'?",
			   name->body, nearest.best);
	else
		diag_error(diag, loc, "<pair>: neither the machine nor the setup has a body '%s'", name->body);
	return false;
}

bool machine_check_rules(const struct machine *machine, const struct setup *setup, struct diag *diag)
{
	const struct setup *own = machine->setup;
	struct body_list lists[3] = {{machine->bodies, machine->body_count}};
	size_t unknown = 0;

	if (own)
		lists[1] = (struct body_list){own->bodies, own->body_count};
	if (setup)
		lists[2] = (struct body_list){setup->bodies, setup->body_count};
	for (size_t i = 0; i < machine->rule_count && unknown < UNKNOWN_MAX; i++) {
		const struct pair_rule *rule = &machine->rules[i];
		struct srcloc loc = {.file = machine->path, .line = rule->line};

		unknown += !check_name(lists, &rule->a, own || setup, loc, diag);
		unknown += !check_name(lists, &rule->b, own || setup, loc, diag);
	}
	return unknown == 0 || !(own || setup);
}
