/* scan_setup.h - the tools, offsets and work offsets that programs need in a setup. */
#ifndef FIVECHECK_CLI_SCAN_SCAN_SETUP_H
#define FIVECHECK_CLI_SCAN_SCAN_SETUP_H

#include <stddef.h>
#include <stdio.h>

#include "base/strbuf.h"
#include "gcode/config.h"

/* An element of the setup, and the first block that needs it; all zero is an empty list. */
struct scan_setup {
	struct scan_setup_item {
		char *element, *place; /* owned */
	} *items;
	size_t count, capacity;
};

void scan_setup_release(struct scan_setup *setup);

/* Reads the program with an empty setup, and derives the elements from the messages. config: with all answers. */
void scan_setup_read(struct scan_setup *setup, const struct gcode_config *config, FILE *in, const char *name);

/* Appends a line for each element: the text for the setup, and the first block that needs it. */
void scan_setup_add(struct strbuf *out, const struct scan_setup *setup);

#endif
