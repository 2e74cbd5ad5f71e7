#include "import/ini_file.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "base/ascii.h"
#include "base/decimal.h"
#include "base/file_bytes.h"
#include "base/mem.h"
#include "base/strbuf.h"

/* Files that include each other end at this depth. */
enum { INCLUDE_DEPTH = 4 };
static const char include[] = "#INCLUDE ";

void ini_file_release(struct ini_file *ini)
{
	free(ini->entries);
	arena_release(&ini->arena);
	*ini = (struct ini_file){0};
}

const char *ini_file_beside(struct arena *arena, const char *path, const char *name)
{
	const char *slash = strrchr(path, '/');
	struct strbuf text = {0};
	const char *kept;

	if (slash && *name != '/')
		strbuf_add(&text, path, (size_t)(slash - path) + 1);
	strbuf_add(&text, name, strlen(name));
	kept = arena_strdup(arena, strbuf_text(&text));
	strbuf_release(&text);
	return kept;
}

/* The text between two positions, without blanks around it, in the arena. */
static const char *trimmed(struct arena *arena, const char *from, const char *to)
{
	char *copy;

	while (from < to && ascii_is_space(*from))
		from++;
	while (to > from && ascii_is_space(to[-1]))
		to--;
	copy = arena_alloc(arena, (size_t)(to - from) + 1);
	memcpy(copy, from, (size_t)(to - from));
	return copy;
}

struct reading {
	struct ini_file *ini;
	struct diag *diag;
	const char *section;
	struct srcloc at;
	int depth;
};

static bool read_file(struct reading *r, const char *path);

static bool fault(const struct reading *r, const char *what)
{
	diag_error(r->diag, r->at, "%s", what);
	return false;
}

static void add_entry(struct reading *r, const char *from, const char *equals, const char *to)
{
	struct ini_file *ini = r->ini;

	ini->entries = mem_grow(ini->entries, &ini->capacity, ini->count + 1, sizeof(*ini->entries));
	ini->entries[ini->count++] = (struct ini_entry){.section = r->section,
							 .key = trimmed(&ini->arena, from, equals),
							 .value = trimmed(&ini->arena, equals + 1, to),
							 .at = r->at};
}

static bool read_include(struct reading *r, const char *name)
{
	struct srcloc at = r->at;
	bool good;

	if (r->depth == INCLUDE_DEPTH)
		return fault(r, "files are included more than 4 deep");
	r->depth++;
	good = read_file(r, ini_file_beside(&r->ini->arena, at.file, name));
	r->depth--;
	r->at = at;
	return good;
}

/* NOLINTNEXTLINE(misc-no-recursion) */
static bool read_line(struct reading *r, const char *line, size_t length)
{
	const char *end = line + length, *equals;

	while (line < end && ascii_is_space(*line))
		line++;
	if (ascii_same_start(line, include, sizeof(include) - 1) && line + sizeof(include) - 1 < end)
		return read_include(r, trimmed(&r->ini->arena, line + sizeof(include) - 1, end));
	if (line == end || *line == '#' || *line == ';')
		return true;
	if (*line == '[') {
		const char *close = memchr(line, ']', (size_t)(end - line));

		if (!close)
			return fault(r, "the name of a section is not closed with ]");
		r->section = trimmed(&r->ini->arena, line + 1, close);
		return true;
	}
	equals = memchr(line, '=', (size_t)(end - line));
	if (!equals || !r->section)
		return fault(r, "a line of an ini file is a [SECTION] or, within one, KEY = value");
	add_entry(r, line, equals, end);
	return true;
}

/* A line whose last character is a backslash continues in the next one; *lines counts the lines. */
static size_t line_length(const char *text, long *lines)
{
	size_t length = strcspn(text, "\n");

	for (*lines = 0; length && text[length] && text[length - 1] == '\\'; ++*lines)
		length += 1 + strcspn(text + length + 1, "\n");
	return length;
}

/* NOLINTNEXTLINE(misc-no-recursion) */
static bool read_file(struct reading *r, const char *path)
{
	struct file_bytes file;
	const char *at;
	bool good = true;

	if (!file_bytes_read(&file, path, r->diag))
		return false;
	r->at = (struct srcloc){.file = arena_strdup(&r->ini->arena, path)};
	for (at = file.bytes; good && *at;) {
		long lines;
		size_t length = line_length(at, &lines);

		r->at.line++;
		good = read_line(r, at, length);
		r->at.line += lines;
		at += length;
		at += *at == '\n';
	}
	file_bytes_release(&file);
	return good;
}

bool ini_file_read(struct ini_file *ini, const char *path, struct diag *diag)
{
	struct reading r = {.ini = ini, .diag = diag};

	*ini = (struct ini_file){0};
	return read_file(&r, path);
}

const struct ini_entry *ini_file_next(const struct ini_file *ini, const struct ini_entry *after, const char *section,
				      const char *key)
{
	for (size_t i = after ? (size_t)(after - ini->entries) + 1 : 0; i < ini->count; i++)
		if (!strcmp(ini->entries[i].section, section) && !strcmp(ini->entries[i].key, key))
			return &ini->entries[i];
	return NULL;
}

const char *ini_file_text(const struct ini_file *ini, const char *section, const char *key)
{
	const struct ini_entry *entry = ini_file_next(ini, NULL, section, key);

	return entry ? entry->value : NULL;
}

bool ini_file_number(const struct ini_file *ini, const char *section, const char *key, double *value,
		     struct diag *diag)
{
	const struct ini_entry *entry = ini_file_next(ini, NULL, section, key);
	double number;
	size_t length;

	if (!entry)
		return true;
	/* A comment may follow the value. */
	length = strcspn(entry->value, " \t#;");
	if (length && decimal_read(entry->value, length, &number) && isfinite(number)) {
		*value = number;
		return true;
	}
	diag_error(diag, entry->at, "%s of [%s] must be a number", key, section);
	return false;
}
