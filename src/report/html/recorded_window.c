#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "base/mem.h"
#include "report/html/pack_table.h"
#include "report/html/record_scales.h"
#include "report/html/recorder.h"

/* Degrees to radians. */
#define DEGREE (3.14159265358979323846 / 180)

static struct recorded_row row_of(const struct recorder *recorder, const int64_t *values)
{
	const struct machine *machine = recorder->scene->machine;
	struct recorded_row row = {.time = (double)values[PATH_TIME] * RECORD_TIME};

	for (size_t i = 0; i < machine->axis_count; i++) {
		const struct axis *axis = &machine->axes[i];
		const double value = (double)values[PATH_AXES + i] * record_axis_scale(axis);

		row.axes.v[axis->slot] = axis->rotary ? value * DEGREE : value;
	}
	return row;
}

/* Adds a row unless its time, as a float, equals that of the row before. */
static void push(struct recorded_window *window, const struct recorded_row *row)
{
	const double start = window->count ? window->rows[0].time : 0;

	if (window->count && !((float)(row->time - start) > (float)(window->rows[window->count - 1].time - start)))
		return;
	window->rows[window->count++] = *row;
}

static void push_coarse(struct recorder *recorder, struct recorded_window *window)
{
	const struct recorded_table *path = &recorder->path;
	struct recorded_row row = row_of(recorder, path->first);

	window->rows = mem_alloc((path->coarse_rows + 1) * sizeof(*window->rows));
	push(window, &row);
	for (size_t i = 0; i < path->coarse_rows; i++) {
		row = row_of(recorder, path->coarse + i * path->columns);
		push(window, &row);
	}
}

/* Adds the rows of a chunk between two times. False: the temporary file failed; the table remembers the reason. */
static bool push_chunk(struct recorder *recorder, size_t chunk, double from, double to, struct recorded_window *window)
{
	struct recorded_table *path = &recorder->path;
	const size_t rows = path->chunks[chunk].rows, n = path->columns;
	int64_t *values;
	struct strbuf bytes = {0};
	const bool good = recorded_table_chunk(path, chunk, &bytes);

	values = mem_alloc(rows * n * sizeof(*values));
	if (good)
		pack_table_read(values, rows, n, strbuf_text(&bytes));
	for (size_t r = 0; good && r < rows; r++) {
		const struct recorded_row row = row_of(recorder, values + r * n);

		if (row.time >= from && row.time < to)
			push(window, &row);
	}
	free(values);
	strbuf_release(&bytes);
	return good;
}

struct recorded_window recorder_window(struct recorder *recorder)
{
	const struct recorded_finding *first = recorded_findings_first(&recorder->findings);
	const struct recorded_table *path = &recorder->path;
	struct recorded_window window = {0};
	struct recorded_row last;
	size_t from, to;

	if (!path->rows || !path->chunk_count)
		return window;
	if (!first) {
		push_coarse(recorder, &window);
		return window;
	}
	for (to = 0; to + 1 < path->chunk_count && (double)path->chunks[to].to * RECORD_TIME < first->time; to++)
		;
	from = to && path->chunks[to - 1].rows + path->chunks[to].rows <= WINDOW_ROWS ? to - 1 : to;
	window.rows = mem_alloc((WINDOW_ROWS + 1) * sizeof(*window.rows));
	for (size_t i = from; i <= to; i++) {
		if (!push_chunk(recorder, i, first->time - WINDOW_SECONDS, first->time, &window))
			break;
	}
	last = (struct recorded_row){first->time, first->axes};
	push(&window, &last);
	window.rows[window.count - 1].axes = first->axes;
	return window;
}
