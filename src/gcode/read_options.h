/* read_options.h - how a program is read: what the command line says of it, not the machine. */
#ifndef FIVECHECK_GCODE_READ_OPTIONS_H
#define FIVECHECK_GCODE_READ_OPTIONS_H

#include <stdbool.h>
#include <stddef.h>

#include "base/callbacks.h"

/* All pointers are borrowed while the program runs. */
struct read_options {
	bool block_delete;	/* skip blocks that start with '/' */
	/* after a fault the next block is read; nothing is told of moves from there on, and the run fails */
	bool all_faults;
	bool last_duplicate_wins;	/* of a word that stands twice in a block; else it is an error */
	const char *const *includes;	/* folders of subprogram files, after the program's own */
	size_t include_count;
	const char *input_root;	/* files of subprograms outside of this folder are an error; NULL: none is */
	int max_blocks;	/* in loops and subprograms; 0: a default that ends endless loops */
	const struct file_opened *opened;	/* is told which files of subprograms are opened; or NULL */
	const struct cancel *cancel;	/* is asked between lines; if so, the run fails without a message; or NULL */
	/*
	 * The same for a program from a pipe, while the next line has not come: all that came before was carried out.
	 * It is asked every PIPE_ASK_MS (gcode/text/pipe_read.h).
	 */
	const struct cancel *waiting;
};

#endif
