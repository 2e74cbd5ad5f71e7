/* depfile.h - names of files as make reads them. */
#ifndef FIVECHECK_REPORT_DEPFILE_H
#define FIVECHECK_REPORT_DEPFILE_H

#include <stdbool.h>

#include "base/diag.h"
#include "base/strbuf.h"

/*
 * Appends a name, escaped for a rule's targets or for its prerequisites, after a
 * blank if the text does not end in one or begin with it. False: reported, the
 * name has a character that no makefile can hold. Source: GNU make's manual,
 * "Rule Syntax", "Using Wildcard Characters in File Names", "Static Pattern".
 */
bool depfile_add_name(struct strbuf *out, const char *name, bool target, struct diag *diag);

#endif
