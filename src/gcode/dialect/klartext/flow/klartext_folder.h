/* klartext_folder.h - finds the files that programs call, by their names without folders. */
#ifndef FIVECHECK_GCODE_DIALECT_KLARTEXT_FLOW_KLARTEXT_FOLDER_H
#define FIVECHECK_GCODE_DIALECT_KLARTEXT_FLOW_KLARTEXT_FOLDER_H

#include <stdbool.h>

#include "gcode/dialect/klartext/state/klartext_state.h"

/*
 * Finds the file of a name without the control's folders, unchanged or with one of the endings; *source is NULL if
 * there is none. False: reported at the column.
 */
bool klartext_folder_find(struct interp *interp, const char *name, const char *const endings[3], int column,
			  struct source **source);

#endif
