/* read_options.h - options of the command line for reading a program. */
#ifndef FIVECHECK_GCODE_READ_OPTIONS_H
#define FIVECHECK_GCODE_READ_OPTIONS_H

#include <stdbool.h>
#include <stddef.h>

#include "base/callbacks.h"

/* All pointers are borrowed while the program runs. */
struct read_options {
	bool block_delete;	/* skip blocks that start with '/' */
	/* after a fault the next block is read; no moves are sent to the sink from then on, and the run fails */
	bool all_faults;
	bool last_duplicate_wins;	/* of a word that a block has twice; else that is an error */
	const char *const *includes;	/* folders of subprogram files, after the program's own folder */
	size_t include_count;
	const char *input_root;	/* subprogram files outside of this folder are an error; NULL: no limit */
	int max_blocks;	/* in loops and subprograms; 0: a default that ends endless loops */
	const struct file_opened *opened;	/* called for each subprogram file that is opened; or NULL */
	const struct cancel *cancel;	/* asked between lines; on cancel the run fails without a message; or NULL */
	/*
	 * The same while a program from a pipe waits for its next line: all earlier lines were carried out. It is asked
	 * every PIPE_ASK_MS (gcode/text/pipe_read.h).
	 */
	const struct cancel *waiting;
};

#endif
