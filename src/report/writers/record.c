/* record.c - what was checked, with which files and options, and the verdicts: for an audit. */
#include "report/writers/writers.h"

#include <stdlib.h>
#include <string.h>

#include "report/format/digest.h"
#include "report/format/json.h"
#include "report/writers/ndjson.h"

enum { RECORD_FORMAT = 1 };

/* All options that can change a verdict or the exit status. */
static json_t *options_of(const struct report_run *run)
{
	json_t *object = json_object();

	ndjson_put_options(object, run);
	json_put(object, "fail_on_warnings", json_boolean(run->fail_on_warnings));
	json_put(object, "shard", json_shard(run->shard, run->shards, run->options->shards > 0));
	/* On another day other waivers are expired. */
	json_put(object, "waivers_on", run->waiving->file ? json_string(run->waiving->today) : json_null());
	return object;
}

static void add_nothing(struct strbuf *out, const struct report_run *run)
{
	(void)out;
	(void)run;
}

static void add_finding(struct strbuf *out, const struct report_run *run, const struct finding *finding,
			struct finding_style style)
{
	(void)out;
	(void)run;
	(void)finding;
	(void)style;
}

/* The number of proved blocks: 0 unless the program is clear. */
static long proved(const struct verdict *verdict)
{
	bool all = verdict && verdict->result == CHECK_CLEAR && verdict->options->method == CHECK_CERTIFIED;

	return all ? verdict->stats->blocks_checked : 0;
}

static void add_program(struct strbuf *out, const struct report_run *run, const struct report_program *program)
{
	const struct verdict *verdict = program->verdict;
	json_t *object = json_object();

	(void)run;
	json_put(object, "file", json_text(program->name));
	json_put(object, "verdict", json_string(verdict_word(verdict)));
	json_put(object, "blocks_proved", json_integer(proved(verdict)));
	json_put(object, "findings", json_integer(verdict ? verdict->stats->findings : 0));
	json_put(object, "waived", json_integer(verdict ? verdict->waived : 0));
	json_put(object, "pairs_required", json_integer(verdict ? (json_int_t)verdict->stats->pairs_required : 0));
	json_put(object, "cautions", ndjson_cautions(verdict));
	json_add_line(out, object);
}

static json_t *programs_of(const struct strbuf *items)
{
	json_t *array = json_array();
	const char *line = strbuf_text(items);

	for (const char *end; (end = strchr(line, '\n')); line = end + 1)
		json_push(array, json_loadb(line, (size_t)(end - line), 0, NULL));
	return array;
}

static void add_end(struct strbuf *out, const struct report_run *run, const struct report_end *end,
		    const struct strbuf *items)
{
	json_t *object = json_object(), *options = options_of(run);
	char *text = json_dumps(options, JSON_COMPACT | JSON_REAL_PRECISION(12));
	char digest[DIGEST_SIZE];

	digest_bytes(digest, text, strlen(text));
	free(text);
	json_put(object, "record", json_integer(RECORD_FORMAT));
	json_put(object, "fivecheck", json_string(FIVECHECK_VERSION));
	json_put(object, "status", json_integer(end->status));
	json_put(object, "options", options);
	json_put(object, "options_sha256", json_string(digest));
	json_put(object, "files", ndjson_files(end->files, end->file_count));
	json_put(object, "programs", programs_of(items));
	text = json_dumps(object, JSON_INDENT(2) | JSON_REAL_PRECISION(12));
	strbuf_addf(out, "%s\n", text);
	free(text);
	json_decref(object);
}

/*
 * One JSON object: version, options, every file that was read with its SHA-256, and the verdict of every program. It
 * contains no time, computer or number of threads: the same inputs give the same bytes.
 */
const struct report_writer record_writer = {
	.name = "record", .collects = true, .begin = add_nothing, .finding = add_finding, .program = add_program,
	.end = add_end,
};
