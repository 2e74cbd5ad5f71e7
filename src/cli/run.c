#include "cli/run.h"

#include <unistd.h>

#include "cli/files.h"
#include "cli/inputs.h"
#include "cli/program.h"
#include "cli/programs.h"
#include "machine/machine.h"
#include "machine/setup.h"
#include "report/dump.h"
#include "report/oddities.h"
#include "report/pairs.h"
#include "report/tree.h"
#include "scene/scene.h"

static const struct srcloc nowhere;

static enum run_status worst(enum run_status a, enum run_status b)
{
	return a > b ? a : b;
}

/* --help and --version */
static enum run_status print_text(struct strbuf *text, struct diag *diag)
{
	struct output out;
	bool good = output_open(&out, NULL, diag);

	output_text(&out, text);
	good = output_commit(&out, diag) && good;
	strbuf_release(text);
	return good ? RUN_CLEAR : RUN_INCOMPLETE;
}

/* What a run works with; all zero is nothing. */
struct job {
	struct machine *machine;
	const struct setup *setup;	/* the machine's own, or the next */
	struct setup *loaded;
	struct scene *scene;
	double seconds;	/* that it took to load */
};

static void job_release(struct job *job)
{
	scene_free(job->scene);
	setup_free(job->loaded);
	machine_free(job->machine);
}

static bool load_setup(struct job *job, const struct options *options, struct diag *diag)
{
	job->setup = job->machine->setup;
	if (!options->setup)
		return true;
	if (job->setup)
		diag_note(diag, nowhere, "the setup %s is used, not the one inside %s", options->setup,
			  options->machine);
	job->loaded = setup_load(options->setup, job->machine, diag);
	job->setup = job->loaded;
	return job->loaded != NULL;
}

static bool needs_scene(enum run_mode mode)
{
	return mode == RUN_CHECK || mode == RUN_LIST_PAIRS || mode == RUN_CHECK_MACHINE;
}

static bool job_load(struct job *job, const struct options *options, struct diag *diag)
{
	double start = console_seconds();

	*job = (struct job){0};
	job->machine = machine_load(options->machine, diag);
	if (!job->machine || !load_setup(job, options, diag) ||
	    !machine_check_rules(job->machine, job->setup, diag))
		return false;
	if (!files_confined(options, job->machine, job->setup, diag))
		return false;
	if (options->dialect >= 0)
		job->machine->controller.dialect = (enum dialect)options->dialect;
	if (needs_scene(options->mode)) {
		job->scene = scene_new(job->machine, job->setup, options->clearance, diag);
		if (!job->scene || (options->mode == RUN_CHECK && !scene_build(job->scene, diag)))
			return false;
	}
	job->seconds = console_seconds() - start;
	return diag->errors == 0;
}

/* False: reported. */
static bool open_channels(struct channels *channels, const struct options *options, struct diag *diag)
{
	for (int i = 0; i < FORMAT_COUNT; i++) {
		const struct format_choice *choice = &options->formats[i];
		const char *path = choice->path ? choice->path : options->output;
		bool colour = !path && console_wants_colour(STDOUT_FILENO);

		if (choice->wanted && !channels_open(channels, (enum report_format)i, path, colour, diag))
			return false;
	}
	return true;
}

/* Checks the programs; a report says itself what it lacks, and so is kept whatever came of the check. */
static enum run_status run_programs(struct job *job, const struct options *options, struct console *console)
{
	struct diag *diag = &console->diag;
	enum run_status status = RUN_INCOMPLETE;
	struct channels channels = {0};
	struct tables tables = {0};
	struct baseline *baseline = NULL;
	struct inputs inputs;

	inputs_init(&inputs);
	if (options->baseline)
		baseline = baseline_load(options->baseline, diag);
	if (!diag->errors && open_channels(&channels, options, diag) &&
	    tables_open(&tables, options->clearance_report, options->timing, diag) && job_load(job, options, diag) &&
	    files_spare_meshes(options, job->machine, job->setup, diag)) {
		/* Without collisions there is no need of bodies: their meshes stay unread. */
		struct scene bare = {.machine = job->machine, .setup = job->setup};

		inputs_add_files(&inputs, options, job->machine, job->setup, job->scene != NULL);
		status = programs_check(options, job->scene ? job->scene : &bare, job->seconds, console, &channels,
					&inputs, baseline, tables_are_wanted(&tables) ? &tables : NULL);
		if (!inputs_write_depfile(&inputs, options, diag))
			status = worst(status, RUN_INCOMPLETE);
		if (!tables_commit(&tables, diag))
			status = worst(status, RUN_INCOMPLETE);
		if (!channels_commit(&channels, diag))
			status = worst(status, RUN_INCOMPLETE);
	}
	tables_discard(&tables);
	channels_discard(&channels);
	inputs_release(&inputs);
	baseline_free(baseline);
	return status;
}

static enum run_status run_dump(const struct job *job, const struct options *options, struct diag *diag,
				struct output *out)
{
	const struct motion_options motion = {
		.flatness = options->check.tolerance,
		.block_delete = options->check.block_delete,
		.last_duplicate_wins = options->check.last_duplicate_wins,
		.includes = options->check.includes,
		.include_count = options->check.include_count,
		.input_root = options->check.input_root,
		.max_blocks = options->check.max_blocks,
	};
	struct program_file file;
	bool good;

	if (!program_open(&file, options->programs[0], diag))
		return RUN_INCOMPLETE;
	good = dump_path(out, job->machine, job->setup, &motion, file.stream, file.name, diag);
	good = program_close(&file, diag) && good;
	return good ? RUN_CLEAR : RUN_INCOMPLETE;
}

static enum run_status run_machine(const struct job *job, struct diag *diag, struct output *out)
{
	struct strbuf text = {0};
	bool good = tree_add(&text, job->scene, diag) && oddities_add(&text, job->scene, diag);

	output_text(out, &text);
	strbuf_release(&text);
	return good ? RUN_CLEAR : RUN_INCOMPLETE;
}

static enum run_status run_pairs(const struct job *job, struct output *out)
{
	struct strbuf text = {0};

	pairs_add(&text, job->scene);
	output_text(out, &text);
	strbuf_release(&text);
	return RUN_CLEAR;
}

static enum run_status run_mode(const struct job *job, const struct options *options, struct diag *diag,
				struct output *out)
{
	switch (options->mode) {
	case RUN_DUMP_PATH:
		return run_dump(job, options, diag, out);
	case RUN_LIST_PAIRS:
		return run_pairs(job, out);
	case RUN_CHECK_MACHINE:
		return run_machine(job, diag, out);
	case RUN_CHECK:
	case RUN_PARSE_ONLY:
	case RUN_HELP:
	case RUN_VERSION:
		break;
	}
	return RUN_INTERNAL;
}

/* One table: the path, the pairs, the machine. Where it broke off it is not put in the place of a whole one. */
static enum run_status run_table(struct job *job, const struct options *options, struct diag *diag)
{
	enum run_status status = RUN_INCOMPLETE;
	struct output out = {0};

	if (output_open(&out, options->output, diag) && job_load(job, options, diag) &&
	    files_spare_meshes(options, job->machine, job->setup, diag)) {
		status = run_mode(job, options, diag, &out);
		/* What went to a stream is out; it must be whole all the same. A write that failed has to be told. */
		if ((!options->output || out.error || status < RUN_INCOMPLETE) && !output_commit(&out, diag))
			status = worst(status, RUN_INCOMPLETE);
	}
	output_discard(&out);
	return status;
}

enum run_status run_options(const struct options *options, struct console *console)
{
	struct diag *diag = &console->diag;
	enum run_status status = RUN_INCOMPLETE;
	struct strbuf text = {0};
	struct job job = {0};

	console->quiet = options->quiet;
	console->kind = (enum progress_kind)options->progress;
	if (options->mode == RUN_HELP) {
		options_help(&text);
		return print_text(&text, diag);
	}
	if (options->mode == RUN_VERSION) {
		strbuf_addf(&text, "fivecheck %s\n", FIVECHECK_VERSION);
		return print_text(&text, diag);
	}
	if (files_differ(options, diag)) {
		bool checks = options->mode == RUN_CHECK || options->mode == RUN_PARSE_ONLY;

		status = checks ? run_programs(&job, options, console) : run_table(&job, options, diag);
	}
	job_release(&job);
	console_clear(console);
	/* Whatever was reported as an error was left unchecked. */
	return diag->errors ? worst(status, RUN_INCOMPLETE) : status;
}
