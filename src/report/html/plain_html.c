#include "report/html/plain_html.h"

#include <string.h>

#include "report/format/base64.h"
#include "report/format/format_units.h"
#include "report/format/html_text.h"
#include "report/format/json.h"
#include "report/html/viewer.h"
#include "report/sensitivity_report.h"
#include "report/verdict.h"

/* ------------------------------------------------------------------- head */

static int value_of(char digit)
{
	return digit <= '9' ? digit - '0' : digit - 'a' + 10;
}

/* 'sha256-...' of a style or a script, as written in a policy. */
static void add_hash(struct strbuf *out, struct viewer_file file)
{
	char digest[DIGEST_SIZE];
	unsigned char bytes[(DIGEST_SIZE - 1) / 2];

	digest_bytes(digest, file.bytes, file.count);
	for (size_t i = 0; i < sizeof(bytes); i++)
		bytes[i] = (unsigned char)(16 * value_of(digest[2 * i]) + value_of(digest[2 * i + 1]));
	strbuf_addf(out, " 'sha256-");
	base64_add(out, bytes, sizeof(bytes));
	strbuf_addf(out, "'");
}

void plain_html_add_head(struct strbuf *out, const char *title, bool scripts)
{
	const struct viewer_file style = viewer_style();

	strbuf_addf(out, "<!doctype html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n"
			 "<meta name=\"viewport\" content=\"width=device-width,initial-scale=1\">\n"
			 "<meta name=\"generator\" content=\"fivecheck " FIVECHECK_VERSION "\">\n"
			 "<meta http-equiv=\"Content-Security-Policy\" content=\"default-src 'none'; base-uri 'none'; "
			 "form-action 'none'; img-src data:; style-src");
	add_hash(out, style);
	if (scripts) {
		strbuf_addf(out, "; script-src");
		add_hash(out, viewer_boot_script());
		add_hash(out, viewer_script());
	}
	strbuf_addf(out, "\">\n<title>");
	html_text_add(out, title);
	strbuf_addf(out, "</title>\n<style>");
	strbuf_add(out, style.bytes, style.count);
	strbuf_addf(out, "</style>\n</head>\n<body>\n");
}

/* ------------------------------------------------------------------- main */

static void add_element(struct strbuf *out, const char *element, const char *text)
{
	strbuf_addf(out, "<%s>", element);
	html_text_add(out, text);
	strbuf_addf(out, "</%s>", element);
}

static void add_axes(struct strbuf *out, const struct machine *machine, const axis_values *axes)
{
	struct strbuf text = {0};

	format_units_add_axes(&text, machine, axes);
	add_element(out, "td", strbuf_text(&text));
	strbuf_release(&text);
}

static void add_finding(struct strbuf *out, const struct machine *machine, const struct recorded_finding *finding)
{
	static const char *const statuses[] = {
		[FINDING_FAILS] = "", [FINDING_WAIVED] = "waived: ", [FINDING_LEFT_OUT] = "does not fail the run: ",
	};
	struct strbuf text = {0};
	const json_t *calls = json_object_get(finding->object, "callers");

	strbuf_addf(&text, "%s:%ld", finding->file, finding->line);
	for (size_t i = 0; i < json_array_size(calls); i++) {
		const json_t *call = json_array_get(calls, i);

		strbuf_addf(&text, ", called from %s:%" JSON_INTEGER_FORMAT,
			    json_string_value(json_object_get(call, "file")),
			    json_integer_value(json_object_get(call, "line")));
	}
	strbuf_addf(out, "<tr>");
	add_element(out, "td", strbuf_text(&text));
	add_element(out, "td", finding_kind_name(finding->kind));
	strbuf_clear(&text);
	strbuf_addf(&text, "%s%s", statuses[finding->status], finding->message);
	add_element(out, "td", strbuf_text(&text));
	strbuf_addf(out, "<td><code>");
	html_text_add(out, finding->text);
	strbuf_addf(out, "</code></td>");
	add_axes(out, machine, &finding->axes);
	strbuf_clear(&text);
	format_units_add_duration(&text, finding->time);
	add_element(out, "td", strbuf_text(&text));
	strbuf_addf(out, "</tr>\n");
	strbuf_release(&text);
}

static void add_findings(struct strbuf *out, const struct html_contents *report)
{
	const struct recorder *recorder = report->recorder;

	if (!recorder->findings.count)
		return;
	strbuf_addf(out, "<h2>Findings</h2>\n<table>\n<tr><th>Place</th><th>Kind</th><th>What happens</th>"
			 "<th>Block</th><th>Axes</th><th>Time</th></tr>\n");
	for (size_t i = 0; i < recorder->findings.count; i++)
		add_finding(out, report->run->scene->machine, &recorder->findings.items[i]);
	strbuf_addf(out, "</table>\n");
	if (recorder->findings.left_out)
		strbuf_addf(out, "<p>%ld more findings are not listed here.</p>\n", recorder->findings.left_out);
}

static void add_errors(struct strbuf *out, const struct report_program *program)
{
	if (!program->error_count)
		return;
	strbuf_addf(out, "<h2>Errors</h2>\n<ul>\n");
	for (size_t i = 0; i < program->error_count; i++) {
		const struct report_error *error = &program->errors[i];
		struct strbuf text = {0};

		if (error->file)
			strbuf_addf(&text, "%s:%ld: ", error->file, error->line);
		strbuf_addf(&text, "%s", error->text);
		add_element(out, "li", strbuf_text(&text));
		strbuf_release(&text);
	}
	strbuf_addf(out, "</ul>\n");
}

static void add_files(struct strbuf *out, const struct html_contents *report)
{
	strbuf_addf(out, "<h2>Files</h2>\n<table>\n<tr><th>Kind</th><th>File</th><th>SHA-256</th></tr>\n");
	for (size_t i = 0; i < report->file_count; i++) {
		strbuf_addf(out, "<tr>");
		add_element(out, "td", report->files[i].kind);
		add_element(out, "td", report->files[i].path);
		strbuf_addf(out, "<td><code>%s</code></td></tr>\n",
			    report->files[i].digest[0] ? report->files[i].digest : "unknown");
	}
	strbuf_addf(out, "</table>\n");
}

static void push_row(json_t *rows, const char *name, struct strbuf *text)
{
	json_t *row = json_array();

	json_push(row, json_string(name));
	json_push(row, json_text(strbuf_text(text)));
	json_push(rows, row);
	strbuf_clear(text);
}

json_t *plain_html_statistics(const struct html_contents *report)
{
	const struct verdict *verdict = report->program->verdict;
	json_t *rows = json_array();
	struct strbuf text = {0};

	if (!verdict)
		return rows;
	strbuf_addf(&text, "%ld", verdict->stats->motion.blocks);
	push_row(rows, "blocks read", &text);
	strbuf_addf(&text, "%ld", verdict->stats->motion.spans);
	push_row(rows, "straight pieces of motion", &text);
	format_units_add_duration(&text, verdict->stats->motion.seconds);
	push_row(rows, "machining time", &text);
	strbuf_addf(&text, "%zu", verdict->stats->pairs_required);
	push_row(rows, "pairs of bodies checked", &text);
	strbuf_addf(&text, "%zu", verdict->stats->pairs_excused);
	push_row(rows, "pairs of neighbours excused, not proved", &text);
	strbuf_addf(&text, "%zu", verdict->stats->pairs_skipped);
	push_row(rows, "pairs that need no check", &text);
	strbuf_addf(&text, "%.10g mm", verdict->options->tolerance);
	push_row(rows, "tolerance", &text);
	strbuf_addf(&text, "%.10g mm", report->run->clearance);
	push_row(rows, "clearance that bodies must keep", &text);
	strbuf_release(&text);
	return rows;
}

static void add_statistics(struct strbuf *out, const struct html_contents *report)
{
	json_t *rows = plain_html_statistics(report);

	strbuf_addf(out, "<h2>Check</h2>\n<table>\n");
	for (size_t i = 0; i < json_array_size(rows); i++) {
		const json_t *row = json_array_get(rows, i);

		strbuf_addf(out, "<tr>");
		add_element(out, "th", json_string_value(json_array_get(row, 0)));
		add_element(out, "td", json_string_value(json_array_get(row, 1)));
		strbuf_addf(out, "</tr>\n");
	}
	strbuf_addf(out, "</table>\n");
	json_decref(rows);
}

/* The results of --sensitivity, as in the text report. */
static void add_sensitivity(struct strbuf *out, const struct report_program *program)
{
	struct strbuf text = {0};

	if (!program->sensitivity_count || !program->verdict)
		return;
	sensitivity_report_text(&text, program->sensitivity, program->sensitivity_count,
				program->verdict->result == CHECK_CLEAR);
	strbuf_addf(out, "<h2>Setup that is off</h2>\n");
	add_element(out, "pre", strbuf_text(&text));
	strbuf_addf(out, "\n");
	strbuf_release(&text);
}

static void add_cautions(struct strbuf *out, const struct verdict *verdict)
{
	for (int i = 0; i < VERDICT_CAUTIONS; i++) {
		struct strbuf text = {0};

		if (verdict_add_caution(&text, verdict, i)) {
			add_element(out, "p", strbuf_text(&text));
			strbuf_addf(out, "\n");
		}
		strbuf_release(&text);
	}
}

static void add_verdict_sentence(struct strbuf *text, const struct report_program *program)
{
	if (program->verdict)
		verdict_add_sentence(text, program->verdict);
	else
		strbuf_addf(text, "incomplete: %s", program->unread);
}

static void add_verdict(struct strbuf *out, const struct report_program *program)
{
	struct strbuf text = {0};

	add_verdict_sentence(&text, program);
	strbuf_addf(out, "<p><b>");
	html_text_add(out, program->name);
	strbuf_addf(out, ": ");
	html_text_add(out, strbuf_text(&text));
	strbuf_addf(out, "</b></p>\n");
	strbuf_release(&text);
	if (program->verdict)
		add_cautions(out, program->verdict);
	if (program->failing_warning) {
		strbuf_addf(out, "<p>This warning fails the run: ");
		html_text_add(out, program->failing_warning);
		strbuf_addf(out, "</p>\n");
	}
}

/* The verdict in a few words; the sentence with all its numbers follows. */
static const char *headline(const struct report_program *program)
{
	static const char *const lines[][2] = {
		{"clear", "Clear: the machine does not hit itself"},
		{"passed", "Passed: nothing was found, which is no proof"},
		{"incomplete", "Incomplete: this program is not proved"},
	};
	const char *word = verdict_word(program->verdict);

	for (size_t i = 0; i < sizeof(lines) / sizeof(*lines); i++) {
		if (!strcmp(word, lines[i][0]))
			return lines[i][1];
	}
	return word;
}

/* The first event in a sentence; without a finding the verdict. */
static void add_heading(struct strbuf *out, const struct html_contents *report, const struct recorded_finding *first)
{
	static const char *const kinds[FINDING_KINDS] = {
		[FINDING_COLLISION] = "Collision", [FINDING_CLEARANCE] = "Too little clearance",
		[FINDING_LIMIT] = "Axis limit", [FINDING_START_OVERLAP] = "Overlap at the start",
		[FINDING_RAPID_CONTACT] = "Contact while not cutting", [FINDING_GOUGE] = "Gouge",
	};
	struct strbuf text = {0};

	if (!first) {
		strbuf_addf(&text, "%s", headline(report->program));
	} else {
		strbuf_addf(&text, "%s in line %ld", kinds[first->kind], first->line);
		if (strcmp(first->file, report->program->name) != 0)
			strbuf_addf(&text, " of %s", first->file);
		strbuf_addf(&text, ": %s", first->message);
	}
	add_element(out, "h1", strbuf_text(&text));
	strbuf_addf(out, "\n");
	strbuf_release(&text);
}

void plain_html_add_main(struct strbuf *out, const struct html_contents *report)
{
	const struct recorded_finding *first = recorded_findings_first(&report->recorder->findings);

	strbuf_addf(out, "<main id=\"plain\">\n");
	add_heading(out, report, first);
	add_verdict(out, report->program);
	if (report->picture) {
		strbuf_addf(out, "<figure>\n");
		strbuf_add(out, strbuf_text(report->picture), report->picture->length);
		strbuf_addf(out, "</figure>\n");
	}
	add_errors(out, report->program);
	add_findings(out, report);
	add_sensitivity(out, report->program);
	add_statistics(out, report);
	add_files(out, report);
	strbuf_addf(out, "<p>Made by fivecheck " FIVECHECK_VERSION ". Meshes are drawn to %.3f mm; the proof is about "
			 "the numbers of the STL files.", report->scene->accuracy);
	stock_pack_add_text(report->stock, out);
	strbuf_addf(out, "</p>\n</main>\n");
}
