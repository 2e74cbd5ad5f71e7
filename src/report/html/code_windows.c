#include "report/html/code_windows.h"

#include <errno.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>

#include "base/mem.h"
#include "base/utf8.h"
#include "report/format/json.h"
#include "report/html/selection.h"

/* A larger window has lines that are not meant for reading. */
enum { WINDOW_BYTES = 1 << 20 };

struct code_file {
	FILE *stream;
	long *starts;	/* where each window begins; one more: the end of the file */
	size_t windows, capacity;
	long lines;
};

static void add_start(struct code_file *file, long at)
{
	file->starts = mem_grow(file->starts, &file->capacity, file->windows + 2, sizeof(*file->starts));
	file->starts[file->windows] = at;
}

/* Finds the starts of the windows. */
static void scan(struct code_file *file)
{
	char bytes[16384];
	long at = 0;
	bool within = false;	/* a line */
	size_t count;

	for (; (count = fread(bytes, 1, sizeof(bytes), file->stream)) > 0; at += (long)count) {
		const char *end = bytes + count, *line_end;

		for (const char *next = bytes; next < end; next = line_end) {
			if (!within && file->lines % WINDOW_LINES == 0) {
				add_start(file, at + (next - bytes));
				file->windows++;
			}
			file->lines += !within;
			line_end = memchr(next, '\n', (size_t)(end - next));
			within = !line_end;
			line_end = line_end ? line_end + 1 : end;
		}
	}
	add_start(file, at);
}

/*
 * Appends the window as valid UTF-8 without the end of the last line; bytes 0 become spaces. False: it could not be
 * read.
 */
static bool add_window(struct code_file *file, size_t window, struct strbuf *out)
{
	const long from = file->starts[window];
	size_t count = (size_t)(file->starts[window + 1] - from);
	char *bytes;
	bool good;

	if (count > WINDOW_BYTES || fseek(file->stream, from, SEEK_SET))
		return false;
	bytes = mem_zalloc(count + 1, 1);
	good = fread(bytes, 1, count, file->stream) == count;
	for (char *zero; good && (zero = memchr(bytes, '\0', count)) != NULL;)
		*zero = ' ';
	if (count && bytes[count - 1] == '\n')
		bytes[count - 1] = '\0';
	if (good)
		utf8_add_clean(out, bytes);
	free(bytes);
	return good;
}

static long lines_of(const struct code_file *file, size_t window)
{
	const long first = (long)window * WINDOW_LINES;

	return file->lines - first < WINDOW_LINES ? file->lines - first : WINDOW_LINES;
}

/* Packs windows in the order of `order` until one does not fit. packed[window] is empty if the window was left out. */
static size_t choose(struct code_file *file, const size_t *order, struct strbuf *packed, size_t budget)
{
	size_t used = 0;

	for (size_t i = 0; i < file->windows; i++) {
		const size_t window = order[i];
		struct strbuf text = {0};

		if (add_window(file, window, &text)) {
			page_pack(&packed[window], &text, DEFLATE_FAST);
			used += packed[window].length;
		}
		strbuf_release(&text);
		if (used <= budget)
			continue;
		used -= packed[window].length;
		strbuf_release(&packed[window]);
		break;
	}
	return used;
}

static void write_windows(struct page *page, const struct code_file *file, const struct strbuf *packed, json_t *windows,
			  bool *complete)
{
	*complete = true;
	for (size_t i = 0; i < file->windows; i++) {
		json_t *object;

		*complete = *complete && packed[i].length > 0;
		if (!packed[i].length)
			continue;
		object = json_object();
		json_put(object, "first", json_integer((json_int_t)i * WINDOW_LINES + 1));
		json_put(object, "lines", json_integer(lines_of(file, i)));
		json_put(object, "blob", json_integer(page_blob(page, &packed[i])));
		json_push(windows, object);
	}
}

/* Only a regular file can be read again. */
static FILE *open_again(const char *path)
{
	struct stat status;
	FILE *stream = !stat(path, &status) && S_ISREG(status.st_mode) ? fopen(path, "rb") : NULL;

	if (!stream && errno == ENOMEM)
		mem_exhausted();
	return stream;
}

size_t code_windows_write(struct page *page, const char *path, const long *marks, size_t mark_count, size_t budget,
			  json_t *windows, long *lines, bool *complete)
{
	struct code_file file = {.stream = open_again(path)};
	struct strbuf *packed;
	size_t *order, *marked, count = 0, used;

	*lines = -1;
	*complete = false;
	if (!file.stream)
		return 0;
	scan(&file);
	order = mem_alloc((file.windows + 1) * sizeof(*order));
	marked = mem_alloc((mark_count + 1) * sizeof(*marked));
	packed = mem_zalloc(file.windows + 1, sizeof(*packed));
	for (size_t i = 0; i < mark_count; i++) {
		if (marks[i] >= 1 && marks[i] <= file.lines)
			marked[count++] = (size_t)(marks[i] - 1) / WINDOW_LINES;
	}
	selection_order(order, file.windows, marked, count);
	used = choose(&file, order, packed, budget);
	write_windows(page, &file, packed, windows, complete);
	*lines = file.lines;
	for (size_t i = 0; i < file.windows; i++)
		strbuf_release(&packed[i]);
	free(packed);
	free(marked);
	free(order);
	free(file.starts);
	fclose(file.stream);
	return used;
}
