/* klartext_point_table.h - SEL PATTERN: the points of a point table (.PNT), for CYCL CALL PAT. */
#ifndef FIVECHECK_GCODE_DIALECT_KLARTEXT_CYCLES_KLARTEXT_POINT_TABLE_H
#define FIVECHECK_GCODE_DIALECT_KLARTEXT_CYCLES_KLARTEXT_POINT_TABLE_H

#include <stdbool.h>

#include "gcode/text/lexer.h"

/*
 * After SEL PATTERN: reads the name. The file is searched like that of a subprogram, by its name without folders.
 * False: reported.
 */
bool klartext_point_table_select(struct lexer *lexer);

#endif
