#include "report/writers/ndjson.h"

#include <stdbool.h>
#include <string.h>

#include "control/dialects.h"
#include "geom/tolerance.h"
#include "report/format/format_units.h"
#include "report/format/json.h"
#include "report/sensitivity_report.h"
#include "report/writers/writers.h"

/* "certified", "interpolated", "conventional", "parse-only" */
static const char *method_name(enum check_method method)
{
	static const char *const methods[] = {
		[CHECK_CERTIFIED] = "certified", [CHECK_INTERPOLATED] = "interpolated",
		[CHECK_CONVENTIONAL] = "conventional", [CHECK_NOTHING] = "parse-only",
	};

	return methods[method];
}

void ndjson_put_options(json_t *object, const struct report_run *run)
{
	const struct check_options *options = run->options;
	json_t *includes = json_array(), *kinds = json_array();

	for (size_t i = 0; i < options->read.include_count; i++)
		json_push(includes, json_text(options->read.includes[i]));
	for (int kind = 0; kind < FINDING_KINDS; kind++) {
		if (!run->fail_on || run->fail_on & 1U << kind)
			json_push(kinds, json_string(finding_kind_names[kind]));
	}
	json_put(object, "method", json_string(method_name(options->method)));
	json_put(object, "step", json_real(options->step));
	json_put(object, "tolerance", json_real(options->tolerance));
	json_put(object, "stock_tolerance",
		 json_real(options->stock_tolerance > 0 ? options->stock_tolerance : STOCK_TOLERANCE));
	json_put(object, "clearance", json_real(run->clearance));
	json_put(object, "all", json_boolean(options->all));
	json_put(object, "dialect", json_string(dialect_names[run->scene->machine->controller.dialect]));
	json_put(object, "block_delete", json_boolean(options->read.block_delete));
	json_put(object, "duplicates", json_string(options->read.last_duplicate_wins ? "last" : "error"));
	json_put(object, "include", includes);
	json_put(object, "max_blocks", options->read.max_blocks ? json_integer(options->read.max_blocks) : json_null());
	json_put(object, "fail_on", kinds);
}

json_t *ndjson_files(const struct report_file *files, size_t count)
{
	json_t *array = json_array();

	for (size_t i = 0; i < count; i++) {
		json_t *object = json_object();

		json_put(object, "kind", json_string(files[i].kind));
		json_put(object, "file", json_text(files[i].path));
		json_put(object, "sha256", files[i].digest[0] ? json_string(files[i].digest) : json_null());
		json_push(array, object);
	}
	return array;
}

static void add_header(struct strbuf *out, const struct report_run *run)
{
	const char *list = run->program_list;
	json_t *object = json_object();

	json_put(object, "kind", json_string("header"));
	json_put(object, "format", json_integer(NDJSON_FORMAT));
	json_put(object, "fivecheck", json_string(FIVECHECK_VERSION));
	json_put(object, "machine", json_text(run->scene->machine->path));
	json_put(object, "setup", json_text(run->scene->setup ? run->scene->setup->path : NULL));
	ndjson_put_options(object, run);
	json_put(object, "programs", json_integer((json_int_t)run->programs));
	json_put(object, "shard", json_shard(run->shard, run->shards, run->options->shards > 0));
	json_put(object, "program_list", list && *list ? json_string(list) : json_null());
	json_put(object, "files", ndjson_files(run->files, run->file_count));
	json_add_line(out, object);
}

static const char *const accepted[] = {
		[FINDING_FAILS] = NULL,
		[FINDING_WAIVED] = "waiver",
		[FINDING_LEFT_OUT] = "fail-on",
};

void ndjson_put_limit(json_t *object, const struct travel_excess *limit)
{
	const char axis[2] = {AXIS_LETTERS[limit->slot], '\0'};
	const bool offset = limit->work_offset != NULL;

	json_put(object, "axis", json_string(axis));
	json_put(object, "bound", json_real(format_units_value(limit->slot, limit->bound)));
	json_put(object, "target", json_real(format_units_value(limit->slot, limit->target)));
	json_put(object, "excess", json_real(format_units_value(limit->slot, limit->excess)));
	if (limit->path_tolerance > 0)
		json_put(object, "path_tolerance", json_real(format_units_value(limit->slot, limit->path_tolerance)));
	json_put(object, "work_offset", json_text(limit->work_offset));
	json_put(object, "work", offset ? json_real(format_units_value(limit->slot, limit->work)) : json_null());
	json_put(object, "shift", offset ? json_real(format_units_value(limit->slot, limit->shift)) : json_null());
	json_put(object, "tool_length", offset && limit->length_acts ? json_real(limit->length) : json_null());
}

static json_t *callers_of(const struct finding *f)
{
	json_t *array = json_array();

	for (size_t i = 0; i < f->caller_count; i++) {
		json_t *object = json_object();

		json_put(object, "file", json_text(f->callers[i].file));
		json_put(object, "line", json_integer(f->callers[i].line));
		json_put(object, "column", json_integer(f->callers[i].column));
		json_push(array, object);
	}
	return array;
}

json_t *ndjson_finding_object(const struct machine *machine, const struct finding *f, struct finding_style style)
{
	const struct pair_finding *pair = f->kind == FINDING_LIMIT ? NULL : &f->of.pair;
	json_t *object = json_object();

	json_put(object, "kind", json_string(finding_kind_name(f->kind)));
	json_put(object, "file", json_text(f->file));
	json_put(object, "line", json_integer(f->line));
	json_put(object, "column", json_integer(f->column));
	json_put(object, "move", json_integer(f->move));
	json_put(object, "fraction", json_real(f->fraction));
	json_put(object, "a", json_text(pair ? pair->a : NULL));
	json_put(object, "b", json_text(pair ? pair->b : NULL));
	json_put(object, "axes", json_axes(machine, &f->axes));
	json_put(object, "time", json_real(f->time));
	json_put(object, "point", pair ? json_point(pair->point) : json_null());
	json_put(object, "clearance", pair ? json_real(pair->clearance) : json_null());
	if (pair && (f->kind == FINDING_RAPID_CONTACT || f->kind == FINDING_GOUGE))
		json_put(object, "allowed_depth", json_real(pair->depth));
	if (pair && pair->path_displacement > 0)
		json_put(object, "path_tolerance", json_real(pair->path_displacement));
	if (pair && pair->with_stock)
		json_put(object, "certain", json_boolean(pair->certain));
	if (!pair)
		ndjson_put_limit(object, &f->of.limit);
	json_put(object, "block", json_text(f->text));
	if (f->caller_count)
		json_put(object, "callers", callers_of(f));
	if (accepted[style.status])
		json_put(object, "accepted", json_string(accepted[style.status]));
	if (style.waiver) {
		json_put(object, "reason", json_text(style.waiver->reason));
		json_put(object, "expires", json_string(style.waiver->expires));
	}
	return object;
}

void ndjson_finding(struct strbuf *out, const struct machine *machine, const struct finding *finding,
		    struct finding_style style)
{
	json_add_line(out, ndjson_finding_object(machine, finding, style));
}

static void add_finding(struct strbuf *out, const struct report_run *run, const struct finding *finding,
			struct finding_style style)
{
	ndjson_finding(out, run->scene->machine, finding, style);
}

/* All cautions, or only those that doubt an assumption of the verdict. */
static json_t *cautions_of(const struct verdict *verdict, bool doubts_alone)
{
	json_t *array = json_array();
	struct strbuf text = {0};

	for (int i = 0; verdict && i < VERDICT_CAUTIONS; i++) {
		strbuf_clear(&text);
		if ((!doubts_alone || verdict_caution_is_doubt(i)) && verdict_add_caution(&text, verdict, i))
			json_push(array, json_text(strbuf_text(&text)));
	}
	strbuf_release(&text);
	return array;
}

json_t *ndjson_cautions(const struct verdict *verdict)
{
	return cautions_of(verdict, false);
}

json_t *ndjson_doubts(const struct verdict *verdict)
{
	return cautions_of(verdict, true);
}

json_t *ndjson_errors(const struct report_program *program)
{
	json_t *array = json_array();

	for (size_t i = 0; i < program->error_count; i++) {
		const struct report_error *error = &program->errors[i];
		json_t *object = json_object();

		json_put(object, "file", json_text(error->file));
		json_put(object, "line", error->line ? json_integer(error->line) : json_null());
		json_put(object, "column", error->column ? json_integer(error->column) : json_null());
		json_put(object, "text", json_text(error->text));
		if (error->block)
			json_put(object, "block", json_integer(error->block));
		json_push(array, object);
	}
	return array;
}

static void add_program(struct strbuf *out, const struct report_run *run, const struct report_program *program)
{
	const struct check_stats *stats = program->verdict ? program->verdict->stats : NULL;
	json_t *object = json_object();

	(void)run;
	json_put(object, "kind", json_string("program"));
	json_put(object, "file", json_text(program->name));
	json_put(object, "verdict", json_string(verdict_word(program->verdict)));
	json_put(object, "blocks", json_integer(stats ? stats->motion.blocks : 0));
	json_put(object, "checked", json_integer(stats ? stats->blocks_checked : 0));
	json_put(object, "findings", json_integer(stats ? stats->findings : 0));
	json_put(object, "cautions", ndjson_cautions(program->verdict));
	json_put(object, "errors", ndjson_errors(program));
	if (program->sensitivity_count)
		json_put(object, "sensitivity",
			 sensitivity_report_json(program->sensitivity, program->sensitivity_count));
	json_add_line(out, object);
}

/* The files of subprograms are known only at the end. The files are sorted by kind. */
static const struct report_file *find_subprograms(const struct report_end *end, size_t *count)
{
	const struct report_file *first = NULL;

	*count = 0;
	for (size_t i = 0; i < end->file_count; i++) {
		if (strcmp(end->files[i].kind, "subprogram") != 0)
			continue;
		first = first ? first : &end->files[i];
		(*count)++;
	}
	return first;
}

static void add_summary(struct strbuf *out, const struct report_run *run, const struct report_end *end,
			const struct strbuf *items)
{
	const struct run_stats *sums = end->sums;
	size_t count;
	const struct report_file *subprograms = find_subprograms(end, &count);
	json_t *object = json_object();

	(void)run;
	(void)items;
	json_put(object, "kind", json_string("summary"));
	json_put(object, "status", json_integer(end->status));
	json_put(object, "programs", json_integer((json_int_t)sums->programs));
	json_put(object, "passed", json_integer((json_int_t)sums->clear));
	json_put(object, "incomplete", json_integer((json_int_t)sums->incomplete));
	json_put(object, "blocks", json_integer(sums->check.motion.blocks));
	json_put(object, "findings", json_integer(sums->check.findings));
	json_put(object, "files", ndjson_files(subprograms, count));
	json_add_line(out, object);
}

/*
 * The first line has the kind "header" and the number of this format. Findings follow as they are found, a line of kind
 * "program" after the findings of each program, and a last line of kind "summary". Without the last line the file is
 * incomplete.
 */
const struct report_writer ndjson_writer = {
	.name = "ndjson", .mark = "{\"kind\":\"header\"",
	.begin = add_header, .finding = add_finding, .program = add_program, .end = add_summary,
};
