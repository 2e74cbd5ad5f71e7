/* waivers.h - findings that a person accepts until a date, with a reason: the file of --waivers. */
#ifndef FIVECHECK_MACHINE_WAIVERS_H
#define FIVECHECK_MACHINE_WAIVERS_H

#include <stdbool.h>
#include <stddef.h>

#include "base/arena.h"
#include "base/axes.h"
#include "base/diag.h"
#include "machine/machine.h"

/* The size of "2026-12-31" with its NUL. Two such texts compare like the dates. */
enum { DATE_SIZE = 11 };

/*
 * Identifies one finding. The same bodies with every axis at the same position are the same contact. The text of the
 * block is compared, too, so that a waiver accepts little else.
 */
struct waiver {
	const char *program;	/* as on the command line */
	const char *kind;	/* of the finding */
	const char *a, *b;	/* bodies, in either order; NULL for a limit */
	int slot;	/* of a limit */
	const char *block;	/* its text */
	axis_values axes;	/* mm and radians */
	double within;	/* mm and degrees: the permitted difference of each axis from its position */
	int times;	/* the number of findings of one run of the program that it accepts */
	const char *reason;
	char expires[DATE_SIZE];	/* the last day on which it is valid, UTC */
	long line;
};

struct waivers {
	struct arena arena;
	const char *path;
	/*
	 * The machine and the setup file for which the waivers are valid: SHA-256 in hexadecimal digits, "none" for no
	 * setup; NULL: any file.
	 */
	const char *machine_sha256, *setup_sha256;
	long line;	/* the line of these in the file */
	struct waiver *items;
	size_t count;
};

/* Is the text an existing date like "2026-12-31"? */
bool waivers_is_date(const char *text);

/* Reads a file for this machine. NULL: faults were reported. */
struct waivers *waivers_load(const char *path, const struct machine *machine, struct diag *diag);
void waivers_free(struct waivers *waivers);

#endif
