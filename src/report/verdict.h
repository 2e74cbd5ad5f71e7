/* verdict.h - what may be said of a checked program: the one sentence, and what must be said beside it. */
#ifndef FIVECHECK_REPORT_VERDICT_H
#define FIVECHECK_REPORT_VERDICT_H

#include <stdbool.h>

#include "base/strbuf.h"
#include "check/check.h"
#include "scene/scene.h"

/* Borrows everything. */
struct verdict {
	const char *file;
	enum check_result result;
	const struct check_options *options;
	const struct check_stats *stats;
	const struct scene *scene;
	/* Findings that do not fail the run: in the baseline, waived, of other kinds than --fail-on's. */
	long known, waived, left_out;
	long first_line;	/* of the first finding that does */
	const char *first_file;	/* the same; NULL: `file` */
	long warnings;	/* of the check: what was taken for granted */
	const char *first_warning;	/* with its place; NULL: none */
};

/*
 * "clear" stands in the sentence only where every instant was proved. The
 * sampled methods, --parse-only, findings and faults each say what they are.
 */
void verdict_add_sentence(struct strbuf *out, const struct verdict *verdict);

/*
 * The same as one word: "clear", "passed" where no proof was asked for or only a part of the blocks is proved, "found",
 * "accepted" where nothing found fails the run, "incomplete"; NULL is incomplete.
 */
const char *verdict_word(const struct verdict *verdict);

/* Is every finding accepted, and the check complete? */
bool verdict_is_accepted(const struct verdict *verdict);

/* Was only a part of the program's blocks checked? */
bool verdict_is_shard(const struct verdict *verdict);

enum { VERDICT_CAUTIONS = 10 };

/*
 * Appends the i-th caution, one line without its end, i < VERDICT_CAUTIONS;
 * false if it does not apply.
 */
bool verdict_add_caution(struct strbuf *out, const struct verdict *verdict, int i);

/* How many pairs of the scene have this status. */
size_t verdict_pairs(const struct scene *scene, enum pair_status status);

#endif
