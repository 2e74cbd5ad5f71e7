/*
 * topics.h - the meaning of the words in a report: kinds of findings, verdicts, cautions, statuses of pairs. One table
 * for --explain, for SARIF's rules and, compared by a test, for the manual page.
 */
#ifndef FIVECHECK_REPORT_TOPICS_H
#define FIVECHECK_REPORT_TOPICS_H

#include <stdbool.h>

#include "base/strbuf.h"
#include "check/finding.h"
#include "report/verdict.h"
#include "scene/scene.h"

/*
 * The kinds of findings come first, in the order of enum finding_kind; the cautions in that of enum caution, the
 * statuses in that of enum pair_status.
 */
enum {
	TOPIC_INCOMPLETE = FINDING_KINDS,
	TOPIC_CAUTION,
	TOPIC_CLEAR,
	TOPIC_PASSED,
	TOPIC_FOUND,
	TOPIC_ACCEPTED,
	TOPIC_CAUTIONS,
	TOPIC_PAIRS = TOPIC_CAUTIONS + CAUTION_COUNT,
	TOPIC_COUNT = TOPIC_PAIRS + PAIR_CUTTING + 1
};

/* Complete sentences. The first is a definition in one line. */
struct topic {
	const char *rule;	/* SARIF's name of the rule; NULL: it is not a rule */
	const char *brief;
	const char *meaning;	/* its meaning and why it matters */
	const char *advice;	/* what to do */
};

extern const struct topic topics[TOPIC_COUNT];

/* By the same index: "collision", "incomplete", "no-setup", ... ; ends in NULL. */
extern const char *const topic_names[TOPIC_COUNT + 1];

/* Appends the topic with that name, in lines of up to 80 columns. False: there is none; `out` is not changed. */
bool topics_explain(struct strbuf *out, const char *name);

#endif
