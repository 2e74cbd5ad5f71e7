/* tool_table.h - the control's lengths and diameters of tools: those of the setup, until the program changes them. */
#ifndef FIVECHECK_GCODE_EXECUTE_TOOL_TABLE_H
#define FIVECHECK_GCODE_EXECUTE_TOOL_TABLE_H

#include "gcode/config.h"

/* The wear that a program wrote for an H or D; the entry of H or D includes the wear. */
struct offset_wear {
	char letter;
	int number;
	double value;
};

/* In mm; a copy of the configuration's data: a program changes the copy only. */
struct tool_table {
	struct tool *tools;
	size_t tool_count;
	struct length_offset *lengths;
	size_t length_count, length_capacity;
	struct radius_offset *radii;
	size_t radius_count, radius_capacity;
	struct offset_wear *wears;
	size_t wear_count, wear_capacity;
	const struct tool *any;	/* the tool for all other numbers except 0; or NULL */
};

void tool_table_init(struct tool_table *table, const struct gcode_config *config);
void tool_table_release(struct tool_table *table);

/* The entry of tool T, and of length H; NULL: there is none. */
const struct tool *tool_table_find(const struct tool_table *table, int number);

/*
 * Finds the tool with this name; any_case: a letter in upper case and in lower case are the same. False, reported at
 * the column: there is none, or there are several. On a control, tools of one name replace each other when one is worn,
 * and no program tells which of them it loads.
 */
bool tool_table_find_name(const struct tool_table *table, const struct line_place *at, int column, const char *name,
			  bool any_case, const struct tool **found);

const struct length_offset *tool_table_length(const struct tool_table *table, int number);

/* The entry of radius D; NULL: there is none. */
const struct radius_offset *tool_table_radius(const struct tool_table *table, int number);

/* Sets the length of a tool, and of the H with the same number. No effect if the table has no such tool. */
void tool_table_set_length(struct tool_table *table, int number, double length);
/*
 * The entries of H and D, and of the wear of one of them; an entry with 0 is added if the table has none. Valid until
 * the next entry is added.
 */
struct length_offset *tool_table_need_length(struct tool_table *table, int number);
struct radius_offset *tool_table_need_radius(struct tool_table *table, int number);
struct offset_wear *tool_table_need_wear(struct tool_table *table, char letter, int number);
void tool_table_set_diameter(struct tool_table *table, int number, double diameter);

#endif
