#include "gcode/execute/tool_table.h"

#include <stdlib.h>
#include <string.h>

#include "base/ascii.h"
#include "base/mem.h"
#include "gcode/text/fault.h"

void tool_table_init(struct tool_table *table, const struct gcode_config *config)
{
	table->tools = mem_zalloc(config->tool_count, sizeof(*table->tools));
	table->tool_count = config->tool_count;
	for (size_t i = 0; i < config->tool_count; i++) {
		table->tools[i] = config->tools[i];
		table->tools[i].length_offset += config->length_change;
	}
	table->lengths = mem_zalloc(config->length_count, sizeof(*table->lengths));
	table->length_count = table->length_capacity = config->length_count;
	for (size_t i = 0; i < config->length_count; i++) {
		table->lengths[i] = config->lengths[i];
		table->lengths[i].length += config->length_change;
	}
	table->radii = mem_zalloc(config->radius_count, sizeof(*table->radii));
	table->radius_count = table->radius_capacity = config->radius_count;
	for (size_t i = 0; i < config->radius_count; i++)
		table->radii[i] = config->radii[i];
	table->any = config->any_tool;
}

void tool_table_release(struct tool_table *table)
{
	free(table->tools);
	free(table->lengths);
	free(table->radii);
	free(table->wears);
	*table = (struct tool_table){0};
}

const struct tool *tool_table_find(const struct tool_table *table, int number)
{
	for (size_t i = 0; i < table->tool_count; i++) {
		if (table->tools[i].number == number)
			return &table->tools[i];
	}
	return number > 0 ? table->any : NULL;
}

bool tool_table_find_name(const struct tool_table *table, const struct line_place *at, int column, const char *name,
			  bool any_case, const struct tool **found)
{
	const struct tool *first = NULL;

	for (size_t i = 0; i < table->tool_count; i++) {
		const struct tool *tool = &table->tools[i];

		if (!tool->name || !(any_case ? ascii_same(tool->name, name) : !strcmp(tool->name, name)))
			continue;
		if (first)
			return fault(at, column,
				     "the setup has two tools named \"%s\", T%d and T%d, and the control decides which "
				     "it loads: keep the one in the spindle, or give the other one another name",
				     name, first->number, tool->number);
		first = tool;
	}
	if (!first)
		first = table->any;
	if (!first)
		return fault(at, column,
			     "the setup defines no tool named \"%s\": add <tool number=\"\" name=\"%s\" length=\"\"/> "
			     "with what it is made of",
			     name, name);
	*found = first;
	return true;
}

static struct length_offset *find_length(const struct tool_table *table, int number)
{
	for (size_t i = 0; i < table->length_count; i++) {
		if (table->lengths[i].number == number)
			return &table->lengths[i];
	}
	return NULL;
}

static struct radius_offset *find_radius(const struct tool_table *table, int number)
{
	for (size_t i = 0; i < table->radius_count; i++) {
		if (table->radii[i].number == number)
			return &table->radii[i];
	}
	return NULL;
}

const struct length_offset *tool_table_length(const struct tool_table *table, int number)
{
	return find_length(table, number);
}

const struct radius_offset *tool_table_radius(const struct tool_table *table, int number)
{
	return find_radius(table, number);
}

void tool_table_set_length(struct tool_table *table, int number, double length)
{
	for (size_t i = 0; i < table->tool_count; i++) {
		if (table->tools[i].number == number)
			table->tools[i].length_offset = length;
	}
	for (size_t i = 0; i < table->length_count; i++) {
		if (table->lengths[i].number == number)
			table->lengths[i].length = length;
	}
}

struct length_offset *tool_table_need_length(struct tool_table *table, int number)
{
	struct length_offset *found = find_length(table, number);

	if (found)
		return found;
	table->lengths =
	    mem_grow(table->lengths, &table->length_capacity, table->length_count + 1, sizeof(*table->lengths));
	table->lengths[table->length_count] = (struct length_offset){.number = number};
	return &table->lengths[table->length_count++];
}

struct radius_offset *tool_table_need_radius(struct tool_table *table, int number)
{
	struct radius_offset *found = find_radius(table, number);

	if (found)
		return found;
	table->radii = mem_grow(table->radii, &table->radius_capacity, table->radius_count + 1, sizeof(*table->radii));
	table->radii[table->radius_count] = (struct radius_offset){.number = number};
	return &table->radii[table->radius_count++];
}

struct offset_wear *tool_table_need_wear(struct tool_table *table, char letter, int number)
{
	for (size_t i = 0; i < table->wear_count; i++) {
		if (table->wears[i].letter == letter && table->wears[i].number == number)
			return &table->wears[i];
	}
	table->wears = mem_grow(table->wears, &table->wear_capacity, table->wear_count + 1, sizeof(*table->wears));
	table->wears[table->wear_count] = (struct offset_wear){.letter = letter, .number = number};
	return &table->wears[table->wear_count++];
}

void tool_table_set_diameter(struct tool_table *table, int number, double diameter)
{
	for (size_t i = 0; i < table->tool_count; i++) {
		if (table->tools[i].number == number)
			table->tools[i].diameter = diameter;
	}
}
