/* work_offset_use.h - is the work offset that a program uses known? */
#ifndef FIVECHECK_GCODE_EXECUTE_WORK_OFFSET_USE_H
#define FIVECHECK_GCODE_EXECUTE_WORK_OFFSET_USE_H

#include <stdbool.h>

#include "gcode/state.h"

/*
 * Is the work offset known: from the setup, or because the program wrote it? Without any setup it need not be. False:
 * reported, with what to add to the setup.
 */
bool work_offset_use_require(struct interp *interp, int system, int column);

/* Where the program reads a coordinate of it: warns once about a work offset that the setup does not define. */
void work_offset_use_note(struct interp *interp, int system, int column);

/*
 * After the block's selection of a work offset: refuses axis words where the
 * program has assigned a value to the work offset in force and has not selected it again. False: reported.
 */
bool work_offset_use_check(struct interp *interp);

/*
 * G54.2 and G54.4 of Fanuc move the work offset with the table and by measured errors; P0 ends that (30i-B operator's
 * manual). Only this is followed. False: reported.
 */
bool work_offset_use_check_end(struct interp *interp);

/* Reports at the column that the work offset in force was assigned to and not selected again; false. */
bool work_offset_use_fault(const struct interp *interp, int column);

#endif
