#include "machine/setup.h"

#include <stdlib.h>

void setup_free(struct setup *setup)
{
	if (!setup)
		return;
	arena_release(&setup->arena);
	free(setup);
}

const struct tool *setup_tool(const struct setup *setup, int number)
{
	for (size_t i = 0; i < setup->tool_count; i++)
		if (setup->tools[i].number == number)
			return &setup->tools[i];
	return NULL;
}
