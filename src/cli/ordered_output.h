/* ordered_output.h - what programs have to say while several are checked at once: each is heard whole, and in its turn. */
#ifndef FIVECHECK_CLI_ORDERED_OUTPUT_H
#define FIVECHECK_CLI_ORDERED_OUTPUT_H

#include <pthread.h>
#include <stdbool.h>
#include <stddef.h>

#include "base/diag_queue.h"
#include "base/strbuf.h"
#include "cli/stderr_ui.h"
#include "cli/error_list.h"
#include "report/sink.h"

/* Where everybody speaks. */
struct ordered_output {
	struct stderr_ui *ui;	/* borrowed */
	struct sinks *sinks;	/* borrowed */
	pthread_mutex_t lock;
	struct program_output *programs;	/* in the order in which they are heard */
	size_t count;
	size_t turn;	/* whose it is */
};

/* One program's. Its words go out at once when it is its turn, else they wait. */
struct program_output {
	struct ordered_output *order;
	struct diag diag;	/* for its diagnostics; counts them whether they were heard or not */
	struct diag_queue waiting;	/* diagnostics that wait */
	struct strbuf text[FORMAT_COUNT];	/* for each channel, that waits */
	struct error_list errors;	/* the first of its errors */
	bool ended;
};

/* `count` voices. */
void ordered_output_init(struct ordered_output *order, size_t count, struct stderr_ui *ui, struct sinks *sinks);
void ordered_output_release(struct ordered_output *order);

/* Has a write failed? Then nothing more needs to be said. */
bool ordered_output_is_lost(struct ordered_output *order);

/* Says a piece of a channel's report, which is then empty; false once a write has failed. */
bool program_output_write(struct program_output *output, size_t sink, struct strbuf *text);

/* Shows how far the program is, if it is its turn. */
void program_output_progress(struct program_output *output, const char *file, long lines, double share);

/* Nothing more will come: the next has its turn. */
void program_output_end(struct program_output *output);

#endif
