#include "cli/failure_report.h"

#include <stdio.h>
#include <string.h>
#include <sys/stat.h>

#include "machine/machine.h"
#include "machine/setup.h"
#include "report/tables/stats.h"

static const char *const reasons[] = {
	[FAILURE_OF_INPUT] = "there is an error in the machine file, the setup, or a file that they use",
	[FAILURE_OF_OUTPUT] = "a file beside the results cannot be written",
};

/* May the file of the sink be replaced? Yes if it does not exist, is empty, or was written by the same writer. */
static bool is_replaceable(const struct sink *sink)
{
	const char *mark = sink->writer->mark;
	size_t length = mark ? strlen(mark) : 0, count;
	char begin[64];
	struct stat status;
	FILE *file;

	if (!sink->path || stat(sink->path, &status) || !S_ISREG(status.st_mode) || !status.st_size)
		return true;
	file = mark ? fopen(sink->path, "rb") : NULL;
	if (!file)
		return false;
	count = fread(begin, 1, length < sizeof(begin) ? length : sizeof(begin), file);
	fclose(file);
	return count == length && !memcmp(begin, mark, length);
}

static void drop_channels(struct sinks *sinks, struct diag *diag)
{
	size_t kept = 0;

	for (size_t i = 0; i < sinks->count; i++) {
		struct sink *sink = &sinks->items[i];

		/* A record lists what was checked; nothing was checked. */
		if (sink->writer == report_writers[FORMAT_RECORD] || !is_replaceable(sink)) {
			diag_note(diag, (struct srcloc){0}, "%s was left unchanged: nothing was checked", sink->path);
			output_discard(&sink->out);
		} else if (kept++ < i) {
			sinks->items[kept - 1] = *sink;
		}
	}
	sinks->count = kept;
}

/* The first program gets the errors; the others only say that nothing was checked. */
static void tell_program(struct sinks *sinks, const struct report_run *run, const char *name, const char *why,
			 const struct error_list *errors)
{
	char text[128];
	const struct report_error one = {.text = text};
	const struct report_program about = {
		.name = strcmp(name, "-") ? name : "<stdin>", .unread = why, .waived = "", .first_kind = -1,
		.errors = errors ? errors->items : &one, .error_count = errors ? errors->count : 1,
	};
	struct strbuf out = {0};

	snprintf(text, sizeof(text), "not checked: %s", why);
	for (size_t i = 0; i < sinks->count; i++) {
		sinks->items[i].writer->program(&out, run, &about);
		sink_write(&sinks->items[i], &out);
	}
	strbuf_release(&out);
}

bool failure_report_write(const struct options *options, enum failure_place place, const struct error_list *errors,
			  struct sinks *sinks, struct diag *diag)
{
	const struct machine machine = {.path = options->machine};
	const struct setup setup = {.path = options->setup};
	struct scene scene = {.machine = &machine, .setup = options->setup ? &setup : NULL};
	const struct waiver_match waiving = {0};
	const struct report_run run = {
	    .scene = &scene,
	    .options = &options->check,
	    .clearance = options->clearance,
	    .programs = options->program_count,
	    .fail_on = options->fail_on,
	    .fail_on_warnings = options->fail_on_warnings,
	    .quiet = true,
	    .waiving = &waiving,
	    .shard = options->shard,
	    .shards = options->shards,
	};
	const struct run_stats sums = {.programs = options->program_count, .incomplete = options->program_count};
	struct report_end end = {.sums = &sums, .status = 2};

	drop_channels(sinks, diag);
	sinks_begin(sinks, &run);
	for (size_t i = 0; i < options->program_count; i++)
		tell_program(sinks, &run, options->programs[i], reasons[place], i ? NULL : errors);
	sinks_end(sinks, &run, &end);
	return sinks_commit(sinks, diag);
}
