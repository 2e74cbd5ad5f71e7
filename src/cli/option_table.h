/* option_table.h - the table of a check's options; parser, help, completions and usage errors are generated from it. */
#ifndef FIVECHECK_CLI_OPTION_TABLE_H
#define FIVECHECK_CLI_OPTION_TABLE_H

#include "cli/option_row.h"

enum { OPTION_COUNT = 46 };

/* The fields are offsets in struct options. */
extern const struct option_row option_table[OPTION_COUNT];

#endif
