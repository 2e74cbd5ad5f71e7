/* program_list.h - the programs of a run: reads --files-from, and keeps those of --shard. */
#ifndef FIVECHECK_CLI_PROGRAM_LIST_H
#define FIVECHECK_CLI_PROGRAM_LIST_H

#include <stdbool.h>

#include "base/diag.h"
#include "cli/options.h"

/* Appends the programs in the file of --files-from, one per line. False: reported. */
bool program_list_read(struct options *options, struct diag *diag);

/*
 * Keeps only the programs of --shard K/N: the K-th, the (K+N)-th, and so on. Sets options->program_list from all names.
 */
void program_list_take_shard(struct options *options);

#endif
