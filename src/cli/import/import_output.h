/* import_output.h - writes an imported machine into a folder. */
#ifndef FIVECHECK_CLI_IMPORT_IMPORT_OUTPUT_H
#define FIVECHECK_CLI_IMPORT_IMPORT_OUTPUT_H

#include <stdbool.h>

#include "base/diag.h"
#include "import/import_project.h"
#include "machine/library/tool_library.h"

/* Is the file new? False, reported: it exists already, and may have been edited. */
bool import_output_is_new(const char *path, struct diag *diag);

/* Makes the folder and writes the meshes and, last, machine.xml. `source`: the file that was read. False: reported. */
bool import_output_write(const struct import_machine *machine, const char *folder, const char *source,
			 struct diag *diag);

/* Only the folder and the meshes. */
bool import_output_write_meshes(const struct import_machine *machine, const char *folder, struct diag *diag);

/* The same for setup.xml. */
bool import_output_write_tools(const struct tool_library *tools, const char *folder, const char *source,
			       struct diag *diag);

/* Writes the setup file of a project, with its meshes; the folder exists. `tools`: those of its library. */
bool import_output_write_setup(const struct import_project *project, size_t setup, const struct tool_library *tools,
			       const char *folder, const char *source, struct diag *diag);

/* Writes the job file, if the project has programs; the folder exists. */
bool import_output_write_jobs(const struct import_project *project, const char *folder, const char *source,
			      struct diag *diag);

#endif
