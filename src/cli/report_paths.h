/* report_paths.h - the names of the files that --report, --glb and --picture write, and what they may replace. */
#ifndef FIVECHECK_CLI_REPORT_PATHS_H
#define FIVECHECK_CLI_REPORT_PATHS_H

#include <stdbool.h>

#include "base/diag.h"
#include "base/strbuf.h"

/* The part of a program's name that is allowed in the names of its files: "parts/a b.nc" becomes "a_b". */
void report_paths_add_stem(struct strbuf *out, const char *program);

/* The file of one of several programs: "out.html" becomes "out-NAME.html". An empty name leaves the path as it is. */
void report_paths_add(struct strbuf *out, const char *path, const char *name);

/*
 * False, reported: the file cannot be written, such as in a folder that does not exist. This is said before the check,
 * not after hours. The file is not changed. Pipes and devices are not tested. A path NULL is no file.
 */
bool report_paths_can_write(const char *path, struct diag *diag);

/* False, reported: the file exists and is not a report, picture or scene; only these may be replaced. */
bool report_paths_may_replace(const char *option, const char *path, struct diag *diag);

#endif
