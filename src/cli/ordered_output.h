/* ordered_output.h - the output of programs that are checked in parallel, written in the order of the command line. */
#ifndef FIVECHECK_CLI_ORDERED_OUTPUT_H
#define FIVECHECK_CLI_ORDERED_OUTPUT_H

#include <pthread.h>
#include <stdbool.h>
#include <stddef.h>

#include "base/diag_queue.h"
#include "base/strbuf.h"
#include "cli/error_list.h"
#include "cli/stderr_ui.h"
#include "report/sink.h"

/* The outputs of all programs. Only the current program writes immediately; the others are buffered. */
struct ordered_output {
	struct stderr_ui *ui;	/* borrowed */
	struct sinks *sinks;	/* borrowed */
	pthread_mutex_t lock;
	struct program_output *programs;	/* in the order of the command line */
	size_t count;
	size_t current;	/* index of the program that writes immediately */
};

/* The output of one program. */
struct program_output {
	struct ordered_output *order;
	struct diag diag;	/* for its diagnostics; counts them whether they are buffered or not */
	struct diag_queue waiting;	/* diagnostics that are buffered */
	struct strbuf text[FORMAT_COUNT];	/* text for each sink that is buffered */
	struct error_list errors;	/* the first of its errors */
	bool ended;
};

void ordered_output_init(struct ordered_output *order, size_t count, struct stderr_ui *ui, struct sinks *sinks);
void ordered_output_release(struct ordered_output *order);

/* Has a write failed? Then the remaining programs need not be checked. */
bool ordered_output_is_lost(struct ordered_output *order);

/* Writes or buffers text for a sink, and empties it. False after a failed write. */
bool program_output_write(struct program_output *output, size_t sink, struct strbuf *text);

/* Shows the progress of the program if it is the current one. */
void program_output_progress(struct program_output *output, const char *file, long lines, double share);

/* The program is finished: the next unfinished program becomes the current one. */
void program_output_end(struct program_output *output);

#endif
