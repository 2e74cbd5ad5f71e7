#include "report/baseline.h"

#include <errno.h>
#include <jansson.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "base/mem.h"
#include "base/strbuf.h"
#include "report/writers/ndjson.h"
#include "report/format/format_units.h"
#include "report/format/utf8.h"

/* Bytes: the line of a program with very many errors has some megabytes. */
#define LINE_MAX_LENGTH ((size_t)64 << 20)

struct entry {
	json_t *finding;
	const char *program;	/* borrowed from `programs` */
};

struct baseline {
	struct entry *entries;
	size_t count, capacity;
	json_t **programs;	/* lines of this kind; each follows the findings of its program */
	size_t program_count, program_capacity;
};

/* A baseline that is being read. */
struct reading {
	struct baseline *baseline;
	struct srcloc at;
	struct diag *diag;
	size_t named;	/* entries whose program is known */
	bool begun, ended;
};

static bool refuse(struct reading *reading, const char *why)
{
	diag_error(reading->diag, reading->at, "not a baseline: %s (make one with --all --format=ndjson=FILE)", why);
	return false;
}

static const char *text_of(const json_t *object, const char *key)
{
	return json_string_value(json_object_get(object, key));
}

static void add_finding(struct baseline *baseline, json_t *object)
{
	baseline->entries = mem_grow(baseline->entries, &baseline->capacity, baseline->count + 1,
				     sizeof(*baseline->entries));
	baseline->entries[baseline->count++] = (struct entry){.finding = json_incref(object)};
}

static bool add_program(struct reading *reading, json_t *object)
{
	struct baseline *baseline = reading->baseline;
	const char *name = text_of(object, "file");

	if (!name)
		return refuse(reading, "a program without a name");
	baseline->programs = mem_grow(baseline->programs, &baseline->program_capacity, baseline->program_count + 1,
				      sizeof(json_t *));
	baseline->programs[baseline->program_count++] = json_incref(object);
	while (reading->named < baseline->count)
		baseline->entries[reading->named++].program = name;
	return true;
}

static bool take_object(struct reading *reading, json_t *object)
{
	const char *kind = text_of(object, "kind"), *accepted = text_of(object, "accepted");

	if (!kind)
		return refuse(reading, "a line without a kind");
	if (reading->begun == !strcmp(kind, "header"))
		return refuse(reading, reading->begun ? "two runs in one file" : "it has no header");
	if (reading->ended)
		return refuse(reading, "it goes on after its summary");
	if (!reading->begun) {
		reading->begun = true;
		return json_integer_value(json_object_get(object, "format")) == NDJSON_FORMAT ||
		       refuse(reading, "its format has another number");
	}
	reading->ended = !strcmp(kind, "summary");
	if (!strcmp(kind, "program"))
		return add_program(reading, object);
	/* A waiver accepts a finding only until its last day. */
	if (!reading->ended && (!accepted || strcmp(accepted, "waiver") != 0))
		add_finding(reading->baseline, object);
	return true;
}

/* Reads the next line, at most up to a byte 0 or the maximum length. False: there are no more. */
static bool next_line(struct strbuf *line, FILE *in)
{
	int c;

	strbuf_clear(line);
	while (line->length < LINE_MAX_LENGTH && (c = getc(in)) != EOF && c != '\n') {
		const char byte = (char)c;

		strbuf_add(line, &byte, 1);
		if (!c)
			break;
	}
	return !ferror(in) && (line->length || !feof(in));
}

static bool take_lines(struct reading *reading, FILE *in)
{
	struct strbuf line = {0};
	bool good = true;

	errno = 0;
	while (good && next_line(&line, in)) {
		json_t *object = json_loadb(strbuf_text(&line), line.length, JSON_REJECT_DUPLICATES, NULL);

		reading->at.line++;
		good = object ? take_object(reading, object) : refuse(reading, "a line that is not a JSON object");
		json_decref(object);
	}
	strbuf_release(&line);
	if (good && ferror(in)) {
		diag_error(reading->diag, (struct srcloc){0}, "cannot read the baseline %s: %s", reading->at.file,
			   strerror(errno ? errno : EIO));
		good = false;
	}
	if (good && (!reading->ended || reading->named < reading->baseline->count))
		good = refuse(reading, "it was cut short");
	return good;
}

struct baseline *baseline_load(const char *path, struct diag *diag)
{
	struct baseline *baseline = mem_zalloc(1, sizeof(*baseline));
	struct reading reading = {.baseline = baseline, .at = {path, 0, 0}, .diag = diag};
	FILE *in = fopen(path, "rb");
	bool good = in != NULL;

	if (!in)
		diag_error(diag, (struct srcloc){0}, "cannot open the baseline %s: %s", path, strerror(errno));
	else
		good = take_lines(&reading, in);
	if (in)
		fclose(in);
	if (good)
		return baseline;
	baseline_free(baseline);
	return NULL;
}

void baseline_free(struct baseline *baseline)
{
	if (!baseline)
		return;
	for (size_t i = 0; i < baseline->count; i++)
		json_decref(baseline->entries[i].finding);
	for (size_t i = 0; i < baseline->program_count; i++)
		json_decref(baseline->programs[i]);
	free(baseline->entries);
	free(baseline->programs);
	free(baseline);
}

size_t baseline_count(const struct baseline *baseline)
{
	return baseline->count;
}

/* Is the member equal to the text as JSON holds it? NULL equals null and a missing member. */
static bool is_text(const json_t *object, const char *key, const char *text)
{
	const char *known = text_of(object, key);
	struct strbuf clean = {0};
	bool same;

	if (!text || !known)
		return !text && !known;
	utf8_add_clean(&clean, text);
	same = !strcmp(known, strbuf_text(&clean));
	strbuf_release(&clean);
	return same;
}

static bool is_near(const json_t *number, double value, double tolerance)
{
	return json_is_number(number) && fabs(json_number_value(number) - value) <= tolerance;
}

static bool is_same(const json_t *known, const struct machine *machine, const struct finding *f, double tolerance)
{
	bool limit = f->kind == FINDING_LIMIT;
	const char axis[2] = {limit ? AXIS_LETTERS[f->slot] : '\0', '\0'};
	const json_t *axes = json_object_get(known, "axes");
	bool same = is_text(known, "kind", finding_kind_name(f->kind)) && is_text(known, "file", f->file) &&
		    is_text(known, "a", limit ? NULL : f->a) && is_text(known, "b", limit ? NULL : f->b) &&
		    is_text(known, "axis", limit ? axis : NULL) &&
		    (!limit || is_near(json_object_get(known, "bound"), format_units_value(f->slot, f->bound), 1e-6));

	for (int slot = 0; slot < SLOT_COUNT && same; slot++) {
		const char name[2] = {AXIS_LETTERS[slot], '\0'};

		if (machine_axis(machine, slot))
			same =
			    is_near(json_object_get(axes, name), format_units_value(slot, f->axes.v[slot]), tolerance);
	}
	return same;
}

bool baseline_knows(const struct baseline *baseline, bool *used, const struct machine *machine, const char *program,
		    const struct finding *finding, double tolerance)
{
	for (size_t i = 0; i < baseline->count; i++) {
		const struct entry *entry = &baseline->entries[i];
		bool here = !used[i] && !strcmp(entry->program, program);

		if (here && is_same(entry->finding, machine, finding, tolerance)) {
			used[i] = true;
			return true;
		}
	}
	return false;
}
