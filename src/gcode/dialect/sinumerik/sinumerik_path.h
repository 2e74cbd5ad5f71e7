/* sinumerik_path.h - how closely the control keeps to the path: G60, G64 and their like, the compressor, CYCLE832. */
#ifndef FIVECHECK_GCODE_DIALECT_SINUMERIK_SINUMERIK_PATH_H
#define FIVECHECK_GCODE_DIALECT_SINUMERIK_SINUMERIK_PATH_H

#include "gcode/dialect/sinumerik/sinumerik_block.h"

/* Takes what the block's words say about it. */
void sinumerik_path_set(struct interp *interp, const struct sinumerik_block *block);

/* CYCLE832 with the arguments that were read. False: reported. */
bool sinumerik_path_smooth(struct interp *interp, int column);

#endif
