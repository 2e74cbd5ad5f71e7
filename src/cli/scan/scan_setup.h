/* scan_setup.h - what programs need of a setup: tools, offsets, work offsets. */
#ifndef FIVECHECK_CLI_SCAN_SCAN_SETUP_H
#define FIVECHECK_CLI_SCAN_SCAN_SETUP_H

#include <stddef.h>
#include <stdio.h>

#include "base/strbuf.h"
#include "gcode/config.h"

/* An element of the setup, and the first block that needs it; all zero is none. */
struct scan_setup {
	struct scan_setup_item {
		char *element, *place; /* owned */
	} *items;
	size_t count, capacity;
};

void scan_setup_release(struct scan_setup *setup);

/* Reads the program with an empty setup, and takes the elements from what is said of it. config: with all answers. */
void scan_setup_read(struct scan_setup *setup, const struct gcode_config *config, FILE *in, const char *name);

/* Appends a line for each element: what the setup is to have, and where a program needs it first. */
void scan_setup_add(struct strbuf *out, const struct scan_setup *setup);

#endif
