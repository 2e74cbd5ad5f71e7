/* shard_match.h - decides whether results are all shards of one run, with the same files and options. */
#ifndef FIVECHECK_REPORT_SHARD_MATCH_H
#define FIVECHECK_REPORT_SHARD_MATCH_H

#include <stdbool.h>
#include <stddef.h>

#include "report/ndjson_run.h"

/*
 * The runs are sorted by their part. Sets *of_blocks if they are parts of the blocks of one program. False, reported: a
 * shard is missing or present twice, or the runs differ in an option, in a file or in the list of programs.
 */
bool shard_match(const struct ndjson_run *runs, size_t count, bool *of_blocks, struct diag *diag);

/*
 * The files of all runs, each once, sorted by kind and name: those of the headers, or with `subprograms` those of the
 * summaries. The caller releases the array.
 */
json_t *shard_match_files(const struct ndjson_run *runs, size_t count, bool subprograms);

#endif
