/* code_list.h - what becomes of the codes and words of a dialect, for people: --explain and fivecheck-gcode(5). */
#ifndef FIVECHECK_GCODE_CODE_LIST_H
#define FIVECHECK_GCODE_CODE_LIST_H

#include <stdbool.h>

#include "base/strbuf.h"
#include "gcode/dialect.h"

/* "read", "ignored", "bounded" or "refused". */
const char *code_state_name(enum code_state state);

/* Appends all rows of the dialect: code, state and what it is, tab separated; G-codes, M-codes, then words. */
void code_list_add(struct strbuf *out, const struct dialect *dialect);

/*
 * Appends what becomes of a code ("G43.4", "m08") or word in the dialect, in a
 * few lines. False, and nothing is appended: the dialect does not know it.
 */
bool code_list_explain(struct strbuf *out, const struct dialect *dialect, const char *name);

#endif
