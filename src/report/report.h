/* report.h - the data that a run reports about its findings and programs, and the interface of an output format. */
#ifndef FIVECHECK_REPORT_REPORT_H
#define FIVECHECK_REPORT_REPORT_H

#include <stdbool.h>
#include <stddef.h>

#include "base/strbuf.h"
#include "check/check.h"
#include "check/finding.h"
#include "check/measure/sensitivity.h"
#include "report/format/digest.h"
#include "report/tables/stats.h"
#include "report/verdict.h"
#include "report/waiver_match.h"
#include "scene/scene.h"

/* The effect of a finding on the exit status. */
enum finding_status {
	FINDING_FAILS,	/* the run fails */
	FINDING_WAIVED,	/* accepted by a waiver */
	FINDING_LEFT_OUT	/* its kind is not in --fail-on */
};

/* How a finding is printed. */
struct finding_style {
	enum finding_status status;
	bool colour;
	const struct waiver *waiver;	/* that accepts the finding; borrowed; or NULL */
};

/* A file that was read. All pointers are borrowed. */
struct report_file {
	const char *kind, *path;
	char digest[DIGEST_SIZE];	/* SHA-256; "": not computed */
};

/* What a run checks, and how. All pointers are borrowed. */
struct report_run {
	struct scene *scene;	/* borrowed */
	const struct check_options *options;
	double clearance;	/* mm: for pairs without a clearance in the machine file */
	size_t programs;
	unsigned fail_on;	/* a bit for each kind of finding that fails the run; 0: all do */
	bool fail_on_warnings;	/* warnings fail the run, too */
	bool quiet;	/* print no statistics */
	bool stats;	/* print all statistics */
	const struct waiver_match *waiving;
	int shard, shards;	/* K and N of --shard; 0: not given */
	const char *program_list; /* SHA-256 of the names of all programs before --shard; "": no such shard */
	const struct report_file *files;	/* the files read before the programs, and these; only in begin() */
	size_t file_count;
};

/* So many errors of a program are reported. */
enum { REPORT_ERRORS_MAX = 10 };

/* An error that made a check incomplete. */
struct report_error {
	char *file;	/* NULL: the error concerns no file */
	long line;	/* 0: unknown, likewise the column */
	int column;
	char *text;
	char *excerpt;	/* the line that the error is about; NULL: unknown */
	long block;	/* counted from 1 in the order of execution; 0: not in a block */
};

/* A program that was checked. All pointers are borrowed. */
struct report_program {
	const char *name;
	const struct verdict *verdict;	/* NULL: the program was not read */
	const char *unread;	/* the reason for that */
	const double *proven;	/* as check_run fills it; NULL: not requested */
	const struct report_error *errors;	/* the first errors */
	size_t error_count;
	const struct sensitivity *sensitivity;	/* results of --sensitivity */
	size_t sensitivity_count;	/* 0: not requested, or unknown */
	const char *waived;	/* waived findings and the reasons, one per line */
	const char *failing_warning;	/* a warning that fails the run (--fail-on=warning); NULL: there is none */
	int first_kind;	/* enum finding_kind of the first finding that fails the run; -1: there is none */
	const char *first_text;	/* its message with its place, in the GNU form; NULL: there is none */
};

struct report_end {
	const struct run_stats *sums;
	int status;	/* the exit status */
	const struct report_file *files;
	size_t file_count;
	size_t left_out;	/* items that were dropped because of the writer's limit */
};

/*
 * An output format. Each function appends to `out`. Normally the text of a finding is written at once. With `whole` it
 * stays in `out` until the program is finished, and then program() replaces it with the text of the whole program.
 */
struct report_writer {
	const char *name;	/* its name for --format */
	const char *mark;	/* the beginning of all its files, and of no input files; NULL: there is no such text */
	bool whole;
	bool collects;	/* end() receives all items and writes them */
	const char *separator;	/* between items, each of which is a line; NULL: none */
	size_t limit;	/* number of items that are written; 0: no limit */
	const char *free; /* items with this beginning have a separate limit, of the same size; NULL: there are none */
	void (*begin)(struct strbuf *out, const struct report_run *run);
	void (*finding)(struct strbuf *out, const struct report_run *run, const struct finding *finding,
			struct finding_style style);
	void (*program)(struct strbuf *out, const struct report_run *run, const struct report_program *program);
	void (*end)(struct strbuf *out, const struct report_run *run, const struct report_end *end,
		    const struct strbuf *items);
};

#endif
