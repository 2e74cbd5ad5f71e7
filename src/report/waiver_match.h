/* waiver_match.h - which waiver, if any, names a finding. */
#ifndef FIVECHECK_REPORT_WAIVER_MATCH_H
#define FIVECHECK_REPORT_WAIVER_MATCH_H

#include <stdbool.h>

#include "base/strbuf.h"
#include "check/finding.h"
#include "machine/machine.h"
#include "machine/waivers.h"

/* A run's waivers, and the day that they are held against. Borrows the file. */
struct waiver_match {
	const struct waivers *file;	/* NULL: there are none */
	char today[DATE_SIZE];
};

/* Is its last day over? */
bool waiver_match_is_expired(const struct waiver_match *waiving, const struct waiver *waiver);

/*
 * The waiver for this finding of the program: of its kind, bodies (or axis), block and position. matched[], one for
 * each waiver and all 0 for a program's first finding, counts what each was taken for; none is taken more than
 * `times`. One that has expired is returned only if no other fits. NULL: none fits.
 */
const struct waiver *waiver_match_find(const struct waiver_match *waiving, int *matched, const struct machine *machine,
				const char *program, const struct finding *finding);

/* Appends "until 2026-12-31: the reason", on one line. */
void waiver_match_add_reason(struct strbuf *out, const struct waiver *waiver);

#endif
