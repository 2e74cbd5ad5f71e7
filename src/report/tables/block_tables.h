/* block_tables.h - measurements of each block as comma-separated tables (--clearance-report, --timing). */
#ifndef FIVECHECK_REPORT_TABLES_BLOCK_TABLES_H
#define FIVECHECK_REPORT_TABLES_BLOCK_TABLES_H

#include <stdbool.h>

#include "base/diag.h"
#include "base/strbuf.h"
#include "check/check.h"
#include "report/output.h"
#include "scene/scene.h"

/* A program and a file of it, and both as fields of a table, including the commas after them. */
struct table_names {
	struct strbuf program, file, fields;
};

/* The common fields of the rows of one pair. */
struct pair_fields {
	struct strbuf names;	/* of its bodies, including the comma after them */
	struct strbuf capped;	/* the whole end of a row with the cap, from the names on; empty: not written yet */
};

/* All zero: no tables. */
struct block_tables {
	struct output clearance, timing;
	struct strbuf rows;	/* of clearances, not written yet */
	struct strbuf row, place;	/* of the current row and block */
	double cap;	/* mm: in the row ends that are written already */
	struct table_names names;	/* of the last block */
	struct pair_fields *pairs;	/* owned: of each pair of the scene; NULL: none written yet */
	size_t pair_count;
	size_t names_most;	/* bytes: of the longest names */
};

/*
 * Opens the tables that have a path and writes their headers (RFC 4180, but lines end in LF):
 * program file line block body_a body_b clearance_mm capped, and
 * program file line block steps motion_s interpret_us check_us. False: reported.
 */
bool block_tables_open(struct block_tables *tables, const char *clearance, const char *timing, struct diag *diag);

bool block_tables_are_wanted(const struct block_tables *tables);

/* Adds a block of a program. block_tables_commit reports a write that failed. */
void block_tables_add(struct block_tables *tables, const struct scene *scene, const char *program,
		      const struct check_block *block);

/* output_commit and output_discard for both tables, which are then closed. */
bool block_tables_commit(struct block_tables *tables, struct diag *diag);
void block_tables_discard(struct block_tables *tables);

#endif
