/* depfile.h - writes file names in the syntax of make. */
#ifndef FIVECHECK_REPORT_DEPFILE_H
#define FIVECHECK_REPORT_DEPFILE_H

#include <stdbool.h>

#include "base/diag.h"
#include "base/strbuf.h"

/*
 * Appends the name, escaped as a target or as a prerequisite of a rule, with a blank before it unless it is the first
 * of its line. False, reported: the name has a line break, which is impossible in a makefile. Source: manual of GNU
 * make, "Rule Syntax", "Using Wildcard Characters in File Names", "Static Pattern".
 */
bool depfile_add_name(struct strbuf *out, const char *name, bool target, struct diag *diag);

#endif
