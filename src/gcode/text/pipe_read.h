/* pipe_read.h - reads the available bytes of a pipe, a socket or a terminal, without waiting for more. */
#ifndef FIVECHECK_GCODE_TEXT_PIPE_READ_H
#define FIVECHECK_GCODE_TEXT_PIPE_READ_H

#include <stdbool.h>
#include <stdio.h>
#include <sys/types.h>

#include "base/callbacks.h"

/* ms: the interval at which pipe_read asks whether to go on waiting. */
#define PIPE_ASK_MS 50

/*
 * Reads at least one byte and at most `most`, which is not 0; returns the number of bytes. 0: the input has ended, or
 * *stopped is set. -1: the input cannot be read, see errno.
 *
 * While no byte is available, `waiting` is asked at intervals, and at once after a signal; if it says stop, *stopped is
 * set. NULL: waits without end. Bytes in the stream's own buffer are read first, then the file descriptor. Without
 * glibc that buffer cannot be examined: then nothing may have been read from the stream before.
 */
ssize_t pipe_read(FILE *in, const struct cancel *waiting, char *bytes, size_t most, bool *stopped);

#endif
