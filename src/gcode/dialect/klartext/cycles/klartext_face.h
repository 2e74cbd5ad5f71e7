/* klartext_face.h - surfaces that a cycle mills line by line: the region of the tool above and beside the surface. */
#ifndef FIVECHECK_GCODE_DIALECT_KLARTEXT_CYCLES_KLARTEXT_FACE_H
#define FIVECHECK_GCODE_DIALECT_KLARTEXT_CYCLES_KLARTEXT_FACE_H

#include <stdbool.h>

#include "gcode/dialect/klartext/cycles/klartext_region.h"

/* The region of cycles 230 and 232, whose parameters give its position. False: reported. */
bool klartext_face_at(const struct klartext_call_of *call, struct klartext_region *region);

/* The region of cycle 233, at the present position of the tool. False: reported. */
bool klartext_face_here(const struct klartext_call_of *call, struct klartext_region *region);

#endif
