/* klartext_face.h - surfaces that a cycle mills line by line: the tool stays over them and beside them. */
#ifndef FIVECHECK_GCODE_DIALECT_KLARTEXT_KLARTEXT_FACE_H
#define FIVECHECK_GCODE_DIALECT_KLARTEXT_KLARTEXT_FACE_H

#include <stdbool.h>

#include "gcode/dialect/klartext/klartext_region.h"

/* The region of cycles 230 and 232, whose parameters say where it lies. False: reported. */
bool klartext_face_at(const struct klartext_call_of *call, struct klartext_region *region);

/* The region of cycle 233, which lies where the tool stands. False: reported. */
bool klartext_face_here(const struct klartext_call_of *call, struct klartext_region *region);

#endif
