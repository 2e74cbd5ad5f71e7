/* rest_of_file.h - examines a program's file after the end of the program, which is not carried out or checked. */
#ifndef FIVECHECK_GCODE_TEXT_REST_OF_FILE_H
#define FIVECHECK_GCODE_TEXT_REST_OF_FILE_H

#include <stdbool.h>

#include "base/callbacks.h"
#include "gcode/text/reader.h"

/* Lines that look like a part of the program; numbers from 1, 0: there is none. */
struct rest_of_file {
	/* the first block after the end that moves axes and belongs to no subprogram or other program */
	long motion;
	long program;	/* the O-number of another program that moves axes and has no end of a subprogram */
	long main;	/* the head of another main program; the others are 0 then */
};

/*
 * Reads to the end of the file, or to the first such line. The lines are classified roughly, for all controls: a
 * subprogram is the text between "o... sub" and "endsub", or before M99. A pipe is not read, because its writer may be
 * waiting for something else. heads_main tells whether a line is the head of a main program; it and cancel may be NULL.
 */
struct rest_of_file rest_of_file_find(struct reader *reader, bool (*heads_main)(const char *text),
				      const struct cancel *cancel);

#endif
