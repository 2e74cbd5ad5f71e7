/* verdict.h - the verdict about a program: one sentence, and cautions that must be printed with it. */
#ifndef FIVECHECK_REPORT_VERDICT_H
#define FIVECHECK_REPORT_VERDICT_H

#include <stdbool.h>

#include "base/strbuf.h"
#include "check/check.h"
#include "scene/scene.h"

/* All pointers are borrowed. */
struct verdict {
	const char *file;
	enum check_result result;
	const struct check_options *options;
	const struct check_stats *stats;
	const struct scene *scene;
	/* Numbers of findings that do not fail the run: waived ones, and those of a kind that is not in --fail-on. */
	long waived, left_out;
	long first_line;	/* of the first finding that fails the run */
	const char *first_file;	/* of that finding; NULL: `file` */
	long warnings;	/* number of warnings during the check */
	const char *first_warning;	/* with its place; NULL: none */
};

/*
 * Appends the sentence. It contains "clear" only if every instant was proved; the sampled methods, --parse-only,
 * findings and errors have other sentences.
 */
void verdict_add_sentence(struct strbuf *out, const struct verdict *verdict);

/*
 * The verdict as one word: "clear"; "passed" if no proof was requested or only a part of the blocks was proved;
 * "found"; "accepted" if no finding fails the run; "incomplete", also for NULL.
 */
const char *verdict_word(const struct verdict *verdict);

/* Is every finding accepted, and the check complete? */
bool verdict_is_accepted(const struct verdict *verdict);

/* In the order of printing. A new one needs a row in report/topics.c. */
enum caution {
	CAUTION_SAMPLED,
	CAUTION_NO_PAIRS,
	CAUTION_NO_SETUP,
	CAUTION_EXCUSED,
	CAUTION_WAIVED,
	CAUTION_SURFACES,
	CAUTION_MESH_CUTTER,
	CAUTION_NO_PATH_TOLERANCE,
	CAUTION_STRAIGHT_RAPIDS,
	CAUTION_FAR_CUTTER,
	CAUTION_ACCEPTED,
	CAUTION_SHARD,
	CAUTION_WARNINGS,
	CAUTION_DOUBT	/* the first of several */
};
enum { CAUTION_COUNT = CAUTION_DOUBT + 1 };

/* This many of the doubts about the model are separate cautions; one more caution counts the rest. */
enum { VERDICT_DOUBTS = 8, VERDICT_CAUTIONS = CAUTION_DOUBT + VERDICT_DOUBTS + 1 };

/* Appends the i-th caution, i < VERDICT_CAUTIONS, one line without its end. False: it does not apply. */
bool verdict_add_caution(struct strbuf *out, const struct verdict *verdict, int i);

/*
 * Does the i-th caution doubt an assumption of the verdict? The others report what a person has excused, accepted or
 * waived, or left to another run.
 */
bool verdict_caution_is_doubt(int i);

#endif
