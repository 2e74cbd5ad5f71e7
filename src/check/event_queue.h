/* tape.h - a stretch of what motion_run says of a program, to be said again later. */
#ifndef FIVECHECK_CHECK_TAPE_H
#define FIVECHECK_CHECK_TAPE_H

#include <stdbool.h>
#include <stddef.h>

#include "base/diag.h"
#include "base/strbuf.h"
#include "base/callbacks.h"
#include "check/batch.h"
#include "motion/motion.h"

struct tape_entry;

/* Owns copies of all that it was told. All zero is empty. */
struct tape {
	struct tape_entry *entries;
	size_t count, capacity;
	struct batch steps;	/* their paths are the batch's once tape_close was called */
	struct motion_limit *limits;
	size_t limit_count, limit_capacity;
	struct strbuf texts;
};

void tape_release(struct tape *tape);
void tape_clear(struct tape *tape);

/* Is it long enough to be worth handing on? */
bool tape_is_full(const struct tape *tape);

/* The calls of a motion_sink, of a diag and of a watch; *summary is the run's at that moment. */
void tape_limit(struct tape *tape, const struct motion_summary *summary, const struct motion_limit *limit);
void tape_step(struct tape *tape, const struct motion_summary *summary, const struct motion_step *step);
void tape_tool(struct tape *tape, const struct motion_summary *summary, int tool, const axis_values *position);
void tape_block(struct tape *tape, const struct motion_summary *summary, const char *file, long line,
		const char *text, double seconds, int moves);
void tape_diag(struct tape *tape, const struct diag_entry *entry);
void tape_opened(struct tape *tape, const char *path);

/* Call it before playing. */
void tape_close(struct tape *tape);

/* Makes the same calls in the same order, *summary set before each; false: the sink stopped. opened may be NULL. */
bool tape_play(const struct tape *tape, const struct motion_sink *sink, struct diag *diag, const struct file_opened *opened,
	       struct motion_summary *summary);

#endif
