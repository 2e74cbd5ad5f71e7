#include "report/tables/block_tables.h"

#include <math.h>
#include <string.h>

#include "report/format/utf8.h"

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

static void add_place(struct strbuf *row, const char *program, const struct check_block *block)
{
	add_text(row, program);
	add_text(row, block->file);
	strbuf_addf(row, "%ld,%ld,", block->line, block->number);
}

static void add_clearance(struct block_tables *tables, const struct scene *scene, const char *program,
		     const struct check_block *block, const struct pair_clearance *least)
{
	const struct scene_pair *pair = &scene->pairs[least->pair];

	add_place(&tables->row, program, block);
	add_text(&tables->row, scene->bodies[pair->a].body->name);
	add_text(&tables->row, scene->bodies[pair->b].body->name);
	/* Rounded down, so that the printed number is proved, too. */
	if (least->capped)
		strbuf_addf(&tables->row, "%.10g,1\n", least->clearance);
	else
		strbuf_addf(&tables->row, "%.4f,0\n", floor(least->clearance * 1e4) / 1e4);
	output_text(&tables->clearance, &tables->row);
}

static void add_times(struct block_tables *tables, const char *program, const struct check_block *block)
{
	add_place(&tables->row, program, block);
	strbuf_addf(&tables->row, "%ld,%.9g,%.1f,%.1f\n", block->steps, block->seconds, 1e6 * block->interpret,
		    1e6 * block->check);
	output_text(&tables->timing, &tables->row);
}

void block_tables_add(struct block_tables *tables, const struct scene *scene, const char *program,
		      const struct check_block *block)
{
	for (size_t i = 0; tables->clearance.file && i < block->clearance_count; i++)
		add_clearance(tables, scene, program, block, &block->clearances[i]);
	if (tables->timing.file)
		add_times(tables, program, block);
}

bool block_tables_commit(struct block_tables *tables, struct diag *diag)
{
	bool good = !tables->clearance.file || output_commit(&tables->clearance, diag);

	return (!tables->timing.file || output_commit(&tables->timing, diag)) && good;
}

void block_tables_discard(struct block_tables *tables)
{
	output_discard(&tables->clearance);
	output_discard(&tables->timing);
	strbuf_release(&tables->row);
}
