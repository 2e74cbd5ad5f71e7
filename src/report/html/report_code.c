#include "report/html/report_code.h"

#include <stdlib.h>
#include <string.h>

#include "base/mem.h"
#include "report/format/json.h"
#include "report/html/code_windows.h"

/* The lines of a file that a reader looks for first. */
struct marks {
	long *lines;	/* owned */
	size_t count, capacity;
};

static void add_mark(struct marks *marks, long line)
{
	marks->lines = mem_grow(marks->lines, &marks->capacity, marks->count + 1, sizeof(*marks->lines));
	marks->lines[marks->count++] = line;
}

/* The lines of findings, and those that called their subprograms. */
static struct marks marks_of(const struct recorder *recorder, const char *name)
{
	struct marks marks = {0};

	for (size_t i = 0; i < recorder->findings.count; i++) {
		const struct recorded_finding *finding = &recorder->findings.items[i];
		const json_t *calls = json_object_get(finding->object, "callers");

		if (!strcmp(finding->file, name))
			add_mark(&marks, finding->line);
		for (size_t k = 0; k < json_array_size(calls); k++) {
			const json_t *call = json_array_get(calls, k);

			if (!strcmp(json_string_value(json_object_get(call, "file")), name))
				add_mark(&marks, (long)json_integer_value(json_object_get(call, "line")));
		}
	}
	return marks;
}

static const char *digest_of(const struct html_contents *report, const char *path)
{
	for (size_t i = 0; i < report->file_count; i++) {
		if (!strcmp(report->files[i].path, path) && report->files[i].digest[0])
			return report->files[i].digest;
	}
	return NULL;
}

json_t *report_code_json(struct page *page, const struct html_contents *report, size_t budget)
{
	const struct recorder *recorder = report->recorder;
	json_t *object = json_object(), *files = json_array();
	bool all = true;

	for (size_t i = 0; i < recorder->files.count; i++) {
		const char *name = recorder->files.items[i].name, *digest = digest_of(report, name);
		json_t *file = json_object(), *windows = json_array();
		struct marks marks = marks_of(recorder, name);
		bool complete = false;
		long lines = -1;

		if (!report->no_code)
			budget -= code_windows_write(page, name, marks.lines, marks.count, budget, windows, &lines,
						     &complete);
		all = all && complete;
		json_put(file, "name", json_text(name));
		json_put(file, "sha256", digest ? json_string(digest) : json_null());
		json_put(file, "lines", json_integer(lines));
		json_put(file, "windows", windows);
		json_push(files, file);
		free(marks.lines);
	}
	json_put(object, "mode", json_string(report->no_code ? "none" : all ? "all" : "windows"));
	json_put(object, "files", files);
	return object;
}
