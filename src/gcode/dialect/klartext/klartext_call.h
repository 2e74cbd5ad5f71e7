/* klartext_call.h - CYCL CALL, CYCL CALL POS and CYCL CALL PAT: the blocks that call the cycle in force. */
#ifndef FIVECHECK_GCODE_DIALECT_KLARTEXT_KLARTEXT_CALL_H
#define FIVECHECK_GCODE_DIALECT_KLARTEXT_KLARTEXT_CALL_H

#include <stdbool.h>

#include "gcode/text/lexer.h"

/* Behind CYCL CALL: like a block of M-functions, behind which the cycle is called. False: reported. */
bool klartext_call_run(struct lexer *lexer);

#endif
