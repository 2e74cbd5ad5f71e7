/* ndjson.h - results for programs: one JSON object a line. */
#ifndef FIVECHECK_REPORT_WRITERS_NDJSON_H
#define FIVECHECK_REPORT_WRITERS_NDJSON_H

#include <jansson.h>

#include "base/strbuf.h"
#include "check/finding.h"
#include "machine/machine.h"
#include "report/report.h"

/* "certified", "interpolated", "conventional", "parse-only" */
const char *ndjson_method(enum check_method method);

/* What must be said beside a verdict, as an array of texts; NULL has none. To be released by who takes it. */
json_t *ndjson_cautions(const struct verdict *verdict);

enum { NDJSON_FORMAT = 1 };

/*
 * Appends the finding as one line of JSON. Keys, in this order: kind file line
 * column move fraction a b axes time point clearance. Lengths in mm, angles in
 * degrees, times in seconds, with 12 digits; `axes` by name in the order X Y Z
 * A B C U V W. What a kind does not have is null: a limit has no bodies but two
 * more keys, `axis` and `bound`. What does not fail the run has `accepted`,
 * "baseline", "waiver" or "fail-on"; what is waived, `reason` and `expires`. Bytes that are no UTF-8 become U+FFFD.
 */
void ndjson_finding(struct strbuf *out, const struct machine *machine, const struct finding *finding,
		    struct finding_style style);

#endif
