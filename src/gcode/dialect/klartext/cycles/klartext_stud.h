/* klartext_stud.h - milling cycles for studs and outside threads: the region of the tool around them. */
#ifndef FIVECHECK_GCODE_DIALECT_KLARTEXT_CYCLES_KLARTEXT_STUD_H
#define FIVECHECK_GCODE_DIALECT_KLARTEXT_CYCLES_KLARTEXT_STUD_H

#include <stdbool.h>

#include "gcode/dialect/klartext/cycles/klartext_region.h"

/* Each sets the region of the tool in X and Y, mm; the heights are set already. False: reported. */
bool klartext_stud_rectangle(const struct klartext_call_of *call, struct klartext_region *region);
bool klartext_stud_circle(const struct klartext_call_of *call, struct klartext_region *region);
bool klartext_stud_polygon(const struct klartext_call_of *call, struct klartext_region *region);
bool klartext_stud_finish(const struct klartext_call_of *call, struct klartext_region *region);
bool klartext_stud_thread(const struct klartext_call_of *call, struct klartext_region *region);

#endif
