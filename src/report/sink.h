/* sink.h - the reports of a run, each with its format, on the way to where they go. */
#ifndef FIVECHECK_REPORT_SINK_H
#define FIVECHECK_REPORT_SINK_H

#include <stdbool.h>
#include <stddef.h>

#include "base/diag.h"
#include "base/strbuf.h"
#include "report/output.h"
#include "report/writers/writers.h"

struct sink {
	const struct report_writer *writer;
	const char *path;	/* borrowed; NULL: standard output */
	bool colour;
	struct output out;
	struct strbuf items;	/* of a writer that collects them */
	size_t count, left_out;	/* items written; items beyond the writer's limit */
};

/* All zero is none. */
struct sinks {
	struct sink items[FORMAT_COUNT];
	size_t count;
};

/* One more; a format is used once at most. False: reported. */
bool sinks_open(struct sinks *sinks, enum report_format format, const char *path, bool colour,
		   struct diag *diag);

/* What a report begins with. */
void sinks_begin(struct sinks *sinks, const struct report_run *run);

/* Says what a writer made of findings or programs, which is then empty; false once a write has failed. */
bool sink_write(struct sink *sink, struct strbuf *text);

/* Hands on what was said; false once a write has failed. */
bool sink_flush(struct sink *sink);

/* What they end with. */
void sinks_end(struct sinks *sinks, const struct report_run *run, struct report_end *end);

/* Has a write failed? */
bool sinks_are_lost(const struct sinks *sinks);

/* As output_commit and output_discard, for all; the channels are then closed. */
bool sinks_commit(struct sinks *sinks, struct diag *diag);
void sinks_discard(struct sinks *sinks);

#endif
