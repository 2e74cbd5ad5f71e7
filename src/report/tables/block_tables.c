#include "report/tables/block_tables.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "base/mem.h"
#include "base/same_double.h"
#include "base/utf8.h"

static bool open_one(struct output *out, const char *path, const char *header, struct diag *diag)
{
	if (!path)
		return true;
	if (!output_open(out, path, diag))
		return false;
	/* block_tables_commit reports a write that failed. */
	output_write(out, header, strlen(header));
	return true;
}

bool block_tables_open(struct block_tables *tables, const char *clearance, const char *timing, struct diag *diag)
{
	return open_one(&tables->clearance, clearance,
			"program,file,line,block,body_a,body_b,clearance_mm,capped\n", diag) &&
	       open_one(&tables->timing, timing,
			"program,file,line,block,steps,motion_s,interpret_us,check_us\n", diag);
}

bool block_tables_are_wanted(const struct block_tables *tables)
{
	return tables->clearance.file || tables->timing.file;
}

/* A field with any text, quoted if necessary. */
static void add_text(struct strbuf *row, const char *text)
{
	bool quoted = strpbrk(text, ",\"\r\n") != NULL;
	struct strbuf clean = {0};

	utf8_add_clean(&clean, text);
	strbuf_add(row, "\"", quoted);
	for (const char *c = strbuf_text(&clean); *c; c++)
		strbuf_add(row, *c == '"' ? "\"\"" : c, *c == '"' ? 2 : 1);
	strbuf_addf(row, quoted ? "\"," : ",");
	strbuf_release(&clean);
}

/* The largest number of bytes that put_integer writes: a sign, the digits of 64 bits, a point and a 0 before it. */
enum { INTEGER_BYTES = 24 };

/*
 * Writes an integer with this many of its digits after a point at `to`; returns the end. A large table has millions of
 * them, and printf takes ten times as long.
 */
static char *put_integer(char *to, long long value, int places)
{
	unsigned long long rest = value < 0 ? -(unsigned long long)value : (unsigned long long)value;
	char digits[INTEGER_BYTES];
	size_t at = sizeof(digits);

	for (int i = 0; i <= places || rest; i++, rest /= 10) {
		if (i && i == places)
			digits[--at] = '.';
		digits[--at] = (char)('0' + rest % 10);
	}
	if (value < 0)
		*to++ = '-';
	memcpy(to, &digits[at], sizeof(digits) - at);
	return to + (sizeof(digits) - at);
}

/*
 * Texts are copied in blocks of this many bytes, which is faster than a call for each. Each text has this much room
 * after it.
 */
enum { COPIED = 32 };

static void add_room(struct strbuf *text)
{
	const size_t length = text->length;

	memset(strbuf_extend(text, COPIED), ' ', COPIED);
	text->length = length;
	text->text[length] = '\0';
}

/* Writes a text at `to`, which has COPIED bytes more room than the text is long; returns the end. */
static inline char *put_text(char *to, const struct strbuf *text)
{
	for (size_t at = 0; at < text->length; at += COPIED)
		memcpy(to + at, text->text + at, COPIED);
	return to + text->length;
}

static void add_all(struct strbuf *row, const struct strbuf *text)
{
	strbuf_add(row, strbuf_text(text), text->length);
}

static bool is_text(const struct strbuf *buf, const char *text)
{
	return buf->length && strcmp(buf->text, text) == 0;
}

static void set_text(struct strbuf *buf, const char *text)
{
	strbuf_clear(buf);
	strbuf_add(buf, text, strlen(text));
}

/* The fields with the names of the program and the file; usually they are those of the block before. */
static const struct strbuf *names_of(struct table_names *names, const char *program, const char *file)
{
	if (is_text(&names->program, program) && is_text(&names->file, file))
		return &names->fields;
	set_text(&names->program, program);
	set_text(&names->file, file);
	strbuf_clear(&names->fields);
	add_text(&names->fields, program);
	add_text(&names->fields, file);
	add_room(&names->fields);
	return &names->fields;
}

/* Writes a field with an integer at `to`; returns the end. */
static char *put_integer_field(char *to, long long value)
{
	to = put_integer(to, value, 0);
	*to++ = ',';
	return to;
}

/* The fields with the program, the file, the line and the block. */
static void set_place(struct block_tables *tables, const char *program, const struct check_block *block)
{
	const struct strbuf *names = names_of(&tables->names, program, block->file);
	struct strbuf *place = &tables->place;
	char *to;

	strbuf_clear(place);
	to = put_text(strbuf_extend(place, names->length + 2 * (INTEGER_BYTES + 1) + COPIED), names);
	to = put_integer_field(put_integer_field(to, block->line), block->number);
	place->length = (size_t)(to - place->text);
}

/* Writes the common fields of the rows of each pair, once for the whole table. */
static void name_pairs(struct block_tables *tables, const struct scene *scene)
{
	if (tables->pairs)
		return;
	tables->pairs = mem_zalloc(scene->pair_count, sizeof(*tables->pairs));
	tables->pair_count = scene->pair_count;
	for (size_t i = 0; i < scene->pair_count; i++) {
		struct strbuf *names = &tables->pairs[i].names;

		add_text(names, scene->bodies[scene->pairs[i].a].body->name);
		add_text(names, scene->bodies[scene->pairs[i].b].body->name);
		add_room(names);
		tables->names_most = names->length > tables->names_most ? names->length : tables->names_most;
	}
}

/* The largest number of bytes of a clearance: printf writes at most 309 digits before the point with "%.4f". */
enum { CLEARANCE_BYTES = 320 };

/*
 * Writes mm with four digits after the point, rounded down, so that the printed number is proved, too; returns the end.
 */
static char *put_rounded_down(char *to, double mm)
{
	const double units = floor(mm * 1e4);

	if (units >= 0 && units < 1e15)
		return put_integer(to, (long long)units, 4);
	return to + snprintf(to, CLEARANCE_BYTES, "%.4f", units / 1e4);
}

/* The end of a row with the cap, from the names on: nearly all rows have the same cap. */
static const struct strbuf *capped_end(struct block_tables *tables, struct pair_fields *fields, double mm)
{
	if (!same_double(tables->cap, mm)) {
		for (size_t i = 0; i < tables->pair_count; i++)
			strbuf_clear(&tables->pairs[i].capped);
		tables->cap = mm;
	}
	if (!fields->capped.length) {
		add_all(&fields->capped, &fields->names);
		strbuf_addf(&fields->capped, "%.10g,1\n", mm);
		add_room(&fields->capped);
	}
	return &fields->capped;
}

/* Writes a row at `to`, which has room for it; returns the end. */
static char *put_clearance(char *to, struct block_tables *tables, const struct pair_clearance *least)
{
	struct pair_fields *fields = &tables->pairs[least->pair];

	to = put_text(to, &tables->place);
	if (least->capped)
		return put_text(to, capped_end(tables, fields, least->clearance));
	to = put_rounded_down(put_text(to, &fields->names), least->clearance);
	*to++ = ',';
	*to++ = '0';
	*to++ = '\n';
	return to;
}

/* Rows are written to the file when they have this many bytes. */
enum { ROWS_KEPT = 1 << 11 };

static void add_clearances(struct block_tables *tables, const struct scene *scene, const char *program,
			   const struct check_block *block)
{
	struct strbuf *rows = &tables->rows;
	const size_t before = rows->length;
	char *to;

	set_place(tables, program, block);
	name_pairs(tables, scene);
	to = strbuf_extend(rows, block->clearance_count *
					 (tables->place.length + tables->names_most + CLEARANCE_BYTES + COPIED));
	for (size_t i = 0; i < block->clearance_count; i++)
		to = put_clearance(to, tables, &block->clearances[i]);
	rows->length = before + (size_t)(to - (rows->text + before));
	if (rows->length > ROWS_KEPT)
		output_text(&tables->clearance, rows);
}

static void add_times(struct block_tables *tables, const char *program, const struct check_block *block)
{
	set_place(tables, program, block);
	strbuf_add(&tables->row, tables->place.text, tables->place.length);
	strbuf_addf(&tables->row, "%ld,%.9g,%.1f,%.1f\n", block->steps, block->seconds, 1e6 * block->interpret,
		    1e6 * block->check);
	output_text(&tables->timing, &tables->row);
}

void block_tables_add(struct block_tables *tables, const struct scene *scene, const char *program,
		      const struct check_block *block)
{
	if (tables->clearance.file && block->clearance_count)
		add_clearances(tables, scene, program, block);
	if (tables->timing.file)
		add_times(tables, program, block);
}

bool block_tables_commit(struct block_tables *tables, struct diag *diag)
{
	bool good = true;

	if (tables->clearance.file) {
		output_text(&tables->clearance, &tables->rows);
		good = output_commit(&tables->clearance, diag);
	}
	return (!tables->timing.file || output_commit(&tables->timing, diag)) && good;
}

static void release_names(struct table_names *names)
{
	strbuf_release(&names->program);
	strbuf_release(&names->file);
	strbuf_release(&names->fields);
}

void block_tables_discard(struct block_tables *tables)
{
	output_discard(&tables->clearance);
	output_discard(&tables->timing);
	strbuf_release(&tables->rows);
	strbuf_release(&tables->row);
	strbuf_release(&tables->place);
	release_names(&tables->names);
	for (size_t i = 0; i < tables->pair_count; i++) {
		strbuf_release(&tables->pairs[i].names);
		strbuf_release(&tables->pairs[i].capped);
	}
	free(tables->pairs);
	tables->pairs = NULL;
	tables->pair_count = 0;
}
