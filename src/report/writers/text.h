/* text.h - findings and verdicts for people, in the GNU form that editors understand. */
#ifndef FIVECHECK_REPORT_WRITERS_TEXT_H
#define FIVECHECK_REPORT_WRITERS_TEXT_H

#include <stdbool.h>

#include "base/strbuf.h"
#include "check/finding.h"
#include "machine/machine.h"
#include "report/report.h"
#include "report/verdict.h"

/* Appends the message only: "head (Z) meets table (C)". */
void text_message(struct strbuf *out, const struct finding *finding);

/*
 * Appends the message and, for a limit, the commanded position and the offsets, and for a finding with the stock
 * whether it is certain: for reports that have no lines below the message.
 */
void text_sentence(struct strbuf *out, const struct finding *finding);

/* Appends the message with its place: "part.nc:118:1: error: collision: head (Z) meets table (C) [collision]". */
void text_headline(struct strbuf *out, const struct finding *finding, struct finding_style style);

/*
 * Appends a finding: the headline, then indented lines with the block, the position in it, the time and the axes; for
 * bodies also the point and the distance; for a limit the commanded position; for a start-overlap the <pair> line that
 * would waive it.
 */
void text_finding(struct strbuf *out, const struct machine *machine, const struct finding *finding,
		  struct finding_style style);

/* Appends the line of the verdict and its cautions, indented. */
void text_verdict(struct strbuf *out, const struct verdict *verdict);

#endif
