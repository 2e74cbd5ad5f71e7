/* klartext_function.h - FN 0 to FN 38, and FUNCTION: TCPM and modes of the machine. */
#ifndef FIVECHECK_GCODE_DIALECT_KLARTEXT_MACHINE_KLARTEXT_FUNCTION_H
#define FIVECHECK_GCODE_DIALECT_KLARTEXT_MACHINE_KLARTEXT_FUNCTION_H

#include <stdbool.h>

#include "gcode/text/lexer.h"

/* Carries out the text after FN. False: reported. */
bool klartext_function_run(struct lexer *lexer);

/* Carries out the text after FUNCTION. False: reported. */
bool klartext_function_mode(struct lexer *lexer);

#endif
