/* dialect_choice.h - the dialect of the programs: given, or found from the programs themselves. */
#ifndef FIVECHECK_CLI_DIALECT_CHOICE_H
#define FIVECHECK_CLI_DIALECT_CHOICE_H

#include <stdbool.h>
#include <stddef.h>

#include "base/diag.h"

/* The choices of --dialect: the rows of control/dialects.h, then "auto". Ends in NULL. */
extern const char *const dialect_choice_names[];

bool dialect_choice_is_auto(int choice);

/*
 * The dialect in which all programs are certainly written; a note names the code that shows this. False, reported: a
 * program could not be read, its codes permit several dialects or contradict each other, or two programs differ.
 */
bool dialect_choice_find(char *const *programs, size_t count, struct diag *diag, int *row);

#endif
