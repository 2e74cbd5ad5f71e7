/* work_offset_use.h - checks that the work offset that a program uses is known. */
#ifndef FIVECHECK_GCODE_EXECUTE_WORK_OFFSET_USE_H
#define FIVECHECK_GCODE_EXECUTE_WORK_OFFSET_USE_H

#include <stdbool.h>

#include "gcode/state.h"

/*
 * Is the work offset known: from the setup, or because the program wrote it? Without a setup this is not required.
 * False: reported; the message says what to add to the setup.
 */
bool work_offset_use_require(struct interp *interp, int system, int column);

/* Call where the program reads a coordinate of a work offset: warns once if the setup does not define the offset. */
void work_offset_use_note(struct interp *interp, int system, int column);

/*
 * Call after the block's selection of a work offset: refuses axis words if the program has assigned a value to the
 * active work offset and has not selected it again. False: reported.
 */
bool work_offset_use_check(struct interp *interp);

/*
 * G54.2 and G54.4 of Fanuc move the work offset with the table and by measured errors; P0 ends this mode (30i-B
 * operator's manual). Only P0 is followed. False: reported.
 */
bool work_offset_use_check_end(struct interp *interp);

/* Reports at the column that the program assigned to the active work offset and did not select it again; false. */
bool work_offset_use_fault(const struct interp *interp, int column);

#endif
