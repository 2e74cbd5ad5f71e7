/* program_files.h - files with one program each, with the usual names of Fanuc's and Haas's programs. */
#ifndef FIVECHECK_GCODE_DIALECT_FANUC_PROGRAM_FILES_H
#define FIVECHECK_GCODE_DIALECT_FANUC_PROGRAM_FILES_H

#include <stdbool.h>

struct interp;
struct source;

/*
 * Finds the file of the program O<number>: O12, O0012 or O00012, with or without the O, and without an ending or with
 * .nc, .cnc, .tap or .txt. *source is NULL if there is none. False: reported at the column (there are two such files,
 * or too many files).
 */
bool program_files_find(struct interp *interp, int number, int column, struct source **source);

#endif
