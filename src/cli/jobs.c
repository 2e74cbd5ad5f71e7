#include "cli/jobs.h"

#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>

#include "base/arena.h"
#include "base/ascii.h"
#include "base/mem.h"
#include "base/path_sandbox.h"
#include "base/same_file.h"
#include "base/strbuf.h"
#include "cli/path_checks.h"
#include "cli/report_paths.h"
#include "cli/run.h"
#include "machine/job_list.h"

static const struct srcloc nowhere;

/* Options that belong to a job must be in its file. False: reported. */
static bool check_options(const struct options *options, struct diag *diag)
{
	if (options->setup || options->waivers)
		diag_error(diag, nowhere,
			   "--%s cannot be used with a job file, because it names the file for each job",
			   options->setup ? "setup" : "waivers");
	else if (options->shards)
		diag_error(diag, nowhere,
			   "--shard cannot be used with a job file: give its jobs to several computers instead");
	else
		return true;
	return false;
}

static bool check_name(const char *name, const char *option, struct diag *diag)
{
	if (!name || strchr(name, '%'))
		return true;
	diag_error(diag, nowhere,
		   "--%s: every job would overwrite %s; put %% (for the name of the job) into the file name",
		   option, name);
	return false;
}

/* A JUnit or SARIF file is one document: several on standard output could not be read. */
static bool check_documents(const struct options *options, struct diag *diag)
{
	const bool unnamed = !options->output;
	const bool junit = unnamed && options->formats[FORMAT_JUNIT].wanted && !options->formats[FORMAT_JUNIT].path;
	const bool sarif = unnamed && options->formats[FORMAT_SARIF].wanted && !options->formats[FORMAT_SARIF].path;
	const char *format = junit ? "junit" : "sarif";

	if (junit || sarif)
		diag_error(diag, nowhere,
			   "--format=%s: the documents of several jobs cannot share standard output; give a file with "
			   "%% for the name of the job, such as --format=%s=%%.%s",
			   format, format, format);
	return !junit && !sarif;
}

/* Several jobs must not write the same file. False: reported. */
static bool check_names(const struct options *options, struct diag *diag)
{
	struct options copy = *options;
	struct output_option outputs[OUTPUT_OPTIONS];
	bool good = true;

	options_list_outputs(&copy, outputs);
	for (int i = 0; i < OUTPUT_OPTIONS; i++)
		good = check_name(*outputs[i].path, outputs[i].option, diag) && good;
	return good;
}

/* False, reported: a file of the job is outside --input-root. */
static bool is_inside(const char *root, const char *kind, const char *path, struct srcloc at, struct diag *diag)
{
	if (!path || path_sandbox_holds(root, path))
		return true;
	diag_error(diag, at, "the %s %s is outside the input root %s, or a symbolic link leads outside", kind, path,
		   root);
	return false;
}

/* The job file is trusted, as it is named on the command line; the files that it names must be inside --input-root. */
static bool check_root(const struct options *options, const struct job_list *list, struct diag *diag)
{
	const char *root = options->check.read.input_root;
	bool good = path_checks_folders(options, diag);

	for (const struct job_item *job = list->items; good && root && job < list->items + list->count; job++) {
		const struct srcloc at = {.file = list->path, .line = job->line};

		good = is_inside(root, "machine file", job->machine, at, diag) &&
		       is_inside(root, "setup", job->setup, at, diag) &&
		       is_inside(root, "waivers file", job->waivers, at, diag);
		for (size_t i = 0; good && i < job->program_count; i++)
			good = is_inside(root, "program", job->programs[i], at, diag);
	}
	return good;
}

/* --stock-out writes one file for each job. False: reported. */
static bool check_stock_out(const struct options *options, const struct job_list *list, struct diag *diag)
{
	for (const struct job_item *job = list->items; options->stock_out && job < list->items + list->count; job++) {
		if (job->program_count < 2)
			continue;
		diag_error(diag, (struct srcloc){.file = list->path, .line = job->line},
			   "--stock-out takes one program for each job, because each begins with the blank of the "
			   "setup, but the job \"%s\" has %zu",
			   job->name, job->program_count);
		return false;
	}
	return true;
}

/* "op10-part" for the program part.nc of the job op10, which has several. */
static void add_file_name(struct strbuf *out, const struct job_item *job, size_t program)
{
	strbuf_addf(out, "%s", job->name);
	if (job->program_count < 2)
		return;
	strbuf_addf(out, "-");
	report_paths_add_stem(out, job->programs[program]);
}

/* Does a file of this job have the same name as one of another job, or as its index? */
static const struct job_item *find_same(const struct job_list *list, const struct job_item *job, size_t program)
{
	const struct job_item *found = NULL;
	struct strbuf name = {0}, other = {0};

	add_file_name(&name, job, program);
	for (const struct job_item *it = list->items; !found && it < list->items + list->count; it++) {
		if (it == job)
			continue;
		if (ascii_same(it->name, strbuf_text(&name)))
			found = it;
		for (size_t i = 0; !found && i < it->program_count; i++) {
			strbuf_clear(&other);
			add_file_name(&other, it, i);
			if (ascii_same(strbuf_text(&other), strbuf_text(&name)))
				found = it;
		}
	}
	strbuf_release(&name);
	strbuf_release(&other);
	return found;
}

/* Each job has its own reports of its programs, which must differ from those of other jobs. False: reported. */
static bool check_reports(const struct options *options, const struct job_list *list, struct diag *diag)
{
	for (size_t i = 0; options_want_visual(options) && i < list->count; i++) {
		const struct job_item *job = &list->items[i];

		for (size_t k = 0; job->program_count > 1 && k < job->program_count; k++) {
			const struct job_item *same = find_same(list, job, k);

			if (!same)
				continue;
			diag_error(diag, (struct srcloc){.file = list->path, .line = job->line},
				   "the report of %s in the job \"%s\" would have the same name as one of the job "
				   "\"%s\": rename one of them",
				   job->programs[k], job->name, same->name);
			return false;
		}
	}
	return true;
}

/* The name with each % replaced by the name of the job. */
static const char *name_for(struct arena *arena, const char *name, const char *job)
{
	struct strbuf text = {0};
	const char *kept;

	if (!name)
		return NULL;
	for (; *name; name++)
		strbuf_add(&text, *name == '%' ? job : name, *name == '%' ? strlen(job) : 1);
	kept = arena_strdup(arena, strbuf_text(&text));
	strbuf_release(&text);
	return kept;
}

/* Gives the output files in the options the name of the job. */
static void name_outputs(struct options *one, const struct job_item *job, struct arena *arena)
{
	struct output_option outputs[OUTPUT_OPTIONS];

	options_list_outputs(one, outputs);
	for (int i = 0; i < OUTPUT_OPTIONS; i++)
		*outputs[i].path = name_for(arena, *outputs[i].path, job->name);
}

/* The regular files that the jobs read, and the job file; missing files are left out. */
struct job_inputs {
	struct {
		const char *path;
		struct stat status;
	} *items;	/* owned */
	size_t count, capacity;
};

static void add_input(struct job_inputs *inputs, const char *path)
{
	struct stat status;

	if (!path || stat(path, &status) || !S_ISREG(status.st_mode))
		return;
	inputs->items = mem_grow(inputs->items, &inputs->capacity, inputs->count + 1, sizeof(*inputs->items));
	inputs->items[inputs->count].path = path;
	inputs->items[inputs->count++].status = status;
}

/* Is the file none of the inputs? False: reported. */
static bool is_no_input(const struct job_inputs *inputs, const struct output_option *output, struct diag *diag)
{
	struct stat status;

	if (!*output->path || stat(*output->path, &status))
		return true;
	for (size_t i = 0; i < inputs->count; i++) {
		if (!same_file(&inputs->items[i].status, &status))
			continue;
		diag_error(diag, nowhere, "--%s would overwrite %s", output->option, inputs->items[i].path);
		return false;
	}
	return true;
}

/* No output of a job may be a file of any job. False: reported. */
static bool check_inputs(const struct options *options, const struct job_list *list, struct diag *diag)
{
	struct job_inputs inputs = {0};
	bool good = true;

	add_input(&inputs, list->path);
	for (const struct job_item *job = list->items; job < list->items + list->count; job++) {
		add_input(&inputs, job->machine);
		add_input(&inputs, job->setup);
		add_input(&inputs, job->waivers);
		for (size_t i = 0; i < job->program_count; i++)
			add_input(&inputs, job->programs[i]);
	}
	for (const struct job_item *job = list->items; good && job < list->items + list->count; job++) {
		struct options one = *options;
		struct output_option outputs[OUTPUT_OPTIONS];
		struct arena arena = {0};

		name_outputs(&one, job, &arena);
		options_list_outputs(&one, outputs);
		for (int i = 0; good && i < OUTPUT_OPTIONS; i++)
			good = is_no_input(&inputs, &outputs[i], diag);
		arena_release(&arena);
	}
	free(inputs.items);
	return good;
}

/* The stocks that the jobs are to write with --stock-out; those of jobs that have written theirs are removed. */
struct stocks {
	struct unwritten_stock *items;	/* owned */
	size_t count;
};

static struct stocks stocks_of(const struct options *options, const struct job_list *list, struct arena *arena)
{
	struct stocks stocks = {.items = mem_zalloc(list->count + 1, sizeof(*stocks.items))};

	for (size_t i = 0; options->stock_out && i < list->count; i++)
		stocks.items[stocks.count++] = (struct unwritten_stock){
			name_for(arena, options->stock_out, list->items[i].name), list->items[i].name};
	return stocks;
}

/* Call it after the job; `before` has the status of its file before the job, if there was one. */
static void remove_written(struct stocks *stocks, const struct job_item *job, const struct stat *before)
{
	struct stat status;
	size_t i = 0;

	while (i < stocks->count && strcmp(stocks->items[i].job, job->name) != 0)
		i++;
	/* A file that is written is a new one, which takes the place of the old one. */
	if (i < stocks->count && !stat(stocks->items[i].path, &status) && !(before && same_file(before, &status)))
		stocks->items[i] = stocks->items[--stocks->count];
}

static enum run_status run_job(const struct options *options, const struct job_item *job, struct stocks *stocks,
			       struct stderr_ui *ui)
{
	struct options one = *options;
	struct arena arena = {0};
	enum run_status status;
	struct stat before;
	bool existed;

	name_outputs(&one, job, &arena);
	existed = one.stock_out && !stat(one.stock_out, &before);
	one.unwritten_stocks = stocks->items;
	one.unwritten_count = stocks->count;
	one.record = one.record ? one.formats[FORMAT_RECORD].path : NULL;
	one.job_file = options->machine;
	one.machine = job->machine;
	one.setup = job->setup;
	one.waivers = job->waivers;
	one.program_count = job->program_count;
	one.programs = arena_alloc(&arena, job->program_count * sizeof(*one.programs));
	for (size_t i = 0; i < job->program_count; i++)
		one.programs[i] = arena_strdup(&arena, job->programs[i]);
	status = run_options(&one, ui);
	remove_written(stocks, job, existed ? &before : NULL);
	arena_release(&arena);
	return status;
}

enum run_status jobs_run(const struct options *options, struct stderr_ui *ui)
{
	enum run_status status = RUN_CLEAR;
	struct arena arena = {0};
	struct stocks stocks;
	struct job_list list;
	bool good;

	if (!check_options(options, &ui->diag) || !job_list_load(&list, options->machine, &ui->diag))
		return RUN_INCOMPLETE;
	good = check_root(options, &list, &ui->diag) && check_stock_out(options, &list, &ui->diag) &&
	       (list.count == 1 || (check_names(options, &ui->diag) && check_documents(options, &ui->diag) &&
				    check_reports(options, &list, &ui->diag))) &&
	       check_inputs(options, &list, &ui->diag);
	stocks = stocks_of(options, &list, &arena);
	for (size_t i = 0; good && i < list.count; i++) {
		enum run_status one = run_job(options, &list.items[i], &stocks, ui);

		status = one > status ? one : status;
	}
	free(stocks.items);
	arena_release(&arena);
	job_list_release(&list);
	return good ? status : RUN_INCOMPLETE;
}
