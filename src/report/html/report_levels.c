#include "report/html/report_levels.h"

#include <stdlib.h>
#include <string.h>

#include "base/mem.h"
#include "report/format/json.h"
#include "report/html/pack_table.h"
#include "report/html/record_scales.h"
#include "report/html/report_code.h"
#include "report/html/report_data.h"
#include "report/html/selection.h"

/* Shares of the size that remains after the indispensable parts of a report; the program's text gets the rest. */
#define PATH_SHARE 0.55
#define CLEARANCE_SHARE 0.15

/* ------------------------------------------------------------------ levels */

static int write_table(struct page *page, const int64_t *values, size_t rows, size_t columns, enum deflate_level level)
{
	struct strbuf bytes = {0}, packed = {0};
	int blob;

	pack_table_add(&bytes, values, rows, columns);
	page_pack(&packed, &bytes, level);
	blob = page_blob(page, &packed);
	strbuf_release(&bytes);
	strbuf_release(&packed);
	return blob;
}

/* A short table that is complete needs no coarse level. */
static bool is_short(const struct recorded_table *table)
{
	return table->chunk_count <= SHORT_CHUNKS;
}

static enum deflate_level level_of(const struct recorded_table *table)
{
	return is_short(table) ? DEFLATE_SMALL : DEFLATE_FAST;
}

/* The coarse level; with `start`, after the first row of the table. */
static json_t *write_coarse(struct page *page, const struct recorded_table *table, bool start)
{
	const size_t n = table->columns, extra = start && memcmp(table->first, table->coarse, n * sizeof(int64_t)) != 0;
	const size_t rows = table->coarse_rows + extra;
	int64_t *values = mem_alloc((rows + 1) * n * sizeof(*values));
	json_t *object = json_object();

	memcpy(values, table->first, n * sizeof(*values));
	memcpy(values + extra * n, table->coarse, table->coarse_rows * n * sizeof(*values));
	json_put(object, "blob", json_integer(write_table(page, values, rows, n, level_of(table))));
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

/* Packs chunks, those of findings first, until one does not fit. packed[i] is empty if chunk i was left out. */
static bool choose_chunks(struct recorded_table *table, const struct recorder *recorder, size_t budget,
			  struct strbuf *packed)
{
	size_t *order = mem_alloc((table->chunk_count + 1) * sizeof(*order));
	size_t *marks = mem_alloc((recorder->findings.count + 1) * sizeof(*marks));
	size_t used = 0;

	for (size_t i = 0; i < recorder->findings.count && table->chunk_count; i++)
		marks[i] = chunk_at(table, (int64_t)(recorder->findings.items[i].time / RECORD_TIME));
	selection_order(order, table->chunk_count, marks, table->chunk_count ? recorder->findings.count : 0);
	for (size_t i = 0; i < table->chunk_count; i++) {
		struct strbuf bytes = {0}, *it = &packed[order[i]];

		if (recorded_table_chunk(table, order[i], &bytes))
			page_pack(it, &bytes, level_of(table));
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

/* Writes the chunks that fit and adds their description. False: the temporary file failed. */
static bool write_chunks(struct page *page, struct recorded_table *table, const struct recorder *recorder,
			 size_t budget, json_t *object)
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

/* ------------------------------------------------------------- descriptions */

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

/* s: the time up to which the program was checked. */
static double checked_until(const struct html_contents *report)
{
	const struct recorder *recorder = report->recorder;
	const struct verdict *verdict = report->program->verdict;
	const bool all =
	    verdict && (verdict->result == CHECK_CLEAR || (verdict->result == CHECK_FOUND && verdict->options->all));

	return all ? recorder->read.now : recorder->checked;
}

static json_t *modes_json(const struct recorder *recorder, const struct machine *machine)
{
	json_t *array = json_array();

	for (size_t i = 0; i < recorder->modes.count; i++) {
		const struct motion_modes *modes = &recorder->modes.items[i];
		json_t *object = json_object();

		json_put(object, "work_offset", json_text(modes->work_offset));
		json_put(object, "work", json_axes(machine, &modes->work));
		json_put(object, "shift", json_axes(machine, &modes->shift));
		json_put(object, "length", json_real(modes->length));
		json_put(object, "tcp", json_boolean(modes->tcp));
		json_put(object, "turned", json_boolean(modes->turned));
		json_put(object, "spindle", json_real(modes->spindle_speed));
		json_push(array, object);
	}
	return array;
}

static json_t *path_json(const struct html_contents *report)
{
	static const char *const names[] = {
		[PATH_TIME] = "time", [PATH_BLOCK] = "block", [PATH_LINE] = "line",
		[PATH_FILE] = "file", [PATH_TOOL] = "tool", [PATH_CLASS] = "class",
		[PATH_MODES] = "modes", [PATH_FEED] = "feed",
	};
	const struct recorder *recorder = report->recorder;
	const struct machine *machine = report->run->scene->machine;
	json_t *object = new_table(), *files = json_array();

	for (int i = 0; i < PATH_AXES; i++)
		push_column(object, names[i], i == PATH_TIME ? RECORD_TIME : i == PATH_FEED ? RECORD_FEED : 1);
	for (size_t i = 0; i < machine->axis_count; i++)
		push_column(object, machine->axes[i].name, record_axis_scale(&machine->axes[i]));
	for (size_t i = 0; i < recorder->files.count; i++)
		json_push(files, json_text(recorder->files.items[i].name));
	json_put(object, "rows", json_integer(recorder->path.rows));
	json_put(object, "files", files);
	json_put(object, "modes", modes_json(recorder, machine));
	json_put(object, "end", json_real(recorder->read.now));
	json_put(object, "checked", json_real(checked_until(report)));
	return object;
}

/* The smallest measured clearance, and its place. */
static json_t *smallest_json(const struct recorder *recorder)
{
	json_t *object;

	if (!recorder_is_near(recorder))
		return json_null();
	object = json_object();
	json_put(object, "least", json_real(recorder_shown(recorder->nearest.clearance)));
	json_put(object, "pair", json_integer((json_int_t)recorder->nearest.pair));
	json_put(object, "file", json_text(recorder->files.items[recorder->nearest.file].name));
	json_put(object, "line", json_integer(recorder->nearest.end.line));
	json_put(object, "time", json_real(recorder->nearest.end.to));
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
	json_put(object, "start", json_real(recorder->read.start));
	json_put(object, "bound", json_real(recorder_shown(recorder_bound(recorder))));
	json_put(object, "smallest", smallest_json(recorder));
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
	json_put(object, "rows", json_integer((json_int_t)recorder->planes.count));
	json_put(object, "blob",
		 json_integer(write_table(page, recorder->planes.rows[0], recorder->planes.count, PLANE_COLUMNS,
					  DEFLATE_SMALL)));
	return object;
}

/* --------------------------------------------------------------------- all */

static size_t rest_of(const struct html_contents *report, const struct page *page, size_t reserved)
{
	/* Tags, and the description of the pieces in the head, take less than a thirtieth. */
	const size_t used = page->written + reserved + report->budget / 30;

	return used < report->budget ? report->budget - used : 0;
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
		json_put(object, "coarse",
			 json_is_true(json_object_get(object, "complete")) ? json_null()
									   : write_coarse(page, table, start));
}

bool report_levels_write(struct page *page, const struct html_contents *report, json_t *head, size_t reserved)
{
	struct recorder *recorder = report->recorder;
	json_t *path = recorder->path.rows ? path_json(report) : NULL;
	json_t *clearance = recorder->clearance.rows ? clearance_json(recorder) : NULL;
	bool good = true;
	size_t rest;

	json_put(head, "planes", recorder->planes.count ? planes_json(page, recorder) : json_null());
	write_long_coarse(page, recorder, path, clearance);
	rest = rest_of(report, page, reserved);
	if (path) {
		good = write_chunks(page, &recorder->path, recorder, (size_t)(PATH_SHARE * (double)rest), path);
		write_short_coarse(page, &recorder->path, true, path);
	}
	if (clearance) {
		good = write_chunks(page, &recorder->clearance, recorder, (size_t)(CLEARANCE_SHARE * (double)rest),
				    clearance) &&
		       good;
		write_short_coarse(page, &recorder->clearance, false, clearance);
	}
	json_put(head, "path", path ? path : json_null());
	json_put(head, "clearance", clearance ? clearance : json_null());
	json_put(head, "code", report_code_json(page, report, rest_of(report, page, reserved)));
	return good;
}
