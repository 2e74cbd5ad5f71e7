/* program_list.h - the programs of a long run: named in a file, shared out among computers. */
#ifndef FIVECHECK_CLI_PROGRAM_LIST_H
#define FIVECHECK_CLI_PROGRAM_LIST_H

#include <stdbool.h>

#include "base/diag.h"
#include "cli/options.h"

/*
 * Appends the programs that --files-from names, one a line ("-" is standard
 * input), to those of the command line. False: reported; no program at all is a fault, too.
 */
bool program_list_read(struct options *options, struct diag *diag);

/* Leaves the programs of --shard: of N shards the K-th has the K-th program, the (K+N)-th, and so on. */
void program_list_take_shard(struct options *options);

#endif
