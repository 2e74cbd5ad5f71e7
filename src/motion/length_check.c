#include "motion/length_check.h"

#include <math.h>

/* mm: lengths that differ by less are measured lengths of tools of one kind. */
static const double DIFFERENT = 0.5;
/* mm: numbers that differ by less are the same length. */
static const double SAME = 1e-6;

void length_check_tool(struct length_check *check, const struct setup *setup, int tool)
{
	const struct tool *it = setup && !check->told ? setup_tool(setup, tool) : NULL;

	check->setup = setup;
	check->tool = it && it->kind == TOOL_TURNS && !it->checked ? it : NULL;
	check->last = 0;
}

/* The H with the tool's number. */
static double length_of(const struct setup *setup, const struct tool *tool)
{
	for (size_t i = 0; i < setup->length_count; i++) {
		if (setup->lengths[i].number == tool->number)
			return setup->lengths[i].length;
	}
	return tool->length_offset;
}

/* mm: the difference of the length from the closest one of the tool's edges. */
static double off_own(const struct setup *setup, const struct tool *tool, double length)
{
	double least = fabs(length - length_of(setup, tool));

	for (size_t i = 0; i < setup->edge_count; i++) {
		if (setup->edges[i].tool == tool->number)
			least = fmin(least, fabs(length - setup->edges[i].length));
	}
	return least;
}

void length_check_look(struct length_check *check, struct diag *diag, struct srcloc at, double length)
{
	const struct setup *setup = check->setup;
	const struct tool *tool = check->tool;

	check->last = length;
	if (!(fabs(length) > SAME) || off_own(setup, tool, length) < DIFFERENT)
		return;
	for (size_t i = 0; i < setup->tool_count; i++) {
		const struct tool *other = &setup->tools[i];

		if (other == tool || fabs(length_of(setup, other) - length) > SAME)
			continue;
		diag_warning(diag, at,
			     "T%d cuts with the length of T%d: %.6g mm instead of %.6g mm; check H, or write G43 again "
			     "after the tool change, or set checked=\"reason\" for the tool",
			     tool->number, other->number, length, length_of(setup, tool));
		check->told = true;
		check->tool = NULL;
		return;
	}
}
