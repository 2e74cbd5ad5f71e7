/* failure_report.h - writes the reports of a run that could not check any program because of an error in a file. */
#ifndef FIVECHECK_CLI_FAILURE_REPORT_H
#define FIVECHECK_CLI_FAILURE_REPORT_H

#include "base/diag.h"
#include "cli/error_list.h"
#include "cli/options.h"
#include "report/sink.h"

/* The file with the error. */
enum failure_place {
	FAILURE_OF_INPUT,	/* the machine file, the setup, or a file that they use */
	FAILURE_OF_OUTPUT	/* a file beside the results, such as that of --pose */
};

/*
 * Reports every program as incomplete and closes the sinks, so that a CI server does not read the reports of an earlier
 * run. A file is replaced only if it is empty or begins like a report of its format: if the machine file cannot be
 * read, its meshes are unknown, and must not be overwritten. A note names each file that is left unchanged. False,
 * reported: a report could not be written.
 */
bool failure_report_write(const struct options *options, enum failure_place place, const struct error_list *errors,
			  struct sinks *sinks, struct diag *diag);

#endif
