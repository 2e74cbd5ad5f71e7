#include "cli/init/machine_plan.h"

#include <stdlib.h>

#include "base/mem.h"
#include "machine/machine.h"

const char *const machine_plan_families[FAMILY_COUNT + 1] = {
	[FAMILY_TABLE_TABLE] = "table-table", [FAMILY_HEAD_HEAD] = "head-head", [FAMILY_HEAD_TABLE] = "head-table",
	[FAMILY_NUTATING_TABLE] = "nutating-table", [FAMILY_NUTATING_HEAD] = "nutating-head",
};
const char *const machine_plan_rapids[] = {
	[RAPID_LINEAR] = "linear", [RAPID_DOGLEG] = "dogleg", [RAPID_ANY] = "any", NULL,
};
const char *const machine_plan_units[] = {"mm", "inch", NULL};

void machine_plan_init(struct machine_plan *plan)
{
	*plan = (struct machine_plan){
	    .family = -1, .inch = -1, .dialect = -1, .rapid = -1, .spindle_direction = {0, 0, -1}};
}

void machine_plan_release(struct machine_plan *plan)
{
	arena_release(&plan->arena);
	free(plan->bodies);
	free(plan->answers);
	*plan = (struct machine_plan){0};
}

void machine_plan_add_body(struct machine_plan *plan, int slot, const char *folder, const char *name,
			   const char *ending)
{
	struct strbuf path = {0};

	strbuf_addf(&path, "%s%s%s", folder, name, ending);
	plan->bodies = mem_grow(plan->bodies, &plan->body_capacity, plan->body_count + 1, sizeof(*plan->bodies));
	plan->bodies[plan->body_count++] = (struct machine_plan_body){
		slot, arena_strdup(&plan->arena, strbuf_text(&path)), arena_strdup(&plan->arena, name)};
	strbuf_release(&path);
}

bool machine_plan_chain_has(const struct machine_plan_chain *chain, int slot)
{
	for (size_t i = 0; i < chain->count; i++) {
		if (chain->slots[i] == slot)
			return true;
	}
	return false;
}

bool machine_plan_has_axis(const struct machine_plan *plan, int slot)
{
	return slot <= SLOT_Z || machine_plan_chain_has(&plan->rotary, slot);
}

bool machine_plan_turns_table(const struct machine_plan *plan, int slot)
{
	return machine_plan_chain_has(&plan->table, slot);
}

int machine_plan_tilted(const struct machine_plan *plan)
{
	if (plan->family == FAMILY_NUTATING_TABLE)
		return plan->rotary.slots[0];
	return plan->family == FAMILY_NUTATING_HEAD ? plan->rotary.slots[1] : -1;
}
