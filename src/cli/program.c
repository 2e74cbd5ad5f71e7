#include "cli/program.h"

#include <errno.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>

#include "base/ascii.h"
#include "base/mem.h"
#include "base/open_file.h"
#include "check/check.h"
#include "cli/interrupt.h"
#include "fivecheck.h"
#include "report/verdict.h"
#include "report/waiver_match.h"
#include "report/writers/text.h"

static const struct srcloc nowhere;

bool program_open(struct program_file *file, const char *path, struct diag *diag)
{
	const bool standard = !strcmp(path, "-");
	FILE *stream = standard ? stdin : open_file(path, diag);

	if (!stream)
		return false;
	*file = (struct program_file){stream, standard ? "<stdin>" : path};
	return true;
}

bool program_close(struct program_file *file, struct diag *diag)
{
	bool good = !ferror(file->stream);

	if (!good)
		diag_error(diag, (struct srcloc){file->name, 0, 0}, "cannot be read to its end");
	if (file->stream != stdin)
		fclose(file->stream);
	return good;
}

/* One program during its check. */
struct program {
	const struct program_context *context;
	struct program_output *output;
	struct program_outcome *outcome;
	const char *name;
	struct sensitivity sensitivity[2 * CHANGES];
	size_t sensitivity_count;
	FILE *stream;
	off_t size;	/* of the file; 0: not known */
	struct recorder *recorder;	/* for a report; or NULL */
	struct strbuf text[FORMAT_COUNT];	/* the next text for each sink */
	int *matched;	/* see waiver_match_find */
	struct strbuf waived_text;	/* waived findings and the reasons, one per line */
	long waived, left_out;	/* findings that do not fail the run */
	const char *failing_warning;	/* see struct report_program */
	/* The first finding that fails the run. */
	int first_kind;	/* enum finding_kind; -1: none yet */
	long first_line;
	char *first_file;	/* owned */
	struct strbuf first_text;	/* its message with its place */
};

static bool tell_finding(struct program *program, const struct finding *finding, enum finding_status status,
			 const struct waiver *waiver)
{
	const struct program_context *context = program->context;
	bool good = true;

	if (program->recorder)
		recorder_finding(program->recorder, finding,
				 (struct finding_style){.status = status, .waiver = waiver});
	for (size_t i = 0; i < context->sinks->count; i++) {
		const struct sink *sink = &context->sinks->items[i];

		sink->writer->finding(&program->text[i], &context->run, finding,
					 (struct finding_style){status, sink->colour, waiver});
		if (!sink->writer->whole)
			good = program_output_write(program->output, i, &program->text[i]) && good;
	}
	return good;
}

/* Sets *waiver to the waiver that accepts the finding, or NULL. A waiver that has expired is reported and ignored. */
static enum finding_status status_of_finding(struct program *program, const struct finding *finding,
					     const struct waiver **waiver)
{
	const struct program_context *context = program->context;
	const struct waiver_match *waiving = context->run.waiving;
	unsigned fail_on = context->options->fail_on;

	*waiver = waiver_match_find(waiving, program->matched, context->scene->machine, program->name, finding);
	if (*waiver && !waiver_match_is_expired(waiving, *waiver))
		return FINDING_WAIVED;
	if (*waiver)
		diag_warning(&program->output->diag, (struct srcloc){waiving->file->path, (*waiver)->line, 0},
			     "this waiver expired on %s: the finding in line %ld of %s fails the run",
			     (*waiver)->expires, finding->line, finding->file);
	*waiver = NULL;
	return fail_on && !(fail_on & 1U << finding->kind) ? FINDING_LEFT_OUT : FINDING_FAILS;
}

static void keep_waived(struct program *program, const struct finding *finding, const struct waiver *waiver)
{
	struct strbuf *out = &program->waived_text;

	strbuf_addf(out, "%s:%ld:%d: %s: ", finding->file, finding->line, finding->column,
		    finding_kind_name(finding->kind));
	text_message(out, finding);
	strbuf_addf(out, ", waived ");
	waiver_match_add_reason(out, waiver);
	strbuf_addf(out, "\n");
}

static void keep_first(struct program *program, const struct finding *finding)
{
	program->outcome->has_first = true;
	program->outcome->first_axes = finding->axes;
	program->outcome->first_tool = finding->tool;
	program->first_kind = (int)finding->kind;
	program->first_line = finding->line;
	text_headline(&program->first_text, finding, (struct finding_style){.status = FINDING_FAILS});
	program->first_file = mem_strndup(finding->file, strlen(finding->file));
}

static bool on_finding(void *context, const struct finding *finding)
{
	struct program *program = context;
	const struct waiver *waiver;
	enum finding_status status = status_of_finding(program, finding, &waiver);
	bool fails = status == FINDING_FAILS;

	program->waived += status == FINDING_WAIVED;
	program->left_out += status == FINDING_LEFT_OUT;
	if (waiver)
		keep_waived(program, finding, waiver);
	if (fails && !program->outcome->has_first)
		keep_first(program, finding);
	/* Accepted findings never stop the check. */
	return tell_finding(program, finding, status, waiver) && (!fails || program->context->options->check.all);
}

/* An unused waiver would silently accept a future contact that nobody has looked at. */
static void tell_unused(struct program *program)
{
	const struct waivers *file = program->context->run.waiving->file;
	bool limits_only = program->context->options->check.method == CHECK_NOTHING;

	for (size_t i = 0; file && i < file->count; i++) {
		const struct waiver *waiver = &file->items[i];

		if (strcmp(waiver->program, program->name) != 0 || program->matched[i] == waiver->times ||
		    (limits_only && strcmp(waiver->kind, finding_kind_name(FINDING_LIMIT)) != 0))
			continue;
		diag_warning(&program->output->diag, (struct srcloc){file->path, waiver->line, 0},
			     program->matched[i]
				 ? "this waiver accepts more findings of %s than there are: lower times=\"\""
				 : "this waiver matches no finding of %s: remove it",
			     program->name);
	}
}

/* The share of the program's file that has been read; negative: unknown, or all of it (a loop may still run). */
static double share_read(const struct program *program)
{
	off_t at = program->size > 0 ? ftello(program->stream) : -1;

	return at < 0 || at >= program->size ? -1 : (double)at / (double)program->size;
}

static bool on_progress(void *context, long lines)
{
	const struct program *program = context;

	program_output_progress(program->output, program->name, lines, share_read(program));
	return !interrupt_seen();
}

static void on_block(void *context, const struct check_block *block)
{
	const struct program *program = context;

	if (program->context->tables)
		block_tables_add(program->context->tables, program->context->scene, program->name, block);
	if (program->recorder)
		recorder_block(program->recorder, block);
}

static bool has_text(const struct sinks *sinks)
{
	for (size_t i = 0; i < sinks->count; i++) {
		if (sinks->items[i].writer == report_writers[FORMAT_TEXT])
			return true;
	}
	return false;
}

/* Without a text report the verdict goes to standard error. */
static void tell_verdict(struct program *program, const struct verdict *verdict)
{
	struct diag *diag = &program->output->diag;
	const struct srcloc loc = {program->name, 0, 0};
	struct strbuf text = {0};

	verdict_add_sentence(&text, verdict);
	diag_note(diag, loc, "%s", strbuf_text(&text));
	for (int i = 0; i < VERDICT_CAUTIONS; i++) {
		strbuf_clear(&text);
		if (verdict_add_caution(&text, verdict, i))
			diag_warning(diag, loc, "%s", strbuf_text(&text));
	}
	strbuf_release(&text);
}

/* --report. The verdict is valid, but the requested file is missing. */
static void write_report(struct program *program, const struct report_program *about)
{
	const struct program_context *context = program->context;
	const size_t index = (size_t)(program->output - program->output->order->programs);

	if (!program_reports_write(context->reports, index, program->recorder, &context->run, about,
				   &program->output->diag) &&
	    program->outcome->status < RUN_INCOMPLETE)
		program->outcome->status = RUN_INCOMPLETE;
}

/* verdict NULL: the program could not be opened */
static void report(struct program *program, const struct verdict *verdict, const double *proven)
{
	const struct program_context *context = program->context;
	const struct error_list *errors = &program->output->errors;
	const struct report_program about = {
	    .name = program->name,
	    .verdict = verdict,
	    .unread = program->stream ? "the program cannot be read twice" : "the program could not be opened",
	    .proven = proven,
	    .sensitivity = program->sensitivity,
	    .sensitivity_count = program->sensitivity_count,
	    .errors = errors->items,
	    .error_count = errors->count,
	    .waived = strbuf_text(&program->waived_text),
	    .failing_warning = program->failing_warning,
	    .first_kind = program->first_kind,
	    .first_text = program->first_text.text,
	};

	if (verdict && !has_text(context->sinks))
		tell_verdict(program, verdict);
	for (size_t i = 0; i < context->sinks->count; i++) {
		context->sinks->items[i].writer->program(&program->text[i], &context->run, &about);
		program_output_write(program->output, i, &program->text[i]);
	}
	/*
	 * The report comes last: the verdict is already printed, and a fault of the report adds an error, which may
	 * move the array of errors.
	 */
	if (program->recorder)
		write_report(program, &about);
}

/* Is it probably a setup without its --setup? */
static bool is_xml_name(const char *path)
{
	size_t length = strlen(path);

	return length > 4 && ascii_same(path + length - 4, ".xml");
}

static enum run_status status_of(enum check_result result)
{
	switch (result) {
	case CHECK_CLEAR:
		return RUN_CLEAR;
	case CHECK_FOUND:
		return RUN_FOUND;
	case CHECK_INCOMPLETE:
		return RUN_INCOMPLETE;
	}
	return RUN_INTERNAL;
}

/* --sensitivity: by how much the setup may be wrong before the verdict changes. */
static void measure_sensitivity(struct program *program, FILE *in, off_t start)
{
	const struct check_sink sink = {program, on_finding, on_progress, NULL};
	const struct program_context *context = program->context;
	const struct sensitivity_study study = {
		.scene = context->scene,
		.options = &context->check,
		.range = context->options->sensitivity,
		.result = program->outcome->result,
		.in = in,
		.name = program->name,
	};
	struct diag *diag = &program->output->diag;

	if (!options_want_sensitivity(context->options) || program->outcome->result == CHECK_INCOMPLETE)
		return;
	if (fseeko(in, start, SEEK_SET)) {
		diag_error(diag, nowhere, "--sensitivity must read %s again, but cannot: %s", program->name,
			   strerror(errno));
		return;
	}
	program->sensitivity_count = sensitivity_run(&study, &sink, diag, program->sensitivity);
	if (interrupt_seen())
		diag_error(diag, (struct srcloc){program->name, 0, 0},
			   "interrupted before --sensitivity was finished");
}

/* --sensitivity reads the program again, which is impossible for a pipe. False: reported. */
static bool find_start(const struct program *program, const struct program_file *file, off_t *start)
{
	*start = ftello(file->stream);
	if (*start >= 0 || !options_want_sensitivity(program->context->options))
		return true;
	diag_error(&program->output->diag, nowhere,
		   "--sensitivity reads a program several times, but %s cannot be read twice: give a regular file",
		   file->name);
	return false;
}

/* The verdict of the checked program. */
static struct verdict verdict_of(const struct program *program)
{
	const struct program_context *context = program->context;

	return (struct verdict){
		.file = program->name,
		.result = program->outcome->result,
		.options = &context->options->check,
		.stats = &program->outcome->stats,
		.scene = context->scene,
		.waived = program->waived,
		.left_out = program->left_out,
		.first_line = program->first_line,
		.first_file = program->first_file,
		.warnings = program->output->errors.warnings,
		.first_warning = program->output->errors.first_warning,
	};
}

/* Sets the outcome's status, according to the waivers and the kinds of findings that fail the run. */
static void set_status(struct program *program, const struct verdict *verdict)
{
	const struct options *options = program->context->options;
	struct program_outcome *outcome = program->outcome;

	outcome->status = status_of(outcome->result);
	outcome->accepted = verdict_is_accepted(verdict);
	outcome->waived = program->waived;
	if (outcome->result == CHECK_CLEAR || outcome->accepted ||
	    (outcome->result == CHECK_FOUND && options->check.all))
		tell_unused(program);
	if (outcome->accepted)
		outcome->status = RUN_CLEAR;
	if (options->fail_on_warnings && verdict->warnings && outcome->status == RUN_CLEAR) {
		outcome->status = RUN_FOUND;
		program->failing_warning = verdict->first_warning;
		diag_note(&program->output->diag, nowhere,
			  "%s fails the run because of its warnings (--fail-on=warning)", program->name);
	}
}

/* Checks the program and reports it. */
static void run_check(struct program *program, struct program_file *file, const char *path, off_t start)
{
	const struct program_context *context = program->context;
	const struct fivecheck_events events = {program, on_finding, on_progress,
						context->tables || program->recorder ? on_block : NULL};
	struct check_options check = context->check;
	struct program_outcome *outcome = program->outcome;
	struct diag *diag = &program->output->diag;
	double *proven = NULL;
	struct verdict verdict;

	if (context->options->verbose)
		proven = mem_zalloc(context->scene->pair_count, sizeof(*proven));
	check.watch = program->recorder ? &program->recorder->watch : NULL;
	check.stock_view = program->recorder ? &program->recorder->stock : NULL;
	outcome->result = (enum check_result)fivecheck_check(context->model, &check, file->stream, file->name,
							     &events, diag, &outcome->stats, proven);
	measure_sensitivity(program, file->stream, start);
	if (!program_close(file, diag))
		outcome->result = CHECK_INCOMPLETE;
	if (outcome->result == CHECK_INCOMPLETE && is_xml_name(path))
		diag_note(diag, nowhere,
			  "%s was read as an NC program: give one machine file, then the programs, and the setup with "
			  "--setup", path);
	verdict = verdict_of(program);
	set_status(program, &verdict);
	report(program, &verdict, proven);
	free(proven);
	if (outcome->result == CHECK_INCOMPLETE && !diag->errors && !ordered_output_is_lost(program->output->order)) {
		diag_error(diag, nowhere, "internal error: the check of %s ended early without an error", file->name);
		outcome->status = RUN_INTERNAL;
	}
}

void program_check(const struct program_context *context, const char *path, struct program_output *output,
		   struct program_outcome *outcome)
{
	struct program program = {.context = context, .output = output, .outcome = outcome, .first_kind = -1};
	struct recorder recorder;
	struct program_file file;
	bool opened;
	off_t start;
	struct stat status;

	*outcome = (struct program_outcome){.status = RUN_INCOMPLETE, .result = CHECK_INCOMPLETE};
	program.name = path;
	if (context->run.waiving->file)
		program.matched = mem_zalloc(context->run.waiving->file->count + 1, sizeof(*program.matched));
	if (context->reports) {
		recorder_init(&recorder, context->scene, strcmp(path, "-") != 0 ? path : "<stdin>",
			      context->check.block_clearance_cap);
		recorder.stock.most = program_reports_stock_triangles(context->reports);
		program.recorder = &recorder;
	}
	opened = program_open(&file, path, &output->diag);
	if (opened) {
		program.name = file.name;
		program.stream = file.stream;
	}
	if (opened && find_start(&program, &file, &start)) {
		if (!fstat(fileno(file.stream), &status) && S_ISREG(status.st_mode))
			program.size = status.st_size;
		run_check(&program, &file, path, start);
	} else {
		report(&program, NULL, NULL);
		if (opened)
			program_close(&file, &output->diag);
	}
	if (program.recorder)
		recorder_release(program.recorder);
	sensitivity_release(program.sensitivity, program.sensitivity_count);
	free(program.matched);
	strbuf_release(&program.waived_text);
	free(program.first_file);
	strbuf_release(&program.first_text);
	for (size_t i = 0; i < FORMAT_COUNT; i++)
		strbuf_release(&program.text[i]);
}
