/* import_tools.h - tools of another program's library, before they are written as a setup. */
#ifndef FIVECHECK_IMPORT_IMPORT_TOOLS_H
#define FIVECHECK_IMPORT_IMPORT_TOOLS_H

#include <stdbool.h>
#include <stddef.h>

#include "base/diag.h"
#include "base/strbuf.h"
#include "import/import.h"
#include "import/tool_profile.h"
#include "machine/description.h"

/* A tool library; lengths in mm. The description's arena has the texts and sections. */
struct import_tools {
	struct setup_description setup;
	size_t tool_capacity;
	size_t left_out;	/* tools of the library that were not taken over */
};

/* All zero is empty. */
void import_tools_release(struct import_tools *tools);

/*
 * A tool as libraries describe it: heights above its tip, in outlines of its cutter, its shank and its holder that may
 * stand in each other. The gauge line is at `length`.
 */
struct tool_outline {
	long number;
	const char *name;	/* or NULL */
	enum tool_kind kind;
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
bool import_tools_add(struct import_tools *tools, const struct tool_outline *outline, struct srcloc at,
		      struct diag *diag);

/* Appends a setup file. `origin` says in a comment what it was made from. */
void import_tools_write(struct strbuf *out, const struct import_tools *tools, const char *origin);

#endif
