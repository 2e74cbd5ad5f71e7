/* rest_of_file.h - what stands in a program's file behind its end, which no control carries out and nobody checks. */
#ifndef FIVECHECK_GCODE_TEXT_REST_OF_FILE_H
#define FIVECHECK_GCODE_TEXT_REST_OF_FILE_H

#include <stdbool.h>

#include "base/callbacks.h"
#include "gcode/text/reader.h"

/* What a reader of the file may take for a part of the program; lines from 1, 0: there is none. */
struct rest_of_file {
	/* the first block behind the end that moves axes and belongs to no subprogram or other program */
	long motion;
	long program;	/* the O-number of another program that moves axes and does not end as a subprogram does */
};

/*
 * Reads on to the end of the file, or to the first thing found. The lines are looked at roughly, as those of any
 * control: a subprogram is what stands between "o... sub" and "endsub", or before M99. A pipe is not read: whoever
 * writes into it may be waiting for something else. cancel may be NULL.
 */
struct rest_of_file rest_of_file_find(struct reader *reader, const struct cancel *cancel);

#endif
