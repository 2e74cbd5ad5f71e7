/* tool_build.h - checks a described tool and makes its row of the tool table and its bodies. */
#ifndef FIVECHECK_MACHINE_TOOL_BUILD_H
#define FIVECHECK_MACHINE_TOOL_BUILD_H

#include <stddef.h>

#include "machine/description.h"
#include "machine/machine.h"
#include "machine/setup.h"

/* Bodies of one tool: holder, shank, cutter, and the neck above the cutter's flutes. */
#define TOOL_BODIES_MAX 4

/* The largest number of a tool or an H: controls have T and H words of eight digits. */
#define TOOL_NUMBER_MAX 99999999

/* The largest number of triangles of all tools of a setup together. */
#define TOOL_TRIANGLES_MAX ((size_t)10 * 1000 * 1000)

/* The tools of one setup are built one after another. */
struct tool_builder {
	struct description_file *file;
	const struct machine *machine;
	struct setup *setup;	/* receives the tool and its bodies; has room for them */
	struct diag *diag;	/* for warnings */
	size_t triangles;	/* so far */
};

/* Appends the tool, and its holder, shank and cutter if it has them. Faults are counted in the file. */
void tool_build(struct tool_builder *builder, const struct tool_description *described);

#endif
