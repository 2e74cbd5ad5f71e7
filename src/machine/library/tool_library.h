/* tool_library.h - what a tool library or an offset listing of another program holds, as parts of a setup. */
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
	bool used;	/* a tool or an offset had one of them */
};

/* Lengths in mm. The description's arena has the texts and sections; its arrays are owned by the library. */
struct tool_library {
	struct setup_description setup;	/* tools, length offsets and work offsets; everything else is empty */
	size_t tool_capacity, length_capacity, offset_capacity;
	size_t left_out;	/* tools of the library that were not taken over */
	bool counts_left_out;	/* without a warning for each */
	struct number_range *wanted;	/* only these numbers are added; NULL: all */
	size_t wanted_count;
};

/* All zero is empty. */
void tool_library_release(struct tool_library *tools);

/* Is a tool or an offset of this number to be added? */
bool tool_library_wants(struct tool_library *tools, long number);

/*
 * A tool as libraries describe it: heights above its tip, in outlines of its cutter, its shank and its holder that may
 * stand in each other. The gauge line is at `length`.
 */
struct tool_outline {
	long number;
	const char *name;	/* or NULL */
	enum tool_kind kind;
	enum tool_hand hand;
	double length;
	struct tool_profile cutter, shank, holder;
	bool has_tip;	/* the lowest part of the cutter has this shape, which the profile has as a cylinder */
	enum tool_tip tip;
	double corner, angle;	/* mm; radians */
	double flute_length;	/* mm; 0: not known */
	double diameter;	/* mm, of the cutter */
};

void tool_outline_release(struct tool_outline *outline);

/* Adds the tool. False, reported: its number is taken, or it has no length. */
bool tool_library_add(struct tool_library *tools, const struct tool_outline *outline, struct srcloc at,
		      struct diag *diag);

/*
 * Adds the values that the control has for H and D of a number. False, reported: the number is taken, or none that a
 * setup can have.
 */
bool tool_library_add_offset(struct tool_library *tools, const struct length_offset_description *offset,
			     struct srcloc at, struct diag *diag);

/* The work offset of this name, which is made if it is not there yet; valid until the next one is made. */
struct work_offset_description *tool_library_work_offset(struct tool_library *tools, const char *name);

#endif
