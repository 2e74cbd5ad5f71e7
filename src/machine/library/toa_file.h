/*
 * toa_file.h - the tool data that a Sinumerik control archives (TO area: .TOA, TO_INI), lines like
 * "$TC_DP3[5,1]=120.25".
 */
#ifndef FIVECHECK_MACHINE_LIBRARY_TOA_FILE_H
#define FIVECHECK_MACHINE_LIBRARY_TOA_FILE_H

#include <stdbool.h>
#include <stddef.h>

#include "base/arena.h"
#include "base/diag.h"

/* The largest n of $TC_DPn that is kept. */
enum { TOA_PARAMETERS = 23 };

/* The most tools, and the most edges, of a file: those of controls are a tenth of it. */
enum { TOA_MOST = 20000 };

/* An edge: $TC_DPn[tool,edge]. */
struct toa_edge {
	long tool, number;
	long line;	/* of its first value */
	double value[TOA_PARAMETERS + 1];	/* in the units of the file, by n; 0 if it is not given */
	long lines[TOA_PARAMETERS + 1];	/* of each value; 0: not given */
};

/* A tool: $TC_TPn[tool]. */
struct toa_tool {
	long number;
	long line;
	const char *name;	/* $TC_TP2, in the arena; NULL: not given */
};

/* All zero is empty. */
struct toa_file {
	double unit;	/* mm per unit of length; 0: neither METRIC nor INCH */
	struct toa_edge *edges;
	size_t edge_count, edge_capacity;
	struct toa_tool *tools;
	size_t tool_count, tool_capacity;
};

/* Does one of the lines assign to $TC_DPn or $TC_TPn? */
bool toa_file_is(const char *text);

/*
 * Reads all assignments. Those to other variables are not needed, but for corrections of the length that a setup cannot
 * have: sum and setup offsets ($TC_SCP, $TC_ECP), adapters of magazine places ($TC_ADPT) and orientations of the tool
 * ($TC_DPV) must be 0. Indices and values must be numbers or strings. False, reported: the file is faulty.
 */
bool toa_file_read(struct toa_file *file, struct arena *arena, const char *text, const char *path, struct diag *diag);

void toa_file_release(struct toa_file *file);

const struct toa_tool *toa_file_tool(const struct toa_file *file, long number);

#endif
