/* failure_report.h - the reports of a run whose machine, setup or other file is at fault, so that no program was checked. */
#ifndef FIVECHECK_CLI_FAILURE_REPORT_H
#define FIVECHECK_CLI_FAILURE_REPORT_H

#include "base/diag.h"
#include "cli/error_list.h"
#include "cli/options.h"
#include "report/sink.h"

/*
 * Writes them, every program incomplete, and closes the channels: a CI server must not take the reports of an earlier
 * run for this one's. A file that is there and is no such report stays, with a note: a machine that
 * cannot be read does not tell its meshes, which must not be overwritten. False: not all could be written, reported.
 */
bool failure_report_write(const struct options *options, const struct error_list *errors, struct sinks *sinks,
		   struct diag *diag);

#endif
