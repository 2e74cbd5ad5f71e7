/* dialects.h - all dialects: each has one line in control/dialects.h and one folder. */
#ifndef FIVECHECK_GCODE_DIALECT_DIALECTS_H
#define FIVECHECK_GCODE_DIALECT_DIALECTS_H

#include "control/dialects.h"
#include "gcode/dialect.h"

#define DECLARE_DIALECT(id, ...) extern const struct dialect dialect_##id;
DIALECTS(DECLARE_DIALECT)
#undef DECLARE_DIALECT

/* The dialect of a row of control/dialects.h. */
const struct dialect *dialect_of_row(int row);

#endif
