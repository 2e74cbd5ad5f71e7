/* ndjson.h - results for other programs: one JSON object per line. */
#ifndef FIVECHECK_REPORT_WRITERS_NDJSON_H
#define FIVECHECK_REPORT_WRITERS_NDJSON_H

#include <jansson.h>

#include "base/strbuf.h"
#include "check/finding.h"
#include "machine/machine.h"
#include "report/report.h"

/* The options that can change a verdict, added to the object. */
void ndjson_put_options(json_t *object, const struct report_run *run);

/* The files with their SHA-256, or null where it is unknown, as an array of objects, which the caller releases. */
json_t *ndjson_files(const struct report_file *files, size_t count);

/* The keys of a limit: which one it is, the commanded position, and the offsets; added to the object. */
void ndjson_put_limit(json_t *object, const struct travel_excess *limit);

/* The cautions of a verdict (NULL: none) as an array of strings, which the caller releases. */
json_t *ndjson_cautions(const struct verdict *verdict);

/* The same for those that doubt an assumption of the verdict (verdict_caution_is_doubt). */
json_t *ndjson_doubts(const struct verdict *verdict);

/* Why the check of a program is incomplete, as an array of objects, which the caller releases. */
json_t *ndjson_errors(const struct report_program *program);

enum { NDJSON_FORMAT = 2 };

/*
 * The finding as a JSON object, which the caller releases. Keys, in this order: kind file line column move fraction a b
 * axes time point clearance block. Lengths are in mm, angles in degrees, times in seconds, with 12 digits; `axes` is an
 * object in the order X Y Z A B C U V W. Keys that do not apply are null: a limit has no bodies, but the keys of
 * ndjson_put_limit. A finding that does not fail the run has `accepted`: "waiver" or "fail-on"; a waived one `reason`
 * and `expires`. Bytes that are not UTF-8 become U+FFFD.
 */
json_t *ndjson_finding_object(const struct machine *machine, const struct finding *finding, struct finding_style style);

/* The same as a line. */
void ndjson_finding(struct strbuf *out, const struct machine *machine, const struct finding *finding,
		    struct finding_style style);

#endif
