/*
 * program_reports.h - the reports with pictures of a run (--report, --glb, --picture): one file for each program, and
 * an index page for several programs.
 */
#ifndef FIVECHECK_CLI_PROGRAM_REPORTS_H
#define FIVECHECK_CLI_PROGRAM_REPORTS_H

#include <stdbool.h>
#include <stddef.h>

#include "base/diag.h"
#include "base/strbuf.h"
#include "cli/options.h"
#include "report/html/recorder.h"
#include "report/html/scene_pack.h"
#include "report/report.h"

/* The row of a program in the index. Owned; NULL: not known yet. */
struct reported_program {
	/* for its files: the part of the program's name that is allowed in a file name; "" for a single program */
	char *name;
	char *sentence;
	const char *word;
	bool written;	/* it has a report */
};

struct program_reports {
	const struct options *options;
	struct scene *scene;
	struct scene_pack pack;
	struct report_file *files;	/* known before the check; their texts are borrowed */
	size_t file_count;
	size_t stock_bytes;	/* reserved for the stock in a report; 0: there is none */
	struct reported_program *programs;
};

/*
 * Tests whether the files can be written. For several programs the meshes are packed now, for one program later. False:
 * reported.
 */
bool program_reports_init(struct program_reports *reports, const struct options *options, struct scene *scene,
			  const struct report_file *files, size_t file_count, struct diag *diag);
void program_reports_release(struct program_reports *reports);

/* The largest number of triangles for the remaining stock; 0: there is no stock. */
size_t program_reports_stock_triangles(const struct program_reports *reports);

/*
 * Writes the files of the program with this index. Different threads may write those of different programs. False:
 * reported.
 */
bool program_reports_write(struct program_reports *reports, size_t index, struct recorder *recorder,
			   const struct report_run *run, const struct report_program *program, struct diag *diag);

/* Writes the index page if there are several programs. False: reported. */
bool program_reports_finish(struct program_reports *reports, struct diag *diag);

#endif
