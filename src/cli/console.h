/* console.h - standard error: diagnostics in the GNU form, and a line of progress while a terminal watches. */
#ifndef FIVECHECK_CLI_CONSOLE_H
#define FIVECHECK_CLI_CONSOLE_H

#include <stdbool.h>

#include "base/diag.h"

struct console {
	struct diag diag;	/* prints what is reported to it */
	bool quiet;	/* errors only, no progress */
	bool colour;
	bool terminal;
	bool progress;	/* a progress line stands on the terminal */
	double shown;	/* when it was last renewed, by console_seconds */
};

/* Not to be moved afterwards: its diag points back at it. */
void console_init(struct console *console);

/* Colour for a stream: only on a terminal that knows it, and not against NO_COLOR (no-color.org). */
bool console_wants_colour(int fd);

/* Shows how far a program is; a few times a second at most, and only on a terminal. */
void console_progress(struct console *console, const char *file, long lines);

/* Takes the progress line away, before something else is printed. */
void console_clear(struct console *console);

/* Seconds of a clock that only goes forward. */
double console_seconds(void);

#endif
