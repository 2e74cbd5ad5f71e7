/* ndjson.h - findings for programs: one JSON object a line. */
#ifndef FIVECHECK_REPORT_NDJSON_H
#define FIVECHECK_REPORT_NDJSON_H

#include "base/strbuf.h"
#include "check/finding.h"
#include "machine/machine.h"

/* Lets the JSON library take its memory where everybody does. Once, before the first finding. */
void ndjson_init(void);

/*
 * Appends the finding as one line of JSON. Keys, in this order: kind file line
 * column move fraction a b axes time point clearance. Lengths in mm, angles in
 * degrees, times in seconds, with 12 digits; `axes` by name in the order X Y Z
 * A B C U V W. What a kind does not have is null: a limit has no bodies but two
 * more keys, `axis` and `bound`. Bytes that are no UTF-8 become U+FFFD.
 */
void ndjson_finding(struct strbuf *out, const struct machine *machine, const struct finding *finding);

#endif
