#include "cli/programs.h"

#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <time.h>

#include "base/mem.h"
#include "base/parallel_for.h"
#include "base/spare_threads.h"
#include "cli/failure_report.h"
#include "cli/interrupt.h"
#include "cli/path_checks.h"
#include "cli/program.h"
#include "cli/program_queue.h"
#include "cli/report_paths.h"
#include "report/pose.h"
#include "report/stock_file.h"

/* The common data of the threads. */
struct session {
	struct stock_remainder remainder;	/* with --stock-out */
	const struct options *options;
	struct program_context context;
	struct program_queue queue;
	struct spare_threads spare;	/* threads without a program help with the others */
	struct ordered_output order;
	struct program_outcome *outcomes;	/* one for each program */
};

static void check_program(struct session *session, size_t i)
{
	struct program_output *output = &session->order.programs[i];

	/* After a failed write the result could not be printed. */
	session->outcomes[i].status = RUN_INCOMPLETE;
	if (!ordered_output_is_lost(&session->order))
		program_check(&session->context, session->options->programs[i], output, &session->outcomes[i]);
	program_output_end(output);
}

/* Run by one thread, or by the few that check one program together, until no program is left. */
static void check_programs(void *context, int worker, size_t round)
{
	struct session *session = context;
	size_t program;

	(void)worker;
	(void)round;
	while (program_queue_take(&session->queue, &program))
		check_program(session, program);
	spare_threads_give(&session->spare, session->context.check.threads);
}

static void tell_end(const struct session *session, double seconds, const struct input_files *inputs,
		     enum run_status status)
{
	struct run_stats sums = {.seconds_load = seconds};
	struct timespec processor;
	struct report_end end = {.sums = &sums, .status = (int)status,
				 .files = inputs->items, .file_count = inputs->count};

	if (!clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &processor))
		sums.seconds_processor = (double)processor.tv_sec + 1e-9 * (double)processor.tv_nsec;
	sums.seconds_wall = seconds + stderr_ui_seconds() - session->order.ui->started;
	for (size_t i = 0; i < session->options->program_count; i++) {
		const struct program_outcome *outcome = &session->outcomes[i];

		stats_sum(&sums, &outcome->stats, outcome->status == RUN_FOUND ? CHECK_FOUND : outcome->result,
			  outcome->accepted && outcome->status == RUN_CLEAR);
		sums.waived += outcome->waived;
	}
	sinks_end(session->order.sinks, &session->context.run, &end);
}

/* Can the files beside the results be written? Errors go to the tee. */
static bool prepare_files(const struct programs_run *run, struct session *session, struct program_reports *reports)
{
	const struct options *options = run->options;
	struct diag *diag = &run->tee->diag;

	if (!report_paths_can_write(options->pose, diag) || !report_paths_can_write(options->stock_out, diag))
		return false;
	if (!options_want_visual(options))
		return true;
	if (!program_reports_init(reports, options, session->context.scene, run->inputs->items, run->inputs->count,
				  diag))
		return false;
	session->context.reports = reports;
	return true;
}

/* --pose: the first finding of the first program that has one. False: reported. */
static bool write_pose(const struct session *session)
{
	const struct options *options = session->options;
	struct diag *diag = &session->order.ui->diag;

	for (size_t i = 0; i < options->program_count; i++) {
		const struct program_outcome *outcome = &session->outcomes[i];

		if (outcome->has_first)
			return pose_write(options->pose, session->context.scene, &outcome->first_axes,
					  outcome->first_tool, diag);
	}
	diag_note(diag, (struct srcloc){0}, "nothing was found, so %s was not written", options->pose);
	return true;
}

static bool is_named(const struct options *options, const char *program)
{
	for (size_t i = 0; i < options->program_count; i++) {
		if (!strcmp(options->programs[i], program))
			return true;
	}
	return false;
}

/* The names of programs may be spelled differently. With --shard they may belong to other shards. */
static void tell_strange_waivers(const struct session *session, const struct waivers *file)
{
	size_t count = 0;

	for (size_t i = 0; file && !session->options->shards && i < file->count; i++)
		count += !is_named(session->options, file->items[i].program);
	if (count)
		diag_note(&session->order.ui->diag, (struct srcloc){file->path, 0, 0},
			  "%zu of %zu waivers %s programs that were not checked in this run (program=\"\" must be the "
			  "name as on the command line)", count, file->count,
			  count == 1 ? "names" : "name");
}

/* --stock-out. False: reported. */
static bool write_stock(const struct session *session)
{
	return stock_file_write(session->options->stock_out, &session->remainder, &session->order.ui->diag);
}

/* The greatest status of the programs, of --pose, of --stock-out, and of errors without a program. */
static enum run_status status_of(const struct session *session)
{
	enum run_status status = RUN_CLEAR;

	for (size_t i = 0; i < session->options->program_count; i++) {
		if (session->outcomes[i].status > status)
			status = session->outcomes[i].status;
	}
	if (session->options->pose && session->order.sinks->count && !write_pose(session) && status < RUN_INCOMPLETE)
		status = RUN_INCOMPLETE;
	if (session->options->stock_out && session->order.sinks->count && !write_stock(session) &&
	    status < RUN_INCOMPLETE)
		status = RUN_INCOMPLETE;
	if (session->order.ui->diag.errors && status < RUN_INCOMPLETE)
		status = RUN_INCOMPLETE;
	return status;
}

static bool is_pressed(void *context)
{
	(void)context;
	return interrupt_presses();
}

/* The number of programs that are checked at the same time. */
static int programs_at_once(const struct programs_run *run)
{
	const struct options *options = run->options;

	/* Buffered rows of other programs would need much memory, and the times would be mixed up. */
	if (run->tables || !options->program_count)
		return 1;
	return options->program_count < (size_t)options->check.threads ? (int)options->program_count
								       : options->check.threads;
}

/* The common data of the programs, with the number of threads for each of them. */
static struct program_context context_of(const struct programs_run *run, int threads)
{
	static const struct cancel cancel = {NULL, is_pressed};
	const struct options *options = run->options;
	struct scene *scene = model_scene(run->model);
	struct program_context context = {
		.options = options, .check = options->check, .model = run->model, .scene = scene, .sinks = run->sinks,
		.tables = run->tables,
		.run = {
			.scene = scene,
			.options = &options->check,
			.clearance = options->clearance,
			.programs = options->program_count,
			.fail_on = options->fail_on,
			.fail_on_warnings = options->fail_on_warnings,
			.quiet = options->quiet,
			.stats = options->stats,
			.waiving = run->waiving,
			.shard = options->shard,
			.shards = options->shards,
			.program_list = options->program_list,
			.files = run->inputs->items,
			.file_count = run->inputs->count,
		},
	};

	context.check.read.opened = &run->inputs->opened;
	context.check.read.cancel = &cancel;
	/* The check must continue after an accepted finding. */
	context.check.all = options->check.all || options->waivers || options->fail_on;
	context.check.threads = options->check.threads / threads;
	return context;
}

static void check_all(struct session *session, int threads)
{
	const struct options *options = session->options;
	double *sizes = mem_zalloc(options->program_count + 1, sizeof(*sizes));
	struct stat status;

	for (size_t i = 0; i < options->program_count && threads > 1; i++)
		if (!stat(options->programs[i], &status) && S_ISREG(status.st_mode))
			sizes[i] = (double)status.st_size;
	program_queue_init(&session->queue, sizes, options->program_count, threads);
	free(sizes);
	session->context.check.spare = &session->spare;
	spare_threads_give(&session->spare, options->check.threads - threads * session->context.check.threads);
	parallel_for((size_t)threads, threads, check_programs, session);
	program_queue_release(&session->queue);
}

/* Writes everything that follows the last program. */
static enum run_status finish(struct session *session, const struct programs_run *run)
{
	struct diag *diag = &run->ui->diag;
	struct input_files *inputs = run->inputs;
	enum run_status status;

	stderr_ui_finish(run->ui);
	tell_strange_waivers(session, run->waiving->file);
	input_files_sort(inputs);
	if (!path_checks_inputs(run->options, inputs, diag))
		sinks_discard(run->sinks);
	if (options_want_digests(run->options)) {
		input_files_digest(inputs);
		input_files_verify(inputs, run->options->record, diag);
	}
	if (session->context.reports && run->sinks->count)
		program_reports_finish(session->context.reports, diag);
	status = status_of(session);
	tell_end(session, run->seconds, inputs, status);
	return status;
}

enum run_status programs_check(const struct programs_run *run)
{
	const struct options *options = run->options;
	int threads = programs_at_once(run);
	struct session session = {.options = options, .context = context_of(run, threads)};
	struct program_reports reports = {0};
	enum run_status status;

	if (!prepare_files(run, &session, &reports)) {
		failure_report_write(options, FAILURE_OF_OUTPUT, &run->tee->errors, run->sinks, &run->ui->diag);
		return RUN_INCOMPLETE;
	}
	if (options->stock_out)
		session.context.check.remainder = &session.remainder;
	session.outcomes = mem_zalloc(options->program_count + 1, sizeof(*session.outcomes));
	ordered_output_init(&session.order, options->program_count, run->ui, run->sinks);
	stderr_ui_expect(run->ui, options->program_count);
	sinks_begin(run->sinks, &session.context.run);
	interrupt_watch();
	check_all(&session, threads);
	status = finish(&session, run);
	ordered_output_release(&session.order);
	free(session.outcomes);
	program_reports_release(&reports);
	mesh_release(&session.remainder.mesh);
	return status;
}
