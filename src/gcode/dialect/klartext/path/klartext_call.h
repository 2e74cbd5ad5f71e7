/* klartext_call.h - CYCL CALL, CYCL CALL POS and CYCL CALL PAT: the blocks that call the active cycle. */
#ifndef FIVECHECK_GCODE_DIALECT_KLARTEXT_PATH_KLARTEXT_CALL_H
#define FIVECHECK_GCODE_DIALECT_KLARTEXT_PATH_KLARTEXT_CALL_H

#include <stdbool.h>

#include "gcode/text/lexer.h"

/* Reads the text after CYCL CALL like a block of M-functions, and then calls the cycle. False: reported. */
bool klartext_call_run(struct lexer *lexer);

#endif
