/* ordered_output.h - what programs have to say while several are checked at once: each is heard whole, and in its turn. */
#ifndef FIVECHECK_CLI_ORDERED_OUTPUT_H
#define FIVECHECK_CLI_ORDERED_OUTPUT_H

#include <pthread.h>
#include <stdbool.h>
#include <stddef.h>

#include "base/held.h"
#include "base/strbuf.h"
#include "cli/stderr_ui.h"
#include "cli/error_list.h"
#include "report/sink.h"

/* Where everybody speaks. */
struct stage {
	struct console *console;	/* borrowed */
	struct channels *channels;	/* borrowed */
	pthread_mutex_t lock;
	struct voice *voices;	/* in the order in which they are heard */
	size_t count;
	size_t turn;	/* whose it is */
};

/* One program's. Its words go out at once when it is its turn, else they wait. */
struct voice {
	struct stage *stage;
	struct diag diag;	/* for its diagnostics; counts them whether they were heard or not */
	struct held held;	/* diagnostics that wait */
	struct strbuf text[FORMAT_COUNT];	/* for each channel, that waits */
	struct faults faults;	/* the first of its errors */
	bool ended;
};

/* `count` voices. */
void stage_init(struct stage *stage, size_t count, struct console *console, struct channels *channels);
void stage_release(struct stage *stage);

/* Has a write failed? Then nothing more needs to be said. */
bool stage_is_lost(struct stage *stage);

/* Says a piece of a channel's report, which is then empty; false once a write has failed. */
bool voice_say(struct voice *voice, size_t channel, struct strbuf *text);

/* Shows how far the program is, if it is its turn. */
void voice_progress(struct voice *voice, const char *file, long lines, double share);

/* Nothing more will come: the next has its turn. */
void voice_end(struct voice *voice);

#endif
