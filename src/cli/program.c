#include "cli/program.h"

#include <errno.h>
#include <stdlib.h>
#include <string.h>
#include <strings.h>
#include <sys/stat.h>

#include "base/mem.h"
#include "check/check.h"
#include "report/ndjson.h"
#include "report/text.h"
#include "report/verdict.h"

static const struct srcloc nowhere;

bool program_open(struct program_file *file, const char *path, struct diag *diag)
{
	bool standard = !strcmp(path, "-");
	struct stat status;
	FILE *stream = standard ? stdin : fopen(path, "rb");

	if (!stream || fstat(fileno(stream), &status)) {
		diag_error(diag, nowhere, "cannot open %s: %s", path, strerror(errno));
	} else if (S_ISDIR(status.st_mode)) {
		diag_error(diag, nowhere, "cannot read %s: it is a directory", path);
	} else {
		*file = (struct program_file){stream, standard ? "<stdin>" : path};
		return true;
	}
	if (stream && !standard)
		fclose(stream);
	return false;
}

bool program_close(struct program_file *file, struct diag *diag)
{
	bool good = !ferror(file->stream);

	if (!good)
		diag_error(diag, nowhere, "cannot read all of %s", file->name);
	if (file->stream != stdin)
		fclose(file->stream);
	return good;
}

/* One program while it runs. */
struct program {
	struct program_run *run;
	const char *name;
	struct strbuf text;
	long first_line;	/* of the first finding; 0: none yet */
	char *first_file;	/* the same; owned */
};

static bool on_finding(void *context, const struct finding *finding)
{
	struct program *program = context;
	struct program_run *run = program->run;
	const struct machine *machine = run->scene->machine;

	if (!run->has_first) {
		run->has_first = true;
		run->first_axes = finding->axes;
		run->first_tool = finding->tool;
	}
	if (!program->first_line) {
		program->first_line = finding->line;
		program->first_file = mem_strndup(finding->file, strlen(finding->file));
	}
	if (run->options->format == FORMAT_NDJSON)
		ndjson_finding(&program->text, machine, finding);
	else
		text_finding(&program->text, machine, finding, run->colour);
	console_clear(run->console);
	output_text(run->out, &program->text);
	return output_flush(run->out);
}

static void on_progress(void *context, long lines)
{
	const struct program *program = context;

	console_progress(program->run->console, program->name, lines);
}

/* NDJSON has findings only; what else there is to say goes to standard error. */
static void tell_verdict(struct program *program, const struct verdict *verdict)
{
	struct diag *diag = &program->run->console->diag;
	const struct srcloc loc = {program->name, 0, 0};

	strbuf_clear(&program->text);
	verdict_add_sentence(&program->text, verdict);
	diag_note(diag, loc, "%s", strbuf_text(&program->text));
	for (int i = 0; i < VERDICT_CAUTIONS; i++) {
		strbuf_clear(&program->text);
		if (verdict_add_caution(&program->text, verdict, i))
			diag_warning(diag, loc, "%s", strbuf_text(&program->text));
	}
}

static void report(struct program *program, const struct verdict *verdict, const double *proven)
{
	struct program_run *run = program->run;

	if (run->options->format == FORMAT_NDJSON) {
		tell_verdict(program, verdict);
		return;
	}
	strbuf_clear(&program->text);
	text_verdict(&program->text, verdict);
	if (proven && verdict->result == CHECK_CLEAR)
		text_proven(&program->text, run->scene, proven);
	console_clear(run->console);
	output_text(run->out, &program->text);
	output_flush(run->out);
}

/* A list of verdicts without it would look complete. */
static void report_unread(struct program *program, const char *path)
{
	if (program->run->options->format != FORMAT_TEXT)
		return;
	strbuf_addf(&program->text, "%s: incomplete: the program could not be opened\n", path);
	output_text(program->run->out, &program->text);
	output_flush(program->run->out);
	strbuf_release(&program->text);
}

/* Likely a setup that lacks its option. */
static bool is_xml_name(const char *path)
{
	size_t length = strlen(path);

	return length > 4 && !strcasecmp(path + length - 4, ".xml");
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

enum run_status program_check(struct program_run *run, const char *path)
{
	struct diag *diag = &run->console->diag;
	size_t errors = diag->errors;
	struct check_stats stats = {0};
	struct program program = {.run = run};
	const struct check_sink sink = {&program, on_finding, on_progress};
	struct program_file file;
	enum check_result result;
	double *proven = NULL;

	if (!program_open(&file, path, diag)) {
		stats_sum(&run->stats, &stats, CHECK_INCOMPLETE);
		report_unread(&program, path);
		return RUN_INCOMPLETE;
	}
	program.name = file.name;
	if (run->options->verbose)
		proven = mem_zalloc(run->scene->pair_count, sizeof(*proven));
	result = check_run(run->scene, &run->options->check, file.stream, file.name, &sink, diag, &stats, proven);
	console_clear(run->console);
	if ((!program_close(&file, diag) || diag->errors > errors) && result != CHECK_INCOMPLETE)
		result = CHECK_INCOMPLETE;
	stats_sum(&run->stats, &stats, result);
	if (result == CHECK_INCOMPLETE && is_xml_name(path))
		diag_note(diag, nowhere, "%s was read as an NC program; a setup is given with --setup", path);
	report(&program,
	       &(struct verdict){file.name, result, &run->options->check, &stats, run->scene, program.first_line,
				 program.first_file},
	       proven);
	free(proven);
	free(program.first_file);
	strbuf_release(&program.text);
	if (result == CHECK_INCOMPLETE && diag->errors == errors && !run->out->error) {
		diag_error(diag, nowhere, "internal error: the check of %s broke off and nobody said why", file.name);
		return RUN_INTERNAL;
	}
	return status_of(result);
}
