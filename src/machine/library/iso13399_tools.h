/*
 * iso13399_tools.h - reads a tool of a maker's catalogue as ISO 13399 describes it: a STEP file (.p21) of the schema
 * CUTTING_TOOL_SCHEMA_ARM; a GTC package has one for each product.
 *
 * Its values are NUMERICAL_VALUE entities. Makers name them by the symbol of the property (DC) or by its name in the
 * dictionary (cutting diameter). The file has no shape; so a tool is accepted only if each of its lengths and angles is
 * either a known one of a mill or a drill, or does not matter.
 */
#ifndef FIVECHECK_MACHINE_LIBRARY_ISO13399_TOOLS_H
#define FIVECHECK_MACHINE_LIBRARY_ISO13399_TOOLS_H

#include <stdbool.h>

#include "machine/library/tool_library.h"

/* Is the text a STEP file of this schema? */
bool iso13399_tools_is(const char *text);

/*
 * The tool gets the next number (catalog_tool.h). A holder, an insert, or a tool with unknown values is left out with a
 * warning. False, reported: the file is faulty.
 */
bool iso13399_tools_read(struct tool_library *tools, const char *text, const char *path, struct diag *diag);

#endif
