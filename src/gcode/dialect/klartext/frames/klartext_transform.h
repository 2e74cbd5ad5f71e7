/* klartext_transform.h - TRANS and PRESET, which change coordinates like the cycles 7, 8, 10 and 247. */
#ifndef FIVECHECK_GCODE_DIALECT_KLARTEXT_FRAMES_KLARTEXT_TRANSFORM_H
#define FIVECHECK_GCODE_DIALECT_KLARTEXT_FRAMES_KLARTEXT_TRANSFORM_H

#include <stdbool.h>

#include "gcode/text/lexer.h"

/* Carry out the text after TRANS, PRESET, and SEL TABLE. False: reported. */
bool klartext_transform_run(struct lexer *lexer);
bool klartext_transform_preset(struct lexer *lexer);
bool klartext_transform_table(struct lexer *lexer);

#endif
