/* sinumerik_path.h - how far the control may leave the path: G60, G64 and the like, the compressor, CYCLE832. */
#ifndef FIVECHECK_GCODE_DIALECT_SINUMERIK_PATH_SINUMERIK_PATH_H
#define FIVECHECK_GCODE_DIALECT_SINUMERIK_PATH_SINUMERIK_PATH_H

#include "gcode/dialect/sinumerik/block/sinumerik_block.h"

/* Sets the modes of the path that the block has. */
void sinumerik_path_set(struct interp *interp, const struct sinumerik_block *block);

/* Executes CYCLE832 with the arguments that were read. False: reported. */
bool sinumerik_path_smooth(struct interp *interp, int column);

#endif
