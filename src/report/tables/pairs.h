/* pairs.h - every pair of bodies with its status and the reason for it (--list-pairs). */
#ifndef FIVECHECK_REPORT_TABLES_PAIRS_H
#define FIVECHECK_REPORT_TABLES_PAIRS_H

#include "base/strbuf.h"
#include "scene/scene.h"

/* Appends a tab separated table: the header "a b status clearance reason", then a row per pair as in the XML. */
void pairs_add(struct strbuf *out, const struct scene *scene);

#endif
