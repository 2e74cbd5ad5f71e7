/* sarif.c - results as SARIF 2.1.0, which code hosts show at the lines of a change. */
#include "report/writers/writers.h"

#include <string.h>

#include "base/utf8.h"
#include "report/format/json.h"
#include "report/format/uri.h"
#include "report/topics.h"
#include "report/writers/ndjson.h"
#include "report/writers/text.h"

/* The rules are the first topics. Their identifiers never change between versions. */
enum { RULE_INCOMPLETE = TOPIC_INCOMPLETE, RULE_CAUTION = TOPIC_CAUTION, RULE_COUNT = TOPIC_CAUTION + 1 };

static json_t *message_of(const char *text)
{
	json_t *message = json_object();

	json_put(message, "text", json_text(text));
	return message;
}

static json_t *rules_of(void)
{
	json_t *array = json_array();

	for (int i = 0; i < RULE_COUNT; i++) {
		json_t *rule = json_object(), *level = json_object();
		struct strbuf help = {0};

		strbuf_addf(&help, "%s %s", topics[i].meaning, topics[i].advice);
		json_put(level, "level", json_string(i == RULE_CAUTION ? "note" : "error"));
		json_put(rule, "id", json_string(topic_names[i]));
		json_put(rule, "name", json_string(topics[i].rule));
		json_put(rule, "shortDescription", message_of(topics[i].brief));
		json_put(rule, "fullDescription", message_of(topics[i].meaning));
		json_put(rule, "help", message_of(strbuf_text(&help)));
		json_put(rule, "defaultConfiguration", level);
		json_push(array, rule);
		strbuf_release(&help);
	}
	return array;
}

/* Everything of the run before its results, which follow one by one. */
static void add_begin(struct strbuf *out, const struct report_run *run)
{
	json_t *tool = json_object(), *driver = json_object();

	(void)run;
	json_put(driver, "name", json_string("fivecheck"));
	json_put(driver, "semanticVersion", json_string(FIVECHECK_VERSION));
	json_put(driver, "rules", rules_of());
	json_put(tool, "driver", driver);
	strbuf_addf(out, "{\"$schema\":\"https://docs.oasis-open.org/sarif/sarif/v2.1.0/errata01/os/schemas/"
			 "sarif-schema-2.1.0.json\",\"version\":\"2.1.0\",\"runs\":[{"
			 "\"columnKind\":\"utf16CodeUnits\",\n"
			 "\"tool\":");
	json_add_line(out, tool);
	strbuf_addf(out, ",\"results\":[\n");
}

/* line 0: the file without a region; end 0: the column without its end. */
static json_t *location_of(const char *file, long line, size_t column, size_t end, const char *snippet)
{
	json_t *location = json_object(), *physical = json_object(), *artifact = json_object(), *region = json_object();
	struct strbuf uri = {0};

	uri_add(&uri, file);
	json_put(artifact, "uri", json_text(strbuf_text(&uri)));
	json_put(physical, "artifactLocation", artifact);
	if (line) {
		json_put(region, "startLine", json_integer(line));
		if (column)
			json_put(region, "startColumn", json_integer((json_int_t)column));
		if (end > column)
			json_put(region, "endColumn", json_integer((json_int_t)end));
		if (snippet)
			json_put(region, "snippet", message_of(snippet));
		json_put(physical, "region", json_incref(region));
	}
	json_decref(region);
	json_put(location, "physicalLocation", physical);
	strbuf_release(&uri);
	return location;
}

static json_t *suppressions_of(const char *reason)
{
	json_t *array = json_array(), *object = json_object();

	json_put(object, "kind", json_string("external"));
	json_put(object, "justification", json_text(reason));
	json_push(array, object);
	return array;
}

static void add_suppression(json_t *result, struct finding_style style)
{
	struct strbuf reason = {0};

	waiver_match_add_reason(&reason, style.waiver);
	json_put(result, "suppressions", suppressions_of(strbuf_text(&reason)));
	strbuf_release(&reason);
}

static const char *level_of(int rule, struct finding_style style)
{
	if (rule == RULE_CAUTION)
		return "note";
	return style.status == FINDING_LEFT_OUT ? "warning" : "error";
}

/* One result. `related` and `properties` may be NULL. */
static void add_result(struct strbuf *out, int rule, struct finding_style style, const char *text, json_t *location,
		       json_t *related, json_t *properties)
{
	json_t *result = json_object(), *locations = json_array();

	json_put(result, "ruleId", json_string(topic_names[rule]));
	json_put(result, "ruleIndex", json_integer(rule));
	json_put(result, "level", json_string(level_of(rule, style)));
	json_put(result, "message", message_of(text));
	json_push(locations, location);
	json_put(result, "locations", locations);
	if (related)
		json_put(result, "relatedLocations", related);
	if (properties)
		json_put(result, "properties", properties);
	if (style.status == FINDING_WAIVED)
		add_suppression(result, style);
	json_add_line(out, result);
}

/* NULL: the block is in the program itself. */
static json_t *callers_of(const struct finding *f)
{
	json_t *array = f->caller_count ? json_array() : NULL;

	for (size_t i = 0; i < f->caller_count; i++) {
		json_t *location = location_of(f->callers[i].file, f->callers[i].line, 0, 0, NULL);

		json_put(location, "id", json_integer((json_int_t)i));
		json_put(location, "message", message_of("called from here"));
		json_push(array, location);
	}
	return array;
}

static json_t *properties_of(const struct machine *machine, const struct finding *f)
{
	json_t *object = json_object();

	json_put(object, "move", json_integer(f->move));
	json_put(object, "fraction", json_real(f->fraction));
	json_put(object, "time", json_real(f->time));
	json_put(object, "axes", json_axes(machine, &f->axes));
	if (f->kind != FINDING_LIMIT) {
		const struct pair_finding *pair = &f->of.pair;

		json_put(object, "a", json_text(pair->a));
		json_put(object, "b", json_text(pair->b));
		json_put(object, "point", json_point(pair->point));
		json_put(object, "clearance", json_real(pair->clearance));
		if (pair->path_displacement > 0)
			json_put(object, "path_tolerance", json_real(pair->path_displacement));
		if (pair->with_stock)
			json_put(object, "certain", json_boolean(pair->certain));
	} else {
		ndjson_put_limit(object, &f->of.limit);
	}
	return object;
}

static void add_finding(struct strbuf *out, const struct report_run *run, const struct finding *f,
			struct finding_style style)
{
	const struct machine *machine = run->scene->machine;
	struct strbuf text = {0}, block = {0};
	const char *line = f->text ? f->text : "";

	strbuf_add(&block, line, strcspn(line, "\r\n"));
	text_sentence(&text, f);
	/* The region is the block, from its column to the end of its line. */
	add_result(out, (int)f->kind, style, strbuf_text(&text),
		   location_of(f->file, f->line, (size_t)f->column, utf8_units(strbuf_text(&block)) + 1,
			       strbuf_text(&block)),
		   callers_of(f), properties_of(machine, f));
	strbuf_release(&text);
	strbuf_release(&block);
}

/* A column counts bytes; SARIF requires UTF-16 units, which need the text of the line. Without the line: no column. */
static json_t *location_of_error(const struct report_program *program, const struct report_error *error)
{
	const char *file = error->file ? error->file : program->name;
	struct strbuf before = {0};
	json_t *location;

	if (!error->excerpt || !error->column || strlen(error->excerpt) < (size_t)error->column - 1)
		return location_of(file, error->line, 0, 0, NULL);
	strbuf_add(&before, error->excerpt, (size_t)error->column - 1);
	location = location_of(file, error->line, utf8_units(strbuf_text(&before)) + 1,
			       utf8_units(error->excerpt) + 1, error->excerpt);
	strbuf_release(&before);
	return location;
}

static json_t *properties_of_caution(const char *name)
{
	json_t *object = json_object();

	json_put(object, "caution", json_string(name));
	return object;
}

static void add_program(struct strbuf *out, const struct report_run *run, const struct report_program *program)
{
	(void)run;
	for (size_t i = 0; i < program->error_count; i++)
		add_result(out, RULE_INCOMPLETE, (struct finding_style){0}, program->errors[i].text,
			   location_of_error(program, &program->errors[i]), NULL, NULL);
	for (int i = 0; program->verdict && i < VERDICT_CAUTIONS; i++) {
		struct strbuf text = {0};
		const int name = TOPIC_CAUTIONS + (i < CAUTION_DOUBT ? i : CAUTION_DOUBT);

		if (verdict_add_caution(&text, program->verdict, i))
			add_result(out, RULE_CAUTION, (struct finding_style){0}, strbuf_text(&text),
				   location_of(program->name, 0, 0, 0, NULL), NULL,
				   properties_of_caution(topic_names[name]));
		strbuf_release(&text);
	}
}

static void add_end(struct strbuf *out, const struct report_run *run, const struct report_end *end,
		    const struct strbuf *items)
{
	json_t *array = json_array(), *invocation = json_object();

	(void)run;
	(void)items;
	json_put(invocation, "executionSuccessful", json_boolean(end->status <= 1));
	json_put(invocation, "exitCode", json_integer(end->status));
	json_push(array, invocation);
	strbuf_addf(out, "],\"invocations\":");
	json_add_line(out, array);
	strbuf_addf(out, "}]}\n");
}

/*
 * One run. The rules are the kinds of findings, and "incomplete" for errors. Locations are relative to the current
 * folder if possible; columns count UTF-16 code units. Source: OASIS, "Static Analysis Results Interchange Format
 * (SARIF) Version 2.1.0".
 */
const struct report_writer sarif_writer = {
	.name = "sarif", .mark = "{\"$schema\":\"https://docs.oasis-open.org/sarif/",
	.separator = ",", .begin = add_begin, .finding = add_finding, .program = add_program,
	.end = add_end,
};
