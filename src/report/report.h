/* report.h - what a run tells about its findings and programs, and the interface of an output format. */
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

/* What a finding weighs. */
enum finding_status {
	FINDING_FAILS,
	FINDING_KNOWN,	/* in the baseline */
	FINDING_WAIVED,	/* by a waiver */
	FINDING_LEFT_OUT	/* of a kind that --fail-on does not name */
};

/* How it looks. */
struct finding_style {
	enum finding_status status;
	bool colour;
	const struct waiver *waiver;	/* of what is waived; borrowed */
};

/* What a run is about. Borrows everything. */
struct report_run {
	const struct scene *scene;
	const struct check_options *options;
	double clearance;	/* mm: of pairs to which the machine file gives none */
	size_t programs;
	unsigned fail_on;	/* a bit for each kind of finding that fails; 0: all */
	bool exit_zero;
	bool quiet;	/* no statistics */
	const struct waiver_match *waiving;
	int shard, shards;	/* of the programs, or of the blocks of one; 0: all */
};

/* What made a check incomplete. */
struct report_error {
	char *file;	/* NULL: no file is to blame */
	long line;	/* 0: not known, likewise the column */
	int column;
	char *text;
};

/* One program at its end. Borrows everything. */
struct report_program {
	const char *name;
	const struct verdict *verdict;	/* NULL: it was not read */
	const char *unread;	/* why not */
	const double *proven;	/* check_run's; NULL: not asked for */
	const struct report_error *errors;	/* the first of them */
	size_t error_count;
	const struct sensitivity *sensitivity;	/* how long the verdict holds */
	size_t sensitivity_count;	/* 0: not asked for, or not known */
	const char *waived;	/* what was waived and why, a line each */
	int first_kind;	/* enum finding_kind of the first finding that fails the run; -1: there is none */
	const char *first_text;	/* its message with its place, in the GNU form; NULL: there is none */
};

/* A file that was read. Borrows everything. */
struct report_file {
	const char *kind, *path;
	char digest[DIGEST_SIZE];	/* SHA-256; "": not asked for */
};

struct report_end {
	const struct run_stats *sums;
	int status;	/* the exit status */
	const struct report_file *files;
	size_t file_count;
	size_t left_out;	/* items beyond the writer's limit */
};

/*
 * Each function appends to `out`. A finding's and a program's text is what the
 * format says at once, except where `whole`: then what the findings of a
 * program appended stays in `out`, and the program's function turns it into its own.
 */
struct report_writer {
	const char *name;	/* as --format calls it */
	const char *mark;	/* what all files that it writes begin with, and no input does; NULL: nothing */
	bool whole;
	bool collects;	/* nothing is written before the end, which receives all items */
	const char *separator;	/* between items, which are lines; NULL: none */
	size_t limit;	/* of items; 0: none */
	void (*begin)(struct strbuf *out, const struct report_run *run);
	void (*finding)(struct strbuf *out, const struct report_run *run, const struct finding *finding,
			struct finding_style style);
	void (*program)(struct strbuf *out, const struct report_run *run, const struct report_program *program);
	void (*end)(struct strbuf *out, const struct report_run *run, const struct report_end *end,
		    const struct strbuf *items);
};

#endif
