/* stderr_ui.h - standard error: diagnostics in the GNU form, and a line of progress while a terminal watches. */
#ifndef FIVECHECK_CLI_STDERR_UI_H
#define FIVECHECK_CLI_STDERR_UI_H

#include <stdbool.h>

#include "base/diag.h"

enum progress_kind { PROGRESS_AUTO, PROGRESS_PLAIN, PROGRESS_NONE };

struct stderr_ui {
	struct diag diag;	/* prints what is reported to it */
	bool quiet;	/* errors only, no progress */
	bool colour;
	bool terminal;
	enum progress_kind kind;
	size_t programs, done;	/* of the run; done, in any order */
	double started;	/* by console_seconds */
	bool progress;	/* a progress line stands on the terminal */
	double shown;	/* when it was last renewed, or a plain line printed, by console_seconds */
};

/* Not to be moved afterwards: its diag points back at it. */
void stderr_ui_init(struct stderr_ui *ui);

/* Colour for a stream: only on a terminal that knows it, and not against NO_COLOR (no-color.org). */
bool stderr_ui_wants_colour(int fd);

/* A run of so many programs begins; one of them is done; all are. */
void stderr_ui_expect(struct stderr_ui *ui, size_t programs);
void stderr_ui_done(struct stderr_ui *ui);
void stderr_ui_finish(struct stderr_ui *ui);

/*
 * Shows how far a program is, at which line and at which share of its file (0 to 1; below 0: not known), with several
 * how far the run is, its rate and the time left: a few times a second on a terminal, or as plain lines every
 * ten seconds.
 */
void stderr_ui_progress(struct stderr_ui *ui, const char *file, long lines, double share);

/* Takes the progress line away, before something else is printed. */
void stderr_ui_clear(struct stderr_ui *ui);

/* Seconds of a clock that only goes forward. */
double stderr_ui_seconds(void);

#endif
