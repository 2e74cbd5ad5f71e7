/* tool_library.h - the contents of a tool library or an offset listing of another program, as parts of a setup. */
#ifndef FIVECHECK_MACHINE_LIBRARY_TOOL_LIBRARY_H
#define FIVECHECK_MACHINE_LIBRARY_TOOL_LIBRARY_H

#include <stdbool.h>
#include <stddef.h>

#include "base/diag.h"
#include "machine/description.h"
#include "machine/library/tool_profile.h"

/* The numbers from `first` to `last`. */
struct number_range {
	long first, last;
	bool used;	/* a tool or an offset had a number in the range */
};

/* The place of a tool or an offset in its file. */
struct library_place {
	long line;	/* 0: the file has no lines that matter, such as JSON */
	size_t entry;	/* of its list, from 1; 0: it has none */
};

/* Lengths in mm. The texts and sections are in the description's arena; the library owns its arrays. */
struct tool_library {
	struct setup_description setup;	/* tools, edges, values and offsets; everything else is empty */
	size_t tool_capacity, length_capacity, offset_capacity, value_capacity, edge_capacity;
	struct library_place *tool_places, *length_places;	/* one for each tool and length of the setup */
	size_t tool_place_capacity, length_place_capacity;
	size_t left_out;	/* tools of the library that were left out */
	bool counts_left_out;	/* without a warning for each */
	bool unit_is_assumed;	/* the file does not give the unit of a length, so that of the options was used */
	struct number_range *wanted;	/* only these numbers are added; NULL: all */
	size_t wanted_count;
};

/* All zero is an empty library. */
void tool_library_release(struct tool_library *tools);

/* Must a tool or an offset of this number be added? */
bool tool_library_wants(struct tool_library *tools, long number);

/*
 * A tool as libraries describe it: heights above its tip; the outlines of its cutter, shank and holder, which may
 * overlap. The gauge line is at `length`.
 */
struct tool_outline {
	long number;
	size_t entry;	/* of a list, from 1, if its lines do not matter; 0: the line is its place */
	const char *name;	/* or NULL */
	enum tool_kind kind;
	enum tool_hand hand;
	double length;
	struct optional_number length_offset, radius_offset;	/* of the control, if it has others than the shape */
	struct tool_profile cutter, shank, holder;
	bool has_tip;	/* the lowest part of the cutter has this shape; in the outline it is a cylinder */
	enum tool_tip tip;
	double corner, angle;	/* mm; radians */
	double flute_length;	/* mm; 0: unknown */
	double diameter;	/* mm, of the cutter */
};

void tool_outline_release(struct tool_outline *outline);

/* The length and the radius (mm) with which the control compensates; values of the shape are not stored. */
void tool_outline_compensate(struct tool_outline *outline, double length, double radius);

/* Adds the tool. False, reported: its number is already used, or it has no length. */
bool tool_library_add(struct tool_library *tools, const struct tool_outline *outline, struct srcloc at,
		      struct diag *diag);

/*
 * Adds the control's values for H and D of a number. False, reported: the number is already used, or not possible in a
 * setup.
 */
bool tool_library_add_offset(struct tool_library *tools, const struct length_offset_description *offset,
			     struct srcloc at, struct diag *diag);

/* Adds a row of a control's tool table, if its number is wanted. The texts are copied. */
void tool_library_add_values(struct tool_library *tools, const struct tool_values_description *values);

/* Adds an edge to a tool of the library. */
void tool_library_add_edge(struct tool_library *tools, const struct edge_description *edge);

/* The work offset of this name; it is made if it does not exist. Valid until the next one is made. */
struct work_offset_description *tool_library_work_offset(struct tool_library *tools, const char *name);

#endif
