#include "cli/option_value.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "base/decimal.h"
#include "base/mem.h"

static const struct srcloc nowhere;

bool option_value_number(double *out, const char *text)
{
	double value;

	if (text[strcspn(text, " \t\r\n\v\f")] || !decimal_read(text, strlen(text), &value) || !isfinite(value))
		return false;
	*out = value;
	return true;
}

static bool read_number(double *out, const struct option_row *row, const char *text, struct diag *diag)
{
	double value;

	if (!option_value_number(&value, text)) {
		diag_error(diag, nowhere, "--%s: '%s' is not a number%s%s%s", row->name, text, row->unit ? " of " : "",
			   row->unit ? row->unit : "", strchr(text, ',') ? "; write a decimal point" : "");
		return false;
	}
	if (value < row->least || value > row->greatest) {
		diag_error(diag, nowhere, "--%s: %s is not between %.10g and %.10g%s%s", row->name, text, row->least,
			   row->greatest, row->unit ? " " : "", row->unit ? row->unit : "");
		return false;
	}
	*out = value;
	return true;
}

static bool read_count(int *out, const struct option_row *row, const char *text, struct diag *diag)
{
	double value;

	if (!*text || strspn(text, "0123456789") != strlen(text)) {
		diag_error(diag, nowhere, "--%s: '%s' is not a whole number", row->name, text);
		return false;
	}
	if (!read_number(&value, row, text, diag))
		return false;
	*out = (int)value;
	return true;
}

/* The index of the choice at the start of the text, which has `length` bytes. -1: reported. */
static int find_choice(const struct option_row *row, const char *text, size_t length, struct diag *diag)
{
	struct strbuf names = {0};
	int i = 0;

	for (; row->choices[i]; i++) {
		if (strlen(row->choices[i]) == length && !strncmp(text, row->choices[i], length))
			break;
		strbuf_addf(&names, "%s%s", i ? ", " : "", row->choices[i]);
	}
	if (!row->choices[i]) {
		diag_error(diag, nowhere, "--%s: '%.*s' is not one of %s", row->name, (int)length, text,
			   strbuf_text(&names));
		i = -1;
	}
	strbuf_release(&names);
	return i;
}

static bool add_text(struct text_list *list, const struct option_row *row, const char *text, struct diag *diag)
{
	if (!*text) {
		diag_error(diag, nowhere, "--%s: its argument is empty", row->name);
		return false;
	}
	list->items = mem_grow(list->items, &list->capacity, list->count + 1, sizeof(*list->items));
	list->items[list->count++] = text;
	return true;
}

/* NAME or NAME=FILE */
static bool add_format(struct format_choice *formats, const struct option_row *row, const char *text,
		       struct diag *diag)
{
	size_t length = strcspn(text, "=");
	const char *path = text[length] ? text + length + 1 : NULL;
	int format;

	if (path && !*path) {
		diag_error(diag, nowhere, "--%s: the name of the file is empty", row->name);
		return false;
	}
	format = find_choice(row, text, length, diag);
	if (format < 0)
		return false;
	if (formats[format].wanted) {
		diag_error(diag, nowhere, "--%s: %s was given twice", row->name, row->choices[format]);
		return false;
	}
	formats[format] = (struct format_choice){true, path && strcmp(path, "-") ? path : NULL};
	return true;
}

/* K/N */
static bool read_shard(int *out, const struct option_row *row, const char *text, struct diag *diag)
{
	size_t digits = strspn(text, "0123456789");
	size_t more = text[digits] == '/' ? strspn(text + digits + 1, "0123456789") : 0;
	double part = strtod(text, NULL), parts = more ? strtod(text + digits + 1, NULL) : 0;

	if (!digits || !more || text[digits + 1 + more] || part < 1 || part > parts || parts > 1e6) {
		diag_error(diag, nowhere, "--%s: '%s' is not K/N, such as 3/8 for the third of eight parts", row->name,
			   text);
		return false;
	}
	out[0] = (int)part;
	out[1] = (int)parts;
	return true;
}

/* KIND,KIND */
static bool read_kinds(unsigned *out, const struct option_row *row, const char *text, struct diag *diag)
{
	unsigned kinds = 0;

	for (;; text++) {
		size_t length = strcspn(text, ",");
		int kind = find_choice(row, text, length, diag);

		if (kind < 0)
			return false;
		kinds |= 1U << kind;
		text += length;
		if (!*text)
			break;
	}
	*out = kinds;
	return true;
}

/* A,B,C,D */
static bool read_amounts(double out[CHANGES], const struct option_row *row, const char *text, struct diag *diag)
{
	double amounts[CHANGES], most = 0;
	const char *at = text;

	for (int i = 0; i < CHANGES; i++) {
		size_t length = strcspn(at, ",");
		char *part = mem_strndup(at, length);
		bool whole = (at[length] == ',') == (i < CHANGES - 1);
		bool good = whole && read_number(&amounts[i], row, part, diag);

		if (!whole)
			diag_error(diag, nowhere,
				   "--%s: '%s' is not four numbers like 1,1,1,0.5: of X, Y, Z and the tool length",
				   row->name, text);
		free(part);
		if (!good)
			return false;
		most = fmax(most, amounts[i]);
		at += length + 1;
	}
	if (!(most > 0))
		diag_error(diag, nowhere, "--%s: '%s': at least one of the four must be above 0", row->name, text);
	else
		memcpy(out, amounts, sizeof(amounts));
	return most > 0;
}

bool option_value_set(void *record, const struct option_row *row, const char *text, struct diag *diag)
{
	void *field = (char *)record + row->field;
	int index;

	_Static_assert(sizeof(enum check_method) == sizeof(int),
		       "choices are stored as int");
	switch (row->kind) {
	case VALUE_FLAG:
		*(bool *)field = true;
		return true;
	case VALUE_TEXT:
	case VALUE_OUTPUT:
		if (!*text)
			diag_error(diag, nowhere, "--%s: the argument is empty", row->name);
		*(const char **)field = row->kind == VALUE_OUTPUT && !strcmp(text, "-") ? NULL : text;
		return *text != '\0';
	case VALUE_LIST:
		return add_text(field, row, text, diag);
	case VALUE_NUMBER:
		return read_number(field, row, text, diag);
	case VALUE_COUNT:
		return read_count(field, row, text, diag);
	case VALUE_CHOICE:
		index = find_choice(row, text, strlen(text), diag);
		if (index < 0)
			return false;
		memcpy(field, &index, sizeof(index));
		return true;
	case VALUE_FORMAT:
		return add_format(field, row, text, diag);
	case VALUE_SHARD:
		return read_shard(field, row, text, diag);
	case VALUE_KINDS:
		return read_kinds(field, row, text, diag);
	case VALUE_AMOUNTS:
		return read_amounts(field, row, text, diag);
	case VALUE_LETTERS:
	case VALUE_MODE:
		*(const char **)field = text;
		return true;
	}
	return false;
}
