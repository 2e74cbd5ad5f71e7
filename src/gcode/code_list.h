/* code_list.h - lists how a dialect's codes and words are treated, for --explain and fivecheck-gcode(5). */
#ifndef FIVECHECK_GCODE_CODE_LIST_H
#define FIVECHECK_GCODE_CODE_LIST_H

#include <stdbool.h>

#include "base/strbuf.h"
#include "gcode/dialect.h"

/* "read", "ignored", "bounded" or "refused". */
const char *code_state_name(enum code_state state);

/* Appends all rows of the dialect: code, state and description, tab separated; G-codes, M-codes, then words. */
void code_list_add(struct strbuf *out, const struct dialect *dialect);

/*
 * Appends a few lines on how the dialect treats a code ("G43.4", "m08") or word. False: the dialect does not know it,
 * and nothing is appended.
 */
bool code_list_explain(struct strbuf *out, const struct dialect *dialect, const char *name);

#endif
