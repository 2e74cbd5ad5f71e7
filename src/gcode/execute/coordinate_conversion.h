/* coordinate_conversion.h - G68 with I, J and K: coordinates shifted and turned about any direction. */
#ifndef FIVECHECK_GCODE_EXECUTE_COORDINATE_CONVERSION_H
#define FIVECHECK_GCODE_EXECUTE_COORDINATE_CONVERSION_H

#include "gcode/state.h"

/* Is the block's G68 one of these? */
bool coordinate_conversion_is(const struct block *block);

/* May the block's G68 turn the coordinates in force once more? */
bool coordinate_conversion_goes_on(const struct interp *interp);

/* Turns the coordinates as the block's G68 says. False: the words do not say how, which was reported. */
bool coordinate_conversion_turn(struct interp *interp);

/* While such a G68 is in force, which way `length`, mm, acts must be known; false: reported at the column. */
bool coordinate_conversion_knows_length(const struct interp *interp, int column, double length);

/* The first words behind such a G68 must be absolute coordinates of X, Y and Z; false: they are not, reported. */
bool coordinate_conversion_check_words(const struct interp *interp, bool absolute);

#endif
