#include "fivecheck.h"

#include <stdlib.h>

#include "base/mem.h"
#include "base/open_file.h"
#include "check/check.h"
#include "check/model.h"
#include "control/dialects.h"
#include "scene/model_check.h"

/* The interface has its own names for these; the numbers are the same. */
_Static_assert((int)FIVECHECK_NOTE == DIAG_NOTE && (int)FIVECHECK_ERROR == DIAG_ERROR, "severities");
_Static_assert((int)FIVECHECK_COLLISION == FINDING_COLLISION && (int)FIVECHECK_START_OVERLAP == FINDING_START_OVERLAP,
	       "kinds of findings");
_Static_assert((int)FIVECHECK_CLEAR == CHECK_CLEAR && (int)FIVECHECK_INCOMPLETE == CHECK_INCOMPLETE, "results");

static const struct srcloc nowhere;

const char *fivecheck_version(void)
{
	return FIVECHECK_VERSION;
}

fivecheck_diag *fivecheck_diag_new(void (*handle)(void *context, const fivecheck_message *message), void *context)
{
	struct diag *diag = mem_zalloc(1, sizeof(*diag));

	diag->handle = handle;
	diag->context = context;
	return diag;
}

void fivecheck_diag_free(fivecheck_diag *diag)
{
	free(diag);
}

size_t fivecheck_diag_errors(const fivecheck_diag *diag)
{
	return diag->errors;
}

enum fivecheck_severity fivecheck_message_severity(const fivecheck_message *message)
{
	return (enum fivecheck_severity)message->severity;
}

const char *fivecheck_message_file(const fivecheck_message *message)
{
	return message->loc.file;
}

long fivecheck_message_line(const fivecheck_message *message)
{
	return message->loc.line;
}

int fivecheck_message_column(const fivecheck_message *message)
{
	return message->loc.column;
}

const char *fivecheck_message_text(const fivecheck_message *message)
{
	return message->text;
}

fivecheck_model *fivecheck_load(const char *machine, const char *setup, fivecheck_diag *diag)
{
	return model_load(machine, setup, NULL, diag);
}

void fivecheck_free(fivecheck_model *model)
{
	model_free(model);
}

bool fivecheck_set_dialect(fivecheck_model *model, const char *name, fivecheck_diag *diag)
{
	int row = dialect_row_find(name);

	if (row < 0)
		diag_error(diag, nowhere, "'%s' is not the name of a dialect", name);
	else
		model->machine->controller.dialect = row;
	return row >= 0;
}

/* More threads would only use memory. */
static bool is_thread_count(int threads)
{
	return threads >= 1 && threads <= 1024;
}

bool fivecheck_set_threads(fivecheck_model *model, int threads)
{
	if (!is_thread_count(threads))
		return false;
	model->threads = threads;
	return true;
}

bool fivecheck_prepare(fivecheck_model *model, double clearance, fivecheck_diag *diag)
{
	if (model->scene) {
		diag_error(diag, nowhere, "a model can be prepared only once");
		return false;
	}
	if (!(clearance >= 0)) {
		diag_error(diag, nowhere, "the clearance must not be negative");
		return false;
	}
	if (!model_add_scene(model, clearance, diag))
		return false;
	model_check(model->scene, model->threads);
	return true;
}

fivecheck_options *fivecheck_options_new(void)
{
	struct check_options *options = mem_zalloc(1, sizeof(*options));

	options->method = CHECK_CERTIFIED;
	options->tolerance = FIVECHECK_TOLERANCE;
	options->threads = 1;
	return options;
}

void fivecheck_options_free(fivecheck_options *options)
{
	free(options);
}

bool fivecheck_options_set_tolerance(fivecheck_options *options, double tolerance)
{
	if (!(tolerance >= 1e-6 && tolerance <= 100))
		return false;
	options->tolerance = tolerance;
	return true;
}

bool fivecheck_options_set_threads(fivecheck_options *options, int threads)
{
	if (!is_thread_count(threads))
		return false;
	options->threads = threads;
	return true;
}

void fivecheck_options_set_all(fivecheck_options *options, bool all)
{
	options->all = all;
}

void fivecheck_options_set_parse_only(fivecheck_options *options, bool parse_only)
{
	options->method = parse_only ? CHECK_NOTHING : CHECK_CERTIFIED;
}

void fivecheck_options_set_block_delete(fivecheck_options *options, bool block_delete)
{
	options->read.block_delete = block_delete;
}

void fivecheck_options_set_includes(fivecheck_options *options, const char *const *folders, size_t count)
{
	options->read.includes = folders;
	options->read.include_count = count;
}

enum fivecheck_kind fivecheck_finding_kind(const fivecheck_finding *finding)
{
	return (enum fivecheck_kind)finding->kind;
}

const char *fivecheck_finding_file(const fivecheck_finding *finding)
{
	return finding->file;
}

long fivecheck_finding_line(const fivecheck_finding *finding)
{
	return finding->line;
}

bool fivecheck_finding_caller(const fivecheck_finding *finding, size_t level, const char **file, long *line)
{
	if (level >= finding->caller_count)
		return false;
	*file = finding->callers[level].file;
	*line = finding->callers[level].line;
	return true;
}

const char *fivecheck_finding_block(const fivecheck_finding *finding)
{
	return finding->text;
}

double fivecheck_finding_fraction(const fivecheck_finding *finding)
{
	return finding->fraction;
}

double fivecheck_finding_time(const fivecheck_finding *finding)
{
	return finding->time;
}

int fivecheck_finding_tool(const fivecheck_finding *finding)
{
	return finding->tool;
}

double fivecheck_finding_axis(const fivecheck_finding *finding, char letter)
{
	int slot = slot_of_letter(letter);

	return slot < 0 ? 0 : finding->axes.v[slot];
}

static bool is_limit(const struct finding *finding)
{
	return finding->kind == FINDING_LIMIT;
}

const char *fivecheck_finding_body_a(const fivecheck_finding *finding)
{
	return is_limit(finding) ? NULL : finding->of.pair.a;
}

const char *fivecheck_finding_body_b(const fivecheck_finding *finding)
{
	return is_limit(finding) ? NULL : finding->of.pair.b;
}

bool fivecheck_finding_point(const fivecheck_finding *finding, double point[3])
{
	if (is_limit(finding))
		return false;
	point[0] = finding->of.pair.point.x;
	point[1] = finding->of.pair.point.y;
	point[2] = finding->of.pair.point.z;
	return true;
}

double fivecheck_finding_distance(const fivecheck_finding *finding)
{
	return is_limit(finding) ? 0 : finding->of.pair.clearance;
}

double fivecheck_finding_required(const fivecheck_finding *finding)
{
	return is_limit(finding) ? 0 : finding->of.pair.required;
}

char fivecheck_finding_limit_axis(const fivecheck_finding *finding)
{
	return is_limit(finding) ? AXIS_LETTERS[finding->of.limit.slot] : 0;
}

double fivecheck_finding_limit(const fivecheck_finding *finding)
{
	return is_limit(finding) ? finding->of.limit.bound : 0;
}

/* The check itself stops if the options say so. */
static bool ignore_finding(void *context, const struct finding *finding)
{
	(void)context;
	(void)finding;
	return true;
}

enum fivecheck_result fivecheck_check(fivecheck_model *model, const fivecheck_options *options, FILE *in,
				      const char *name, const struct fivecheck_events *events, fivecheck_diag *diag,
				      fivecheck_statistics *statistics, double *proven)
{
	const struct check_sink sink = {
		.context = events ? events->context : NULL,
		.finding = events && events->finding ? events->finding : ignore_finding,
		.progress = events ? events->progress : NULL,
		.block = events ? events->block : NULL,
	};
	struct check_stats unwanted;
	size_t before = diag->errors;
	enum check_result result;

	if (!model->scene && options->method != CHECK_NOTHING) {
		diag_error(diag, nowhere, "the model was not prepared, so its bodies are not known");
		return FIVECHECK_INCOMPLETE;
	}
	result =
	    check_run(model_scene(model), options, in, name, &sink, diag, statistics ? statistics : &unwanted, proven);
	return ferror(in) || diag->errors > before ? FIVECHECK_INCOMPLETE : (enum fivecheck_result)result;
}

enum fivecheck_result fivecheck_check_file(fivecheck_model *model, const fivecheck_options *options, const char *path,
					   const struct fivecheck_events *events, fivecheck_diag *diag,
					   fivecheck_statistics *statistics, double *proven)
{
	enum fivecheck_result result;
	FILE *in = open_file(path, diag);

	if (!in)
		return FIVECHECK_INCOMPLETE;
	result = fivecheck_check(model, options, in, path, events, diag, statistics, proven);
	if (ferror(in))
		diag_error(diag, (struct srcloc){path, 0, 0}, "cannot be read to its end");
	fclose(in);
	return result;
}

size_t fivecheck_pair_count(const fivecheck_model *model)
{
	return model->scene ? model->scene->pair_count : 0;
}

bool fivecheck_pair(const fivecheck_model *model, size_t pair, const char **a, const char **b, const char **reason)
{
	const struct scene_pair *found = &model->scene->pairs[pair];

	*a = model->scene->bodies[found->a].body->name;
	*b = model->scene->bodies[found->b].body->name;
	*reason = found->reason;
	return found->status == PAIR_CHECKED;
}

fivecheck_statistics *fivecheck_statistics_new(void)
{
	return mem_zalloc(1, sizeof(struct check_stats));
}

void fivecheck_statistics_free(fivecheck_statistics *statistics)
{
	free(statistics);
}

long fivecheck_statistics_blocks(const fivecheck_statistics *statistics)
{
	return statistics->blocks_checked;
}

long fivecheck_statistics_findings(const fivecheck_statistics *statistics)
{
	return statistics->findings;
}

double fivecheck_statistics_motion_time(const fivecheck_statistics *statistics)
{
	return statistics->motion.seconds;
}
