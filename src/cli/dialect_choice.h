/* dialect_choice.h - the dialect that programs are read in: named, or seen from the programs themselves. */
#ifndef FIVECHECK_CLI_DIALECT_CHOICE_H
#define FIVECHECK_CLI_DIALECT_CHOICE_H

#include <stdbool.h>
#include <stddef.h>

#include "base/diag.h"

/* What --dialect can say: the rows of control/dialects.h, then "auto". Ends in NULL. */
extern const char *const dialect_choice_names[];

bool dialect_choice_is_auto(int choice);

/*
 * The dialect that all programs are certainly written in; a note says what shows it. False: one of them could not be
 * read, or its signs leave it open or contradict each other, or two programs differ; that was reported.
 */
bool dialect_choice_find(char *const *programs, size_t count, struct diag *diag, int *row);

#endif
