/* sink.h - the destinations of the reports of a run, files or standard output, each with its format. */
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
	struct strbuf items;	/* if the writer collects them */
	size_t count, free_count;	/* items written; of them those with a limit of their own */
	size_t left_out;	/* items dropped because of the writer's limit */
};

/* All zero is an empty list. */
struct sinks {
	struct sink items[FORMAT_COUNT];
	size_t count;
};

/* Adds a sink; each format can be used once. False: reported. */
bool sinks_open(struct sinks *sinks, enum report_format format, const char *path, bool colour,
		struct diag *diag);

/* Writes the beginning of all reports. */
void sinks_begin(struct sinks *sinks, const struct report_run *run);

/* Writes text that a writer made from findings or programs, and empties it. False once a write has failed. */
bool sink_write(struct sink *sink, struct strbuf *text);

/* Hands everything written so far to the system. False once a write has failed. */
bool sink_flush(struct sink *sink);

/* Writes the end of all reports. */
void sinks_end(struct sinks *sinks, const struct report_run *run, struct report_end *end);

/* Has a write failed? */
bool sinks_are_lost(const struct sinks *sinks);

/* output_commit and output_discard for all sinks, which are then closed. */
bool sinks_commit(struct sinks *sinks, struct diag *diag);
void sinks_discard(struct sinks *sinks);

#endif
