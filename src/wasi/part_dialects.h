/*
 * part_dialects.h - dialect_linuxcnc_get() and so on return each dialect; calling one loads the part with the dialect.
 */
#ifndef FIVECHECK_WASI_PART_DIALECTS_H
#define FIVECHECK_WASI_PART_DIALECTS_H

#include "gcode/dialect/dialects.h"

#define DECLARE_GETTER(id, ...) const struct dialect *dialect_##id##_get(void);
DIALECTS(DECLARE_GETTER)
#undef DECLARE_GETTER

#endif
