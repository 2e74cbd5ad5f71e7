#include "report/html/html_report.h"

#include <stdlib.h>
#include <string.h>

#include "base/mem.h"
#include "report/format/format_units.h"
#include "report/format/json.h"
#include "report/html/code_windows.h"
#include "report/format/html_text.h"
#include "report/html/pack_table.h"
#include "report/html/page.h"
#include "report/html/plain_html.h"
#include "report/html/report_data.h"
#include "report/html/selection.h"
#include "report/html/viewer.h"
#include "report/sensitivity_report.h"
#include "report/writers/ndjson.h"

/* Shares of what is left of the size after what a report must have; the program's text gets the rest. */
#define PATH_SHARE 0.55
#define CLEARANCE_SHARE 0.15

/* ------------------------------------------------------------------ tables */

static int write_table(struct page *page, const int64_t *values, size_t rows, size_t columns)
{
	struct strbuf bytes = {0}, packed = {0};
	int blob;

	pack_table_add(&bytes, values, rows, columns);
	page_pack(&packed, &bytes, DEFLATE_SMALL);
	blob = page_blob(page, &packed);
	strbuf_release(&bytes);
	strbuf_release(&packed);
	return blob;
}

/* The coarse level; with `start` the first row of all comes first. */
static json_t *write_coarse(struct page *page, const struct recorded_table *table, bool start)
{
	const size_t n = table->columns, extra = start && memcmp(table->first, table->coarse, n * sizeof(int64_t)) != 0;
	const size_t rows = table->coarse_rows + extra;
	int64_t *values = mem_alloc((rows + 1) * n * sizeof(*values));
	json_t *object = json_object();

	memcpy(values, table->first, n * sizeof(*values));
	memcpy(values + extra * n, table->coarse, table->coarse_rows * n * sizeof(*values));
	json_put(object, "blob", json_integer(write_table(page, values, rows, n)));
	json_put(object, "rows", json_integer((json_int_t)rows));
	free(values);
	return object;
}

static size_t chunk_at(const struct recorded_table *table, int64_t time)
{
	size_t i = 0;

	while (i + 1 < table->chunk_count && table->chunks[i].to < time)
		i++;
	return i;
}

/* Packs chunks, those of findings first, until one does not fit. packed[i] has no text where chunk i was left out. */
static bool choose_chunks(struct recorded_table *table, const struct recorder *recorder, size_t budget, struct strbuf *packed)
{
	size_t *order = mem_alloc((table->chunk_count + 1) * sizeof(*order));
	size_t *marks = mem_alloc((recorder->finding_count + 1) * sizeof(*marks));
	size_t used = 0;

	for (size_t i = 0; i < recorder->finding_count && table->chunk_count; i++)
		marks[i] = chunk_at(table, (int64_t)(recorder->findings[i].time / RECORD_TIME));
	selection_order(order, table->chunk_count, marks, table->chunk_count ? recorder->finding_count : 0);
	for (size_t i = 0; i < table->chunk_count; i++) {
		struct strbuf bytes = {0}, *it = &packed[order[i]];

		if (recorded_table_chunk(table, order[i], &bytes))
			page_pack(it, &bytes, table->chunk_count > SHORT_CHUNKS ? DEFLATE_FAST : DEFLATE_SMALL);
		strbuf_release(&bytes);
		used += it->length;
		if (used > budget || table->error) {
			strbuf_release(it);
			break;
		}
	}
	free(order);
	free(marks);
	return !table->error;
}

static json_t *chunk_json(struct page *page, const struct recorded_chunk *chunk, const struct strbuf *packed)
{
	json_t *object = json_object();

	json_put(object, "blob", json_integer(page_blob(page, packed)));
	json_put(object, "first", json_integer(chunk->first));
	json_put(object, "rows", json_integer((json_int_t)chunk->rows));
	json_put(object, "from", json_real((double)chunk->from * RECORD_TIME));
	json_put(object, "to", json_real((double)chunk->to * RECORD_TIME));
	return object;
}

/* Writes the chunks that fit and adds what describes them. False: the temporary file failed. */
static bool write_chunks(struct page *page, struct recorded_table *table, const struct recorder *recorder, size_t budget,
			 json_t *object)
{
	struct strbuf *packed = mem_zalloc(table->chunk_count + 1, sizeof(*packed));
	json_t *chunks = json_array();
	const bool good = choose_chunks(table, recorder, budget, packed);

	for (size_t i = 0; i < table->chunk_count; i++) {
		if (packed[i].length)
			json_push(chunks, chunk_json(page, &table->chunks[i], &packed[i]));
		strbuf_release(&packed[i]);
	}
	json_put(object, "complete", json_boolean(json_array_size(chunks) == table->chunk_count));
	json_put(object, "chunks", chunks);
	free(packed);
	return good;
}

static void push_column(json_t *object, const char *name, double scale)
{
	json_push(json_object_get(object, "columns"), json_string(name));
	json_push(json_object_get(object, "scale"), json_real(scale));
}

static json_t *new_table(void)
{
	json_t *object = json_object();

	json_put(object, "columns", json_array());
	json_put(object, "scale", json_array());
	return object;
}

/* Up to where the program was checked, s. */
static double checked_until(const struct html_contents *report)
{
	const struct recorder *recorder = report->recorder;
	const struct verdict *verdict = report->program->verdict;
	const bool all = verdict && (verdict->result == CHECK_CLEAR || (verdict->result == CHECK_FOUND && verdict->options->all));

	return all ? recorder->now : recorder->checked;
}

static json_t *path_json(const struct html_contents *report)
{
	static const char *const names[] = {
		[PATH_TIME] = "time", [PATH_BLOCK] = "block", [PATH_LINE] = "line",
		[PATH_FILE] = "file", [PATH_TOOL] = "tool", [PATH_CLASS] = "class",
	};
	const struct recorder *recorder = report->recorder;
	const struct machine *machine = report->run->scene->machine;
	json_t *object = new_table(), *files = json_array();

	for (int i = 0; i < PATH_AXES; i++)
		push_column(object, names[i], i == PATH_TIME ? RECORD_TIME : 1);
	for (size_t i = 0; i < machine->axis_count; i++)
		push_column(object, machine->axes[i].name, recorder_axis_scale(&machine->axes[i]));
	for (size_t i = 0; i < recorder->file_count; i++)
		json_push(files, json_text(recorder->files[i].name));
	json_put(object, "rows", json_integer(recorder->path.rows));
	json_put(object, "files", files);
	json_put(object, "end", json_real(recorder->now));
	json_put(object, "checked", json_real(checked_until(report)));
	return object;
}

static json_t *clearance_json(const struct recorder *recorder)
{
	json_t *object = new_table();

	push_column(object, "time", RECORD_TIME);
	push_column(object, "least", RECORD_CLEARANCE);
	push_column(object, "most", RECORD_CLEARANCE);
	push_column(object, "pair", 1);
	json_put(object, "rows", json_integer(recorder->clearance.rows));
	json_put(object, "cap", json_real(recorder->cap));
	json_put(object, "start", json_real(recorder->start));
	return object;
}

static json_t *planes_json(struct page *page, const struct recorder *recorder)
{
	static const char *const names[] = {"time", "pair", "x", "y", "z", "nx", "ny", "nz", "distance"};
	json_t *object = new_table();

	for (int i = 0; i < PLANE_COLUMNS; i++)
		push_column(object, names[i],
			    i == PLANE_TIME ? RECORD_TIME : i == PLANE_PAIR ? 1 : i < PLANE_NORMAL ? RECORD_LENGTH
			    : i < PLANE_DISTANCE ? RECORD_NORMAL : RECORD_CLEARANCE);
	json_put(object, "rows", json_integer((json_int_t)recorder->plane_count));
	json_put(object, "blob", json_integer(write_table(page, recorder->planes[0], recorder->plane_count, PLANE_COLUMNS)));
	return object;
}

/* -------------------------------------------------------------------- head */

static json_t *verdict_json(const struct html_contents *report)
{
	const struct report_program *program = report->program;
	const struct verdict *verdict = program->verdict;
	const char *word = verdict_word(verdict);
	json_t *object = json_object();
	struct strbuf text = {0};

	if (verdict)
		verdict_add_sentence(&text, verdict);
	else
		strbuf_addf(&text, "incomplete: %s", program->unread);
	json_put(object, "word", json_string(word));
	json_put(object, "sentence", json_text(strbuf_text(&text)));
	json_put(object, "cautions", ndjson_cautions(verdict));
	json_put(object, "failing", json_boolean(!strcmp(word, "found") || !strcmp(word, "incomplete") || program->failing_warning));
	json_put(object, "waived", json_integer(verdict ? verdict->waived : 0));
	json_put(object, "left_out", json_integer(verdict ? verdict->left_out : 0));
	strbuf_release(&text);
	return object;
}

static json_t *triangle_json(const vec3 corners[3])
{
	json_t *array = json_array();

	for (int k = 0; k < 3; k++) {
		json_push(array, json_real(corners[k].x));
		json_push(array, json_real(corners[k].y));
		json_push(array, json_real(corners[k].z));
	}
	return array;
}

static json_t *finding_json(const struct recorded_finding *finding)
{
	json_t *object = json_deep_copy(finding->object), *bodies = NULL, *triangles = NULL;

	if (finding->a >= 0 && finding->b >= 0) {
		bodies = json_array();
		json_push(bodies, json_integer(finding->a));
		json_push(bodies, json_integer(finding->b));
		triangles = json_array();
		json_push(triangles, triangle_json(finding->triangles[0]));
		json_push(triangles, triangle_json(finding->triangles[1]));
	}
	json_put(object, "bodies", bodies ? bodies : json_null());
	json_put(object, "triangles", triangles ? triangles : json_null());
	json_put(object, "tool", json_integer(finding->tool));
	json_put(object, "block_number", json_integer(finding->block));
	json_put(object, "message", json_text(finding->message));
	return object;
}

static json_t *findings_json(const struct recorder *recorder)
{
	json_t *array = json_array();

	for (size_t i = 0; i < recorder->finding_count; i++)
		json_push(array, finding_json(&recorder->findings[i]));
	return array;
}

static json_t *options_json(const struct report_run *run)
{
	json_t *object = json_object();

	ndjson_put_options(object, run);
	return object;
}

static json_t *read_out_json(const struct machine *machine)
{
	json_t *array = json_array();

	for (int slot = 0; slot < SLOT_COUNT; slot++) {
		const struct axis *axis = machine_axis(machine, slot);

		if (axis)
			json_push(array, json_string(axis->name));
	}
	return array;
}

/* Everything but path, clearance, planes and code. Copies: threads that write reports at a time share the scene. */
static json_t *head_json(const struct html_contents *report)
{
	const struct report_run *run = report->run;
	const struct scene_pack *scene = report->scene;
	json_t *object = json_object();

	json_put(object, "report", json_integer(REPORT_DATA_VERSION));
	json_put(object, "fivecheck", json_string(FIVECHECK_VERSION));
	json_put(object, "program", json_text(report->program->name));
	json_put(object, "verdict", verdict_json(report));
	json_put(object, "errors", ndjson_errors(report->program));
	json_put(object, "files", ndjson_files(report->files, report->file_count));
	json_put(object, "options", options_json(run));
	json_put(object, "shard", json_shard(run->shard, run->shards, run->options->shards > 0));
	json_put(object, "machine", json_deep_copy(scene->machine));
	json_put(object, "read_out", read_out_json(run->scene->machine));
	json_put(object, "bodies", json_deep_copy(scene->bodies));
	json_put(object, "accuracy", json_real(scene->accuracy));
	json_put(object, "tools", json_deep_copy(scene->tools));
	json_put(object, "offsets", json_deep_copy(scene->offsets));
	json_put(object, "pairs", json_deep_copy(scene->pairs));
	json_put(object, "findings", findings_json(report->recorder));
	json_put(object, "findings_left_out", json_integer(report->recorder->findings_left_out));
	json_put(object, "statistics", plain_html_statistics(report));
	json_put(object, "sensitivity", sensitivity_report_json(report->program->sensitivity, report->program->sensitivity_count));
	return object;
}

static const char *digest_of(const struct html_contents *report, const char *path)
{
	for (size_t i = 0; i < report->file_count; i++) {
		if (!strcmp(report->files[i].path, path) && report->files[i].digest[0])
			return report->files[i].digest;
	}
	return NULL;
}

/* The text of the program and its subprograms, within the budget. */
static json_t *code_json(struct page *page, const struct html_contents *report, size_t budget)
{
	const struct recorder *recorder = report->recorder;
	long *marks = mem_alloc((recorder->finding_count + 1) * sizeof(*marks));
	json_t *object = json_object(), *files = json_array();
	bool all = true;

	for (size_t i = 0; i < recorder->file_count; i++) {
		const char *name = recorder->files[i].name, *digest = digest_of(report, name);
		json_t *file = json_object(), *windows = json_array();
		size_t count = 0;
		bool complete = false;
		long lines = -1;

		for (size_t k = 0; k < recorder->finding_count; k++) {
			if (!strcmp(recorder->findings[k].file, name))
				marks[count++] = recorder->findings[k].line;
		}
		if (!report->no_code)
			budget -= code_windows_write(page, name, marks, count, budget, windows, &lines, &complete);
		all = all && complete;
		json_put(file, "name", json_text(name));
		json_put(file, "sha256", digest ? json_string(digest) : json_null());
		json_put(file, "lines", json_integer(lines));
		json_put(file, "windows", windows);
		json_push(files, file);
	}
	json_put(object, "mode", json_string(report->no_code ? "none" : all ? "all" : "windows"));
	json_put(object, "files", files);
	free(marks);
	return object;
}

/* --------------------------------------------------------------------- page */

static size_t rest_of(const struct html_contents *report, const struct page *page, size_t reserved)
{
	/* Tags, and what describes the pieces in the head, take less than a thirtieth. */
	const size_t used = page->written + reserved + report->budget / 30;

	return used < report->budget ? report->budget - used : 0;
}

/* The text of a value, packed. */
static void pack_json(struct strbuf *out, const json_t *value)
{
	struct strbuf text = {0};

	html_text_add_json(&text, value);
	page_pack(out, &text, DEFLATE_SMALL);
	strbuf_release(&text);
}

/* Bytes that the head will need at most, besides those it has now: what it says of a chunk is about so long, packed. */
static size_t length_of_head(const json_t *head, const struct recorder *recorder)
{
	enum { CHUNK_BYTES = 30 };
	struct strbuf text = {0};
	size_t length;

	pack_json(&text, head);
	length = text.length + CHUNK_BYTES * (recorder->path.chunk_count + recorder->clearance.chunk_count);
	strbuf_release(&text);
	return length;
}

/* A short table that is there as a whole needs no coarse level. */
static bool is_short(const struct recorded_table *table)
{
	return table->chunk_count <= SHORT_CHUNKS;
}

/* The coarse levels of long tables, which come before all chunks. */
static void write_long_coarse(struct page *page, const struct recorder *recorder, json_t *path, json_t *clearance)
{
	if (path && !is_short(&recorder->path))
		json_put(path, "coarse", write_coarse(page, &recorder->path, true));
	if (clearance && !is_short(&recorder->clearance))
		json_put(clearance, "coarse", write_coarse(page, &recorder->clearance, false));
}

static void write_short_coarse(struct page *page, const struct recorded_table *table, bool start, json_t *object)
{
	if (is_short(table))
		json_put(object, "coarse", json_is_true(json_object_get(object, "complete")) ? json_null() : write_coarse(page, table, start));
}

/* Writes all levels and adds them to the head. False: a temporary file failed. */
static bool write_levels(struct page *page, const struct html_contents *report, json_t *head, size_t reserved)
{
	struct recorder *recorder = report->recorder;
	json_t *path = recorder->path.rows ? path_json(report) : NULL;
	json_t *clearance = recorder->clearance.rows ? clearance_json(recorder) : NULL;
	bool good = true;
	size_t rest;

	json_put(head, "planes", recorder->plane_count ? planes_json(page, recorder) : json_null());
	write_long_coarse(page, recorder, path, clearance);
	rest = rest_of(report, page, reserved);
	if (path) {
		good = write_chunks(page, &recorder->path, recorder, (size_t)(PATH_SHARE * (double)rest), path);
		write_short_coarse(page, &recorder->path, true, path);
	}
	if (clearance) {
		good = write_chunks(page, &recorder->clearance, recorder, (size_t)(CLEARANCE_SHARE * (double)rest), clearance) && good;
		write_short_coarse(page, &recorder->clearance, false, clearance);
	}
	json_put(head, "path", path ? path : json_null());
	json_put(head, "clearance", clearance ? clearance : json_null());
	json_put(head, "code", code_json(page, report, rest_of(report, page, reserved)));
	return good;
}

static void add_scripts(struct strbuf *out, const struct strbuf *viewer)
{
	const struct viewer_file boot = viewer_boot_script();

	strbuf_addf(out, "<script type=\"text/plain\" id=\"fivecheck-viewer\">");
	strbuf_add(out, strbuf_text(viewer), viewer->length);
	strbuf_addf(out, "</script>\n<script>");
	strbuf_add(out, boot.bytes, boot.count);
	strbuf_addf(out, "</script>\n</body>\n</html>\n");
}

static bool write_page(struct page *page, const struct html_contents *report)
{
	const struct viewer_file script = viewer_script();
	struct strbuf text = {0}, viewer = {0}, source = {0};
	json_t *head = head_json(report);
	bool good;

	strbuf_add(&source, script.bytes, script.count);
	page_pack(&viewer, &source, DEFLATE_SMALL);
	plain_html_add_head(&text, report->program->name, true);
	plain_html_add_main(&text, report);
	page_text(page, &text);
	page->written += report->scene->meshes.length;
	output_write(&page->out, strbuf_text(&report->scene->meshes), report->scene->meshes.length);
	page->blobs = report->scene->blobs;
	good = write_levels(page, report, head, viewer.length + length_of_head(head, report->recorder));
	strbuf_addf(&text, "<script type=\"text/plain\" id=\"fivecheck-head\">");
	pack_json(&text, head);
	strbuf_addf(&text, "</script>\n");
	add_scripts(&text, &viewer);
	page_text(page, &text);
	json_decref(head);
	strbuf_release(&source);
	strbuf_release(&viewer);
	strbuf_release(&text);
	return good;
}

bool html_report_write(const struct html_contents *report, const char *path, struct diag *diag)
{
	struct page page = {0};
	int error = report->recorder->path.error ? report->recorder->path.error : report->recorder->clearance.error;

	if (!error && !output_open(&page.out, path, diag))
		return false;
	if (!error && write_page(&page, report))
		return output_commit(&page.out, diag);
	output_discard(&page.out);
	error = report->recorder->path.error ? report->recorder->path.error : report->recorder->clearance.error;
	diag_error(diag, (struct srcloc){0}, "cannot write %s: its temporary file: %s", path, strerror(error));
	return false;
}

bool html_index_write(const char *path, const struct html_index_row *rows, size_t count, struct diag *diag)
{
	struct strbuf text = {0};
	struct output out;
	bool good = output_open(&out, path, diag);

	plain_html_add_head(&text, "fivecheck", false);
	strbuf_addf(&text, "<main id=\"plain\">\n<h1>fivecheck: %zu programs</h1>\n<table>\n"
			   "<tr><th>Program</th><th>Verdict</th><th></th></tr>\n", count);
	for (size_t i = 0; i < count; i++) {
		strbuf_addf(&text, "<tr><td>");
		if (rows[i].link)
			strbuf_addf(&text, "<a href=\"%s\">", rows[i].link);
		html_text_add(&text, rows[i].program);
		strbuf_addf(&text, "%s</td><td>%s</td><td>", rows[i].link ? "</a>" : "", rows[i].word);
		html_text_add(&text, rows[i].sentence);
		strbuf_addf(&text, "</td></tr>\n");
	}
	strbuf_addf(&text, "</table>\n</main>\n</body>\n</html>\n");
	if (good) {
		output_text(&out, &text);
		good = output_commit(&out, diag);
	}
	strbuf_release(&text);
	return good;
}
