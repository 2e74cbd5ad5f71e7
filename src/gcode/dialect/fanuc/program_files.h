/* program_files.h - files that hold one program each, under names that Fanuc's and Haas's programs have. */
#ifndef FIVECHECK_GCODE_DIALECT_FANUC_PROGRAM_FILES_H
#define FIVECHECK_GCODE_DIALECT_FANUC_PROGRAM_FILES_H

#include <stdbool.h>

struct interp;
struct source;

/*
 * The file of the program O<number>: O12, O0012 or O00012, with or without the
 * O, and nothing, .nc, .cnc, .tap or .txt behind it. *source is NULL if there is
 * none. False: reported at the column (there are two, or too many files).
 */
bool program_files_find(struct interp *interp, int number, int column, struct source **source);

#endif
