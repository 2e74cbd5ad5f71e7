#include "gcode/execute/tool_table.h"

#include <stdlib.h>

#include "base/mem.h"

void tool_table_init(struct tool_table *table, const struct gcode_config *config)
{
	table->tools = mem_zalloc(config->tool_count, sizeof(*table->tools));
	table->tool_count = config->tool_count;
	for (size_t i = 0; i < config->tool_count; i++) {
		table->tools[i] = config->tools[i];
		table->tools[i].length_offset += config->length_change;
	}
	table->lengths = mem_zalloc(config->length_count, sizeof(*table->lengths));
	table->length_count = config->length_count;
	for (size_t i = 0; i < config->length_count; i++) {
		table->lengths[i] = config->lengths[i];
		table->lengths[i].length += config->length_change;
	}
	table->radii = mem_zalloc(config->radius_count, sizeof(*table->radii));
	table->radius_count = config->radius_count;
	for (size_t i = 0; i < config->radius_count; i++)
		table->radii[i] = config->radii[i];
}

void tool_table_release(struct tool_table *table)
{
	free(table->tools);
	free(table->lengths);
	free(table->radii);
	*table = (struct tool_table){0};
}

const struct tool *tool_table_find(const struct tool_table *table, int number)
{
	for (size_t i = 0; i < table->tool_count; i++) {
		if (table->tools[i].number == number)
			return &table->tools[i];
	}
	return NULL;
}

const struct length_offset *tool_table_length(const struct tool_table *table, int number)
{
	for (size_t i = 0; i < table->length_count; i++) {
		if (table->lengths[i].number == number)
			return &table->lengths[i];
	}
	return NULL;
}

const struct radius_offset *tool_table_radius(const struct tool_table *table, int number)
{
	for (size_t i = 0; i < table->radius_count; i++) {
		if (table->radii[i].number == number)
			return &table->radii[i];
	}
	return NULL;
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

void tool_table_set_diameter(struct tool_table *table, int number, double diameter)
{
	for (size_t i = 0; i < table->tool_count; i++) {
		if (table->tools[i].number == number)
			table->tools[i].diameter = diameter;
	}
}
