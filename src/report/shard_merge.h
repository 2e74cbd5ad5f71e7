/* shard_merge.h - joins the NDJSON results of all shards of a run into those of one run. */
#ifndef FIVECHECK_REPORT_SHARD_MERGE_H
#define FIVECHECK_REPORT_SHARD_MERGE_H

#include <stdbool.h>
#include <stddef.h>

#include "base/diag.h"
#include "base/strbuf.h"

/*
 * Appends the joined results and sets *status to the exit status of the whole run. False, reported: a shard is missing,
 * present twice, cut short or incomplete, or the shards did not read the same files with the same options.
 */
bool shard_merge(struct strbuf *out, int *status, char *const *paths, size_t count, struct diag *diag);

#endif
