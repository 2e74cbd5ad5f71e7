#include "cli/run.h"

#include <string.h>
#include <unistd.h>

#include "check/model.h"
#include "cli/diag_tee.h"
#include "cli/dialect_choice.h"
#include "cli/digesting.h"
#include "cli/error_list.h"
#include "cli/failure_report.h"
#include "cli/input_files.h"
#include "cli/path_checks.h"
#include "cli/program.h"
#include "cli/program_reports.h"
#include "cli/programs.h"
#include "cli/report_date.h"
#include "cli/report_paths.h"
#include "fivecheck.h"
#include "report/depfile.h"
#include "report/format/digest.h"
#include "report/html/axis_page.h"
#include "report/machine_json.h"
#include "report/machine_report.h"
#include "report/oddities.h"
#include "report/tables/dump.h"
#include "report/tables/pairs.h"
#include "scene/model_check.h"

static const struct srcloc nowhere;

static enum run_status worst(enum run_status a, enum run_status b)
{
	return a > b ? a : b;
}

/* Everything that a run has loaded; all zero is nothing. */
struct job {
	struct waivers *waivers;	/* or NULL */
	struct waiver_match waiving;
	struct model *model;
	bool borrowed;	/* the caller has loaded and prepared the model */
	struct known_digests *known;	/* of the borrowed model's files; or NULL */
	struct digesting digesting;	/* of the files that a check reads */
	double seconds;	/* for loading */
};

static void job_release(struct job *job)
{
	waivers_free(job->waivers);
	if (!job->borrowed)
		fivecheck_free(job->model);
}

/* Does the file have this digest ("none": no file)? A digest that is NULL fits every file. */
static bool has_digest(const char *path, const char *digest)
{
	char found[DIGEST_SIZE] = "none";

	if (!digest || (path && !digest_file(found, path, NULL)))
		return !digest;
	return !strcmp(found, digest);
}

/* Waivers of another machine or setup would accept findings that nobody has looked at. */
static bool check_waivers(const struct waivers *waivers, const struct options *options, struct diag *diag)
{
	const struct srcloc at = {waivers->path, waivers->line, 0};

	if (!has_digest(options->machine, waivers->machine_sha256)) {
		diag_error(diag, at,
			   "these waivers were written for another machine file than %s: verify the findings again, or "
			   "remove machine_sha256=\"\" to use the waivers anyway",
			   options->machine);
		return false;
	}
	if (!has_digest(options->setup, waivers->setup_sha256)) {
		diag_error(diag, at,
			   "these waivers were written for another setup than %s: verify the findings again, or remove "
			   "setup_sha256=\"\" to use the waivers anyway",
			   options->setup ? options->setup : "none");
		return false;
	}
	return true;
}

static bool load_waivers(struct job *job, const struct options *options, struct diag *diag)
{
	if (!options->waivers)
		return true;
	job->waivers = waivers_load(options->waivers, job->model->machine, diag);
	job->waiving.file = job->waivers;
	return job->waivers && check_waivers(job->waivers, options, diag) && report_date_get(job->waiving.today, diag);
}

static bool needs_pairs(enum run_mode mode)
{
	return mode == RUN_LIST_PAIRS || mode == RUN_CHECK_MACHINE;
}

/* Notes that the operands may be in the wrong order. */
static void note_order(const struct options *options, struct diag *diag)
{
	const char *first = options->program_count ? options->programs[0] : "";
	size_t length = strlen(first);

	if (length > 4 && !strcmp(first + length - 4, ".xml"))
		diag_note(diag, nowhere, "the machine file comes first: fivecheck %s %s", first, options->machine);
}

/* Reads the machine, the setup and the waivers, without a mesh. False: reported. */
static bool job_read(struct job *job, const struct options *options, struct diag *diag)
{
	double start = stderr_ui_seconds();

	if (!path_checks_folders(options, diag))
		return false;
	if (!job->borrowed)
		job->model = model_load(options->machine, options->setup, options->check.read.input_root, diag);
	if (!job->model) {
		note_order(options, diag);
		return false;
	}
	if (!path_checks_within(options, job->model->machine, job->model->setup, diag) ||
	    !load_waivers(job, options, diag))
		return false;
	if (dialect_choice_is_auto(options->dialect)) {
		if (!dialect_choice_find(options->programs, options->program_count, diag,
					 &job->model->machine->controller.dialect))
			return false;
	} else if (options->dialect >= 0) {
		job->model->machine->controller.dialect = options->dialect;
	}
	fivecheck_set_threads(job->model, options->check.threads);
	job->seconds = stderr_ui_seconds() - start;
	return true;
}

/* Reads the bodies if they are needed and not loaded yet, and derives their pairs. False: reported. */
static bool job_prepare(struct job *job, const struct options *options, struct diag *diag)
{
	double start = stderr_ui_seconds();

	if (job->borrowed) {
		/* The bodies are loaded already. */
	} else if (options->mode == RUN_CHECK) {
		if (!fivecheck_prepare(job->model, options->clearance, diag))
			return false;
	} else if (needs_pairs(options->mode) && !model_add_scene(job->model, options->clearance, diag)) {
		return false;
	}
	job->seconds += stderr_ui_seconds() - start;
	return diag->errors == 0;
}

/* False: reported. */
static bool open_channels(struct sinks *sinks, const struct options *options, struct diag *diag)
{
	for (int i = 0; i < FORMAT_COUNT; i++) {
		const struct format_choice *choice = &options->formats[i];
		const char *path = choice->path ? choice->path : options->output;
		bool colour = !path && stderr_ui_wants_colour(STDOUT_FILENO, (enum color_choice)options->color);

		if (choice->wanted && !sinks_open(sinks, (enum report_format)i, path, colour, diag))
			return false;
	}
	return true;
}

/*
 * A pair with a required clearance has only findings of the kind clearance. --fail-on=collision alone would let its
 * collisions pass, so this is rejected.
 */
static bool check_kinds(const struct options *options, const struct scene *scene, struct diag *diag)
{
	const unsigned both = 1U << FINDING_COLLISION | 1U << FINDING_CLEARANCE;

	if (!scene || (options->fail_on & both) != 1U << FINDING_COLLISION)
		return true;
	for (size_t i = 0; i < scene->pair_count; i++) {
		const struct scene_pair *pair = &scene->pairs[i];

		if ((pair->status != PAIR_CHECKED && pair->status != PAIR_OUT_OF_REACH) || !(pair->clearance > 0))
			continue;
		diag_error(diag, nowhere,
			   "--fail-on names collision but not clearance: '%s' and '%s' must keep %g mm, and a "
			   "collision of such bodies is reported as clearance; add clearance to --fail-on",
			   scene->bodies[pair->a].body->name, scene->bodies[pair->b].body->name, pair->clearance);
		return false;
	}
	return true;
}

/* --stock-out. False: reported. */
static bool check_stock(const struct options *options, const struct scene *scene, struct diag *diag)
{
	if (!options->stock_out || scene_stock(scene) >= 0)
		return true;
	diag_error(diag, nowhere, "--stock-out needs a <stock> in the setup");
	return false;
}

/* From now on changes of these files are detected. */
static void add_inputs(struct job *job, const struct options *options, struct input_files *inputs)
{
	const bool meshes = options->mode == RUN_CHECK || job->model->scene;

	input_files_add_files(inputs, options, job->model->machine, job->model->setup, meshes);
	input_files_sort(inputs);
	if (!options_want_digests(options))
		return;
	if (job->known)
		input_files_take_known(inputs, job->known);
	digesting_begin(&job->digesting, inputs, options->check.threads);
}

/* Reads everything but the programs. False: reported. */
static bool load_all(struct job *job, const struct options *options, struct input_files *inputs, struct diag *diag)
{
	if (!job_read(job, options, diag))
		return false;
	add_inputs(job, options, inputs);
	return path_checks_stocks(options, inputs, diag) && job_prepare(job, options, diag) &&
	       check_kinds(options, job->model->scene, diag) && check_stock(options, job->model->scene, diag);
}

/* Checks the programs. Reports are kept even if the check is incomplete, because they say so. */
static enum run_status check_programs(struct job *job, const struct options *options, struct stderr_ui *ui,
				      struct diag_tee *tee, struct sinks *sinks, struct block_tables *tables,
				      struct input_files *inputs)
{
	struct diag *diag = &ui->diag;
	enum run_status status;

	digesting_finish(&job->digesting);
	if (job->known)
		input_files_remember(inputs, job->known);
	status = programs_check(&(struct programs_run){
		.options = options, .model = job->model, .seconds = job->seconds, .ui = ui, .tee = tee,
		.sinks = sinks,
		.inputs = inputs, .waiving = &job->waiving, .tables = block_tables_are_wanted(tables) ? tables : NULL});
	/* Without a sink nothing may be written: programs_check has discarded the sinks. */
	if (sinks->count && !input_files_write_depfile(inputs, options, diag))
		status = worst(status, RUN_INCOMPLETE);
	if (sinks->count && !block_tables_commit(tables, diag))
		status = worst(status, RUN_INCOMPLETE);
	if (!sinks_commit(sinks, diag))
		status = worst(status, RUN_INCOMPLETE);
	return status;
}

static enum run_status run_programs(struct job *job, const struct options *options, struct stderr_ui *ui)
{
	struct diag *diag = &ui->diag;
	enum run_status status = RUN_INCOMPLETE;
	struct sinks sinks = {0};
	struct block_tables tables = {0};
	struct input_files inputs;
	struct diag_tee tee;

	/* Before any file is read, so that later changes are detected. */
	input_files_init(&inputs);
	diag_tee_init(&tee, diag);
	if (!open_channels(&sinks, options, diag) ||
	    !block_tables_open(&tables, options->clearance_report, options->timing, diag)) {
		/* No report can be written. */
	} else if (!load_all(job, options, &inputs, &tee.diag)) {
		failure_report_write(options, FAILURE_OF_INPUT, &tee.errors, &sinks, diag);
	} else if (path_checks_meshes(options, job->model->machine, job->model->setup, diag)) {
		status = check_programs(job, options, ui, &tee, &sinks, &tables, &inputs);
	}
	digesting_end(&job->digesting);
	block_tables_discard(&tables);
	sinks_discard(&sinks);
	diag_tee_release(&tee);
	input_files_release(&inputs);
	return status;
}

/* Adds the files of subprograms to the inputs. */
static enum run_status run_dump(const struct job *job, const struct options *options, struct input_files *inputs,
				struct diag *diag, struct output *out)
{
	struct motion_options motion = {
		.flatness = options->check.tolerance,
		.read = options->check.read,
	};
	struct program_file file;
	bool good;

	if (!program_open(&file, options->programs[0], diag))
		return RUN_INCOMPLETE;
	motion.read.opened = &inputs->opened;
	good = dump_path(out, job->model->machine, job->model->setup, &motion, file.stream, file.name, diag);
	good = program_close(&file, diag) && good;
	return good ? RUN_CLEAR : RUN_INCOMPLETE;
}

static enum run_status run_machine(const struct job *job, const struct options *options, struct diag *diag,
				   struct output *out)
{
	const bool as_json = options->formats[FORMAT_JSON].wanted;
	struct scene *scene = job->model->scene;
	struct oddities oddities = {0};
	struct strbuf text = {0};
	bool good = !options->report || report_paths_may_replace("report", options->report, diag);

	model_check(scene, options->check.threads);
	good = good && oddities_find(&oddities, scene, diag) &&
	       (!options->report || axis_page_write(options->report, scene, diag));
	if (good && as_json) {
		machine_json_add(&text, scene, &oddities);
	} else if (good) {
		machine_report_add(&text, scene);
		machine_report_add_oddities(&text, &oddities);
	}
	output_text(out, &text);
	strbuf_release(&text);
	oddities_release(&oddities);
	return good ? RUN_CLEAR : RUN_INCOMPLETE;
}

static enum run_status run_pairs(const struct job *job, bool as_json, struct output *out)
{
	struct strbuf text = {0};

	if (as_json)
		machine_json_add_pairs(&text, job->model->scene);
	else
		pairs_add(&text, job->model->scene);
	output_text(out, &text);
	strbuf_release(&text);
	return RUN_CLEAR;
}

/* Writes the names of the files that a check reads, one per line. */
static enum run_status run_depends(const struct job *job, const struct options *options, struct diag *diag,
				   struct output *out)
{
	struct input_files inputs;
	struct strbuf text = {0};
	bool good = true;

	input_files_init(&inputs);
	input_files_add_files(&inputs, options, job->model->machine, job->model->setup, true);
	input_files_sort(&inputs);
	if (options->job_file) {
		good = depfile_add_name(&text, options->job_file, false, diag);
		strbuf_addf(&text, "\n");
	}
	for (size_t i = 0; i < inputs.count; i++) {
		good = depfile_add_name(&text, inputs.items[i].path, false, diag) && good;
		strbuf_addf(&text, "\n");
	}
	output_text(out, &text);
	strbuf_release(&text);
	input_files_release(&inputs);
	return good ? RUN_CLEAR : RUN_INCOMPLETE;
}

static enum run_status run_mode(const struct job *job, const struct options *options, struct input_files *inputs,
				struct diag *diag, struct output *out)
{
	const bool as_json = options->formats[FORMAT_JSON].wanted;

	switch (options->mode) {
	case RUN_DUMP_PATH:
		return run_dump(job, options, inputs, diag, out);
	case RUN_LIST_PAIRS:
		return run_pairs(job, as_json, out);
	case RUN_CHECK_MACHINE:
		return run_machine(job, options, diag, out);
	case RUN_DEPENDS:
		return run_depends(job, options, diag, out);
	case RUN_CHECK:
	case RUN_PARSE_ONLY:
	case RUN_EXPLAIN:
	case RUN_HELP:
	case RUN_VERSION:
		break;
	}
	return RUN_INTERNAL;
}

/* Adds the files that were read so far to the inputs. False, reported: an output is one of them. */
static bool check_inputs_so_far(const struct job *job, const struct options *options, struct input_files *inputs,
			  struct diag *diag)
{
	input_files_add_files(inputs, options, job->model->machine, job->model->setup, true);
	return path_checks_inputs(options, inputs, diag);
}

/* Writes one table: the path, the pairs or the machine. An incomplete table does not replace the file. */
static enum run_status run_table(struct job *job, const struct options *options, struct diag *diag)
{
	enum run_status status = RUN_INCOMPLETE;
	struct output out = {0};
	struct input_files inputs;

	input_files_init(&inputs);
	if (output_open(&out, options->output, diag) && job_read(job, options, diag) &&
	    job_prepare(job, options, diag) && check_inputs_so_far(job, options, &inputs, diag)) {
		status = run_mode(job, options, &inputs, diag, &out);
		/* Only now the files of subprograms are known. */
		if (!path_checks_inputs(options, &inputs, diag))
			status = RUN_INCOMPLETE;
		/* Standard output already has the text, and a failed write must be reported. */
		if ((!options->output || out.error || status < RUN_INCOMPLETE) && !output_commit(&out, diag))
			status = worst(status, RUN_INCOMPLETE);
	}
	output_discard(&out);
	input_files_release(&inputs);
	return status;
}

enum run_status run_options_on(const struct options *options, struct model *model, struct known_digests *known,
			       struct stderr_ui *ui)
{
	struct diag *diag = &ui->diag;
	enum run_status status = RUN_INCOMPLETE;
	struct job job = {.model = model, .borrowed = model != NULL, .known = known};

	ui->quiet = options->quiet;
	ui->colour = stderr_ui_wants_colour(STDERR_FILENO, (enum color_choice)options->color);
	ui->kind = (enum progress_kind)options->progress;
	if (path_checks_outputs(options, diag)) {
		bool checks = options->mode == RUN_CHECK || options->mode == RUN_PARSE_ONLY;

		status = checks ? run_programs(&job, options, ui) : run_table(&job, options, diag);
	}
	job_release(&job);
	stderr_ui_clear(ui);
	/* After any error some part was not checked. */
	return diag->errors ? worst(status, RUN_INCOMPLETE) : status;
}

enum run_status run_options(const struct options *options, struct stderr_ui *ui)
{
	return run_options_on(options, NULL, NULL, ui);
}
