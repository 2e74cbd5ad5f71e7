/* tool_table.h - the control's lengths and diameters of tools: from the setup, until the program writes others. */
#ifndef FIVECHECK_GCODE_EXECUTE_TOOL_TABLE_H
#define FIVECHECK_GCODE_EXECUTE_TOOL_TABLE_H

#include "gcode/config.h"

/* What a program wrote as the wear of an H or D, which is a part of the whole. */
struct offset_wear {
	char letter;
	int number;
	double value;
};

/* In mm; a copy of the configuration's, which stays as it is. */
struct tool_table {
	struct tool *tools;
	size_t tool_count;
	struct length_offset *lengths;
	size_t length_count, length_capacity;
	struct radius_offset *radii;
	size_t radius_count, radius_capacity;
	struct offset_wear *wears;
	size_t wear_count, wear_capacity;
	const struct tool *any;	/* of every other number but 0; or NULL */
};

void tool_table_init(struct tool_table *table, const struct gcode_config *config);
void tool_table_release(struct tool_table *table);

/* The entry of tool T, and of length H; NULL: there is none. */
const struct tool *tool_table_find(const struct tool_table *table, int number);
const struct length_offset *tool_table_length(const struct tool_table *table, int number);

/* The entry of radius D; NULL: there is none. */
const struct radius_offset *tool_table_radius(const struct tool_table *table, int number);

/* These change nothing if the table has no such tool. The length is also that of H with the same number. */
void tool_table_set_length(struct tool_table *table, int number, double length);
/*
 * The entries of H and D, and of the wear of one of them; made, with 0, if the table has none. Valid until the next
 * of them is made.
 */
struct length_offset *tool_table_need_length(struct tool_table *table, int number);
struct radius_offset *tool_table_need_radius(struct tool_table *table, int number);
struct offset_wear *tool_table_need_wear(struct tool_table *table, char letter, int number);
void tool_table_set_diameter(struct tool_table *table, int number, double diameter);

#endif
