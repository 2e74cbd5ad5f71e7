/* freecad_axis.h - one axis of a FreeCAD machine: its vector, travel and rate, and what it carries. */
#ifndef FIVECHECK_IMPORT_FREECAD_AXIS_H
#define FIVECHECK_IMPORT_FREECAD_AXIS_H

#include <stdbool.h>

#include "import/freecad_reading.h"

/* Reads the axis into r->axes. r->letters must have all axes of the file. False: reported. */
bool freecad_axis_read(struct freecad_reading *r, const json_t *axes, char letter);

#endif
