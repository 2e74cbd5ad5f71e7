/* klartext_pattern_define.h - PATTERN DEF: reads the points at which CYCL CALL PAT carries out a cycle. */
#ifndef FIVECHECK_GCODE_DIALECT_KLARTEXT_CYCLES_KLARTEXT_PATTERN_DEFINE_H
#define FIVECHECK_GCODE_DIALECT_KLARTEXT_CYCLES_KLARTEXT_PATTERN_DEFINE_H

#include <stdbool.h>

#include "gcode/text/lexer.h"

/* Read the text after PATTERN; and a continuation line from its POS, ROW, PAT and the like on. False: reported. */
bool klartext_pattern_define_read(struct lexer *lexer);
bool klartext_pattern_define_go_on(struct lexer *lexer);

#endif
