/* klartext_tool.h - TOOL DEF, TOOL CALL and M6: tools by number or name, their lengths, speed and feed. */
#ifndef FIVECHECK_GCODE_DIALECT_KLARTEXT_MACHINE_KLARTEXT_TOOL_H
#define FIVECHECK_GCODE_DIALECT_KLARTEXT_MACHINE_KLARTEXT_TOOL_H

#include <stdbool.h>

#include "gcode/state.h"
#include "gcode/text/lexer.h"

/* Carries out the text after TOOL DEF. False: reported. */
bool klartext_tool_define(struct lexer *lexer);

/* Carries out the text after TOOL CALL. False: reported, or the sink wants no more. */
bool klartext_tool_call(struct lexer *lexer);

/* M6: on some machines it carries out the tool change that TOOL CALL has prepared. False: reported at the column. */
bool klartext_tool_m6(struct interp *interp, int column);

#endif
