/* tool_table_file.h - reads the tool table of LinuxCNC, once EMC (tool.tbl): lines like "T1 P1 Z+85.2 D6 ;end mill". */
#ifndef FIVECHECK_MACHINE_LIBRARY_TOOL_TABLE_FILE_H
#define FIVECHECK_MACHINE_LIBRARY_TOOL_TABLE_FILE_H

#include <stdbool.h>

#include "base/diag.h"
#include "machine/library/tool_library.h"

/* Does the text begin with such a line? */
bool tool_table_file_is(const char *text);

/*
 * Adds the length of each tool (Z) and half of its diameter (D) as offsets of its number: the table tells the shape of
 * no tool. `unit` is mm per unit of length. Pockets (P) and what only lathes use (I, J, Q) are not needed. An offset in
 * another axis than Z is an error: no setup has it. False: reported.
 */
bool tool_table_file_read(struct tool_library *tools, const char *text, const char *path, double unit,
			  struct diag *diag);

#endif
