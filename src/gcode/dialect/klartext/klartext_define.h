/* klartext_define.h - CYCL DEF: the lines of a definition, and the cycles that take effect where they are defined. */
#ifndef FIVECHECK_GCODE_DIALECT_KLARTEXT_KLARTEXT_DEFINE_H
#define FIVECHECK_GCODE_DIALECT_KLARTEXT_KLARTEXT_DEFINE_H

#include <stdbool.h>

#include "gcode/state.h"
#include "gcode/dialect/klartext/klartext_state.h"
#include "gcode/text/lexer.h"

/* Behind CYCL: DEF, or CALL with its words. False: reported. */
bool klartext_define_read(struct lexer *lexer);

/* Behind TCH PROBE: its number, name and parameters. False: reported. */
bool klartext_define_probe(struct lexer *lexer);

/* Is a definition open that goes on in this line? `numbered`: the line has a block number. */
bool klartext_define_goes_on(struct lexer *lexer, bool numbered);

/* A further line of the definition. False: reported. */
bool klartext_define_line(struct lexer *lexer);

/* Ends a definition that is open. False: reported. */
bool klartext_define_end(struct interp *interp);

/* Words of axes, "X+10 IY-5", up to the end of the line, as those of CYCL DEF 7. False: reported. */
bool klartext_define_read_axes(struct lexer *lexer, struct klartext_cycle *cycle);

/* One more of them. False: there is no room. */
bool klartext_define_add_axis(struct klartext_cycle *cycle, char letter, double value);

#endif
