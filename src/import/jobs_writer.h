/* jobs_writer.h - writes the setups of a project as a job file. */
#ifndef FIVECHECK_IMPORT_JOBS_WRITER_H
#define FIVECHECK_IMPORT_JOBS_WRITER_H

#include "base/strbuf.h"
#include "import/import_project.h"

/* The name of a setup's file, for messages and in the job file. */
void jobs_writer_setup_name(struct strbuf *out, const struct import_project *project, size_t setup);

/* Appends a job file with every setup that has programs. False: no setup has programs, and nothing was appended. */
bool jobs_writer_xml(struct strbuf *out, const struct import_project *project, const char *origin);

#endif
