#include "gcode/dialect/klartext/flow/klartext_folder.h"

#include <stdio.h>
#include <string.h>

#include "base/ascii.h"
#include "gcode/dialect/klartext/text/klartext_lexis.h"

static bool is_separator(char byte)
{
	return byte == '\\' || byte == '/' || byte == ':';
}

/* "X.H" of "TNC:\\A\\X.H". */
static const char *bare_of(const char *path)
{
	const char *bare = path;

	for (const char *at = path; *at; at++) {
		if (is_separator(*at))
			bare = at + 1;
	}
	return bare;
}

static bool same_byte(char a, char b)
{
	return ascii_upper(a) == ascii_upper(b) || (is_separator(a) && is_separator(b));
}

/* Compares two folders as far as both are written: "A\X.H" may be "TNC:\A\X.H". */
static bool may_be_same(const char *a, size_t a_length, const char *b, size_t b_length)
{
	while (a_length && b_length) {
		if (!same_byte(a[a_length - 1], b[b_length - 1]))
			return false;
		a_length--;
		b_length--;
	}
	return (!a_length && !b_length) || is_separator(a_length ? a[a_length - 1] : b[b_length - 1]);
}

/*
 * Two paths that end in the same name may be two files of the control, but only one of them is here. Each file has a
 * line with its number and the folders of the first path that names some. False: the path may mean another file, which
 * was reported.
 */
static bool check_folder(struct interp *interp, const char *path, const struct source *source, int column)
{
	const struct sources *sources = &interp->program.sources;
	struct strbuf *folders = &klartext_of(interp)->calls.folders;
	const size_t length = (size_t)(bare_of(path) - path);
	size_t index = 0;
	const char *first;
	char key[24];

	if (!length)
		return true;
	while (sources->items[index] != source)
		index++;
	snprintf(key, sizeof(key), "\n%zu ", index);
	first = strstr(strbuf_text(folders), key);
	if (!first) {
		strbuf_addf(folders, "%s%.*s\n", key, (int)length, path);
		return true;
	}
	first += strlen(key);
	return may_be_same(first, strcspn(first, "\n"), path, length) ||
	       fault(&interp->at, column,
		     "%s and %.*s%s may be two files, but both would be %s here: give them different names", path,
		     (int)strcspn(first, "\n"), first, bare_of(path), source->name);
}

/* The control ignores the case of file names. The name is tried as written, in upper case and in lower case. */
static bool find_spelling(struct interp *interp, const char *file, int column, struct source **source)
{
	char spelling[KLARTEXT_NAME + 4];

	for (int way = 0; way < 3; way++) {
		size_t i = 0;

		for (; file[i]; i++)
			spelling[i] = way == 0 ? file[i] : way == 1 ? ascii_upper(file[i]) : ascii_lower(file[i]);
		spelling[i] = '\0';
		if (!sources_find(&interp->program.sources, &interp->config->read, spelling, &interp->at, column,
				  source))
			return false;
		if (*source)
			break;
	}
	return true;
}

bool klartext_folder_find(struct interp *interp, const char *name, const char *const endings[3], int column,
			  struct source **source)
{
	const char *bare = bare_of(name);

	*source = NULL;
	for (size_t i = 0; i < 3 && !*source && *bare; i++) {
		char file[KLARTEXT_NAME + 4];

		snprintf(file, sizeof(file), "%s%s", bare, endings[i]);
		if (!find_spelling(interp, file, column, source))
			return false;
	}
	return !*source || check_folder(interp, name, *source, column);
}
