/* import_jobs.h - imports a project: a machine, its setups, and the job file that connects them with programs. */
#ifndef FIVECHECK_CLI_IMPORT_IMPORT_JOBS_H
#define FIVECHECK_CLI_IMPORT_IMPORT_JOBS_H

#include "import/import_project.h"
#include "machine/library/library_file.h"

/* Are the names of setup files and of the job file new in the folder? False: reported. */
bool import_jobs_are_new(const struct import_project *project, const char *folder, struct diag *diag);

/*
 * Writes the setups with the tools of their libraries, and jobs.xml, beside the existing machine file, and loads each
 * of them. False: reported.
 */
bool import_jobs_write(const struct import_project *project, const char *folder, const char *source,
		       const struct library_options *options, struct diag *diag);

#endif
