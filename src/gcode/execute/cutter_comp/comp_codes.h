/* comp_codes.h - the codes of cutter compensation: what G40 to G42.1 and D do, and which codes are allowed under it. */
#ifndef FIVECHECK_GCODE_EXECUTE_CUTTER_COMP_COMP_CODES_H
#define FIVECHECK_GCODE_EXECUTE_CUTTER_COMP_COMP_CODES_H

#include <stdbool.h>

#include "gcode/state.h"

/* Refuses what compensation does not allow; call it first for each block. */
bool comp_codes_start_block(struct interp *interp);

/* Takes the block's D, and carries out its G40, G41, G41.1, G42 or G42.1, if it has one. */
bool comp_codes_select(struct interp *interp);

/* Refuses what the block must not have; call it after comp_codes_select, which a block without codes does not need. */
bool comp_codes_check_block(struct interp *interp);

#endif
