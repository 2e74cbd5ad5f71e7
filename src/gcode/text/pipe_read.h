/* pipe_read.h - reads what a pipe, a socket or a terminal has brought, without waiting for more. */
#ifndef FIVECHECK_GCODE_TEXT_PIPE_READ_H
#define FIVECHECK_GCODE_TEXT_PIPE_READ_H

#include <stdbool.h>
#include <stdio.h>
#include <sys/types.h>

#include "base/callbacks.h"

/* ms: how often pipe_read asks whether to go on waiting. */
#define PIPE_ASK_MS 50

/*
 * Reads at least one byte and at most `most`, which is not 0; returns how many. 0: the input has ended, or *stopped is
 * set. -1: it cannot be read, see errno.
 * `waiting` is asked as long as nothing comes, and by a signal at once; if it says so, *stopped is set. NULL: waits.
 * Once the stream's own buffer is empty the file is read through its descriptor. Where this buffer cannot be looked
 * into (other than with glibc), nothing may have been read from the stream before.
 */
ssize_t pipe_read(FILE *in, const struct cancel *waiting, char *bytes, size_t most, bool *stopped);

#endif
