/* stderr_ui.h - standard error: diagnostics in the GNU form, and the progress of the run. */
#ifndef FIVECHECK_CLI_STDERR_UI_H
#define FIVECHECK_CLI_STDERR_UI_H

#include <stdbool.h>

#include "base/diag.h"

enum color_choice { COLOR_AUTO, COLOR_ALWAYS, COLOR_NEVER };
enum progress_kind { PROGRESS_AUTO, PROGRESS_PLAIN, PROGRESS_NONE };

struct stderr_ui {
	struct diag diag;	/* prints every entry */
	bool quiet;	/* prints only errors and their notes, no progress */
	bool after_error;	/* the last entry was an error, or a note that belongs to it */
	bool colour;
	bool terminal, renews;	/* a terminal; one that can renew a line */
	enum progress_kind kind;
	size_t programs, done;	/* programs of the run, and how many of them are finished */
	double started;	/* by stderr_ui_seconds */
	bool progress;	/* the last line of the terminal shows the progress */
	double shown;	/* when progress was last printed, by stderr_ui_seconds */
};

/* Do not move the structure afterwards: its diag points back to it. */
void stderr_ui_init(struct stderr_ui *ui);

/* COLOR_AUTO: is the file a terminal with colours, and NO_COLOR unset or empty (no-color.org)? */
bool stderr_ui_wants_colour(int fd, enum color_choice choice);

/* The run begins, with this many programs; one of them is finished; all are finished. */
void stderr_ui_expect(struct stderr_ui *ui, size_t programs);
void stderr_ui_done(struct stderr_ui *ui);
void stderr_ui_finish(struct stderr_ui *ui);

/*
 * Shows how far a program has been read: the line, and the share of its file (0 to 1; negative: unknown). With several
 * programs it shows the progress of the run, its rate and the time left. On a terminal the line is renewed up to five
 * times a second, and fits into its columns; plain lines, also on a terminal without control sequences, are printed
 * every ten seconds.
 */
void stderr_ui_progress(struct stderr_ui *ui, const char *file, long lines, double share);

/* Removes the progress line. Call it before anything else is printed. */
void stderr_ui_clear(struct stderr_ui *ui);

/* Seconds of the monotonic clock. */
double stderr_ui_seconds(void);

#endif
