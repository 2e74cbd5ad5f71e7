/* coordinate_conversion.h - G68 with I, J and K: coordinates shifted and turned about any direction. */
#ifndef FIVECHECK_GCODE_EXECUTE_COORDINATE_CONVERSION_H
#define FIVECHECK_GCODE_EXECUTE_COORDINATE_CONVERSION_H

#include "gcode/state.h"

/* Is the block's G68 a coordinate conversion? */
bool coordinate_conversion_is(const struct block *block);

/* May the block's G68 turn the active coordinates once more? */
bool coordinate_conversion_goes_on(const struct interp *interp);

/* Turns the coordinates according to the block's G68. False: the words are not sufficient, which was reported. */
bool coordinate_conversion_turn(struct interp *interp);

/* While such a G68 is active: is the direction of the tool length (mm) known? False: reported at the column. */
bool coordinate_conversion_knows_length(const struct interp *interp, int column, double length);

/* Are the first axis words after such a G68 absolute coordinates of X, Y and Z, as they must be? False: reported. */
bool coordinate_conversion_check_words(const struct interp *interp, bool absolute);

#endif
