/* waiver_match.h - finds the waiver that accepts a finding. */
#ifndef FIVECHECK_REPORT_WAIVER_MATCH_H
#define FIVECHECK_REPORT_WAIVER_MATCH_H

#include <stdbool.h>

#include "base/strbuf.h"
#include "check/finding.h"
#include "machine/machine.h"
#include "machine/waivers.h"

/* The waivers of a run and the day that is compared with their last days. Borrows the file. */
struct waiver_match {
	const struct waivers *file;	/* NULL: there are none */
	char today[DATE_SIZE];
};

/* Is the last day of the waiver over? */
bool waiver_match_is_expired(const struct waiver_match *waiving, const struct waiver *waiver);

/*
 * The waiver whose kind, bodies (or axis), block and position match this finding of the program, or NULL. matched[] has
 * an element for each waiver and counts the findings that it has accepted; a waiver accepts at most `times` findings.
 * The caller clears matched[] before each program. An expired waiver is returned only if no other one matches.
 */
const struct waiver *waiver_match_find(const struct waiver_match *waiving, int *matched, const struct machine *machine,
				       const char *program, const struct finding *finding);

/* Appends "until 2026-12-31: the reason", on one line. */
void waiver_match_add_reason(struct strbuf *out, const struct waiver *waiver);

#endif
