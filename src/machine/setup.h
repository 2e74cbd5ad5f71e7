/* setup.h - everything that is set up on a machine for one job: work offsets, fixtures, the part, tools. */
#ifndef FIVECHECK_MACHINE_SETUP_H
#define FIVECHECK_MACHINE_SETUP_H

#include <stdbool.h>
#include <stddef.h>

#include "base/arena.h"
#include "base/axes.h"
#include "base/diag.h"
#include "control/offset_tables.h"
#include "machine/body.h"

struct machine;

struct setup {
	struct arena arena;
	const char *path;
	struct work_offset *offsets;
	size_t offset_count;
	struct tool *tools;
	size_t tool_count;
	struct tool_edge *edges;
	size_t edge_count;
	struct length_offset *lengths;	/* every H that a tool or an <offset> defines, each once */
	size_t length_count;
	struct radius_offset *radii;	/* every D that an <offset> defines, each once */
	size_t radius_count;
	/* fixtures, parts and the stock in file order, then each tool's holder, shank, cutter */
	struct body *bodies;
	size_t body_count;
	/* The variables of the controller and of the setup; NULL: there are none. */
	struct control_variable *variables;
	size_t variable_count;
	const char **libraries;	/* the files that <tools> names, as they can be opened */
	size_t library_count;
	int initial_tool;	/* 0: the spindle is empty */
};

/* As machine_load. The bodies are placed on the machine's workholding and spindle. */
struct setup *setup_load(const char *path, const struct machine *machine, struct diag *diag);

/* As machine_load_within. */
struct setup *setup_load_within(const char *path, const struct machine *machine, const char *root, struct diag *diag);
void setup_free(struct setup *setup);

const struct tool *setup_tool(const struct setup *setup, int number);

#endif
