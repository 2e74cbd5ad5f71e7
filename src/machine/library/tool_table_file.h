/*
 * tool_table_file.h - reads the tool table of LinuxCNC, formerly EMC (tool.tbl): lines like "T1 P1 Z+85.2 D6 ;end
 * mill".
 */
#ifndef FIVECHECK_MACHINE_LIBRARY_TOOL_TABLE_FILE_H
#define FIVECHECK_MACHINE_LIBRARY_TOOL_TABLE_FILE_H

#include <stdbool.h>

#include "base/diag.h"
#include "machine/library/tool_library.h"

/* Does the text begin with such a line? */
bool tool_table_file_is(const char *text);

/*
 * Adds the length of each tool (Z) and half of its diameter (D) as offsets of its number: the table has no shapes of
 * tools. `unit` is mm per unit of length. Pockets (P) and values for lathes (I, J, Q) are not needed. An offset in
 * another axis than Z is an error: setups cannot have it. False: reported.
 */
bool tool_table_file_read(struct tool_library *tools, const char *text, const char *path, double unit,
			  struct diag *diag);

#endif
