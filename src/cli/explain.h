/* explain.h - explains a word of a report or a code of a program (--explain). */
#ifndef FIVECHECK_CLI_EXPLAIN_H
#define FIVECHECK_CLI_EXPLAIN_H

#include "base/diag.h"
#include "base/strbuf.h"
#include "cli/options.h"

/* Appends the explanation of options->explain. False, reported: the word is not known. */
bool explain_add(struct strbuf *out, const struct options *options, struct diag *diag);

#endif
