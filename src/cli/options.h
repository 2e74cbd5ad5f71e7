/* options.h - the options of the command line. */
#ifndef FIVECHECK_CLI_OPTIONS_H
#define FIVECHECK_CLI_OPTIONS_H

#include <stdbool.h>
#include <stddef.h>

#include "check/check.h"
#include "check/measure/sensitivity.h"
#include "machine/machine.h"
#include "report/writers/writers.h"

/* The choices of --fail-on besides the kinds of findings: indices of its choices, bits of `fail_on`. */
enum { FAIL_ON_WARNING = FINDING_KINDS, FAIL_ON_NONE };

enum run_mode {
	RUN_CHECK,
	RUN_PARSE_ONLY,
	RUN_DUMP_PATH,
	RUN_LIST_PAIRS,
	RUN_DEPENDS,
	RUN_CHECK_MACHINE,
	RUN_EXPLAIN,
	RUN_HELP,
	RUN_VERSION
};

/* Whether a report contains the text of the program. */
enum report_code { REPORT_CODE_FULL, REPORT_CODE_NONE };

/* The texts are borrowed from argv; the array is owned. */
struct text_list {
	const char **items;
	size_t count, capacity;
};

/* One element of an array that is indexed by enum report_format: an argument of --format. */
struct format_choice {
	bool wanted;
	const char *path;	/* NULL: the file of --output, or standard output */
};

/* The file of --stock-out of a job that is still to be run, or that did not write it. */
struct unwritten_stock {
	const char *path, *job;
};

/* Strings are borrowed from argv. */
struct options {
	enum run_mode mode;
	const char *machine;
	const char *job_file;	/* the job file of this job, or NULL */
	bool jobs;	/* `machine` is a job file */
	const char *setup;	/* NULL: the one inside the machine file, if any */
	char **programs;	/* "-" is standard input, at most once; owned array */
	size_t program_count;
	const char *files_from;	/* a list of more programs; "-" is standard input; or NULL */
	char *list;	/* the text of that file, divided into names; owned */
	int shard, shards;	/* K and N of --shard; 0: not given */
	char program_list[DIGEST_SIZE];	/* see struct report_run */
	struct check_options check;
	double clearance;	/* mm */
	struct format_choice formats[FORMAT_COUNT];
	struct text_list includes;	/* folders; `check` refers to them */
	const char *output;	/* NULL: standard output */
	bool output_of_format;	/* given as the file of --format, for a table */
	const char *explain;	/* the word of --explain, or NULL */
	const char *pose;	/* or NULL */
	const char *stock_out;	/* or NULL */
	const struct unwritten_stock *unwritten_stocks;	/* of other jobs of the same run */
	size_t unwritten_count;
	const char *report;	/* or NULL */
	const char *glb;	/* or NULL */
	const char *picture;	/* or NULL; ends in .svg or .png */
	double report_size;	/* MB */
	int report_code;	/* enum report_code */
	const char *depfile;	/* or NULL */
	const char *record;	/* or NULL; also the path of formats[FORMAT_RECORD] */
	const char *clearance_report, *timing;	/* or NULL */
	double sensitivity[CHANGES];	/* mm: the ranges of --sensitivity; all 0: not given */
	const char *waivers;	/* or NULL */
	unsigned fail_on;	/* as in struct report_run; FAIL_ON_NONE alone: no kind fails */
	bool fail_on_warnings;	/* warnings fail the run, too */
	bool stats;	/* print all statistics */
	int color;	/* enum color_choice */
	bool quiet, verbose;
	int progress;	/* enum progress_kind */
	int dialect;	/* index of dialect_choice_names; -1: that of the machine file */
	int duplicates;	/* 1: if a word stands twice in a block, the last one counts */
};

/* An option that names an output file. */
struct output_option {
	const char *option;
	const char **path;	/* the member with the file name; *path is NULL if the option was not given */
};

enum { OUTPUT_OPTIONS = FORMAT_COUNT + 9 };

/* Fills the list with all output files: a check writes no others. The paths are those of *options. */
void options_list_outputs(struct options *options, struct output_option list[OUTPUT_OPTIONS]);

/* Was --sensitivity given with any amount above 0? */
bool options_want_sensitivity(const struct options *options);

/* Does a report contain the digests of the input files? */
bool options_want_digests(const struct options *options);

/* Will a report or a picture be drawn? */
bool options_want_visual(const struct options *options);

void options_release(struct options *options);

#endif
