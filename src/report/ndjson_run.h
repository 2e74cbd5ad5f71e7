/* ndjson_run.h - reads the NDJSON results of a run. */
#ifndef FIVECHECK_REPORT_NDJSON_RUN_H
#define FIVECHECK_REPORT_NDJSON_RUN_H

#include <jansson.h>
#include <stdbool.h>
#include <stddef.h>

#include "base/diag.h"

/* One whole run. Owns the JSON. */
struct ndjson_run {
	const char *path;	/* borrowed */
	json_t *header;
	json_t **lines;	/* findings, each program after its findings */
	size_t count, capacity;
	json_t *summary;
};

/*
 * False, reported: the file cannot be read, has another format, is incomplete, contains several runs, or has another
 * number of findings than it says. Release the run in either case.
 */
bool ndjson_run_load(struct ndjson_run *run, const char *path, struct diag *diag);
void ndjson_run_release(struct ndjson_run *run);

/* Is it the line of a program? Otherwise it is a finding. */
bool ndjson_run_is_program(const json_t *line);

/* A string of the object, or NULL. */
const char *ndjson_run_text(const json_t *object, const char *key);

#endif
