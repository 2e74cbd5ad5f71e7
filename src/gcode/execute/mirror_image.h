/* mirror_image.h - programmable mirror image: G51.1 and G50.1, G101 and G100. */
#ifndef FIVECHECK_GCODE_EXECUTE_MIRROR_IMAGE_H
#define FIVECHECK_GCODE_EXECUTE_MIRROR_IMAGE_H

#include <stdbool.h>

#include "gcode/state.h"

/*
 * Fanuc B-64484EN, "Programmable Mirror Image (G50.1, G51.1)"; Haas mill operator's manual, "G100/G101". The image is a
 * rotated_frame that distorts: this also exchanges G2 and G3, and the sides of cutter compensation. Functions that can
 * fail report the reason before they return false.
 */

/* Call first for each block: refuses what is not allowed with a mirror image. */
bool mirror_image_start_block(struct interp *interp);

/* Carries out the block's code, if it has one. */
bool mirror_image_switch(struct interp *interp);

#endif
