/* circular_pocket.h - circular pocket milling of Haas: G12 and G13. */
#ifndef FIVECHECK_GCODE_EXECUTE_CIRCULAR_POCKET_H
#define FIVECHECK_GCODE_EXECUTE_CIRCULAR_POCKET_H

#include "gcode/state.h"

/*
 * Carries out G12 or G13. Haas mill operator's manual, "G12 Circular Pocket Milling CW / G13 Circular Pocket Milling
 * CCW": the tool moves down at the centre and then around it, up to the radius of K, or of I without K, minus the
 * tool's radius. The path between the circles is not followed: the whole cylinder is proved. False: reported.
 */
bool circular_pocket_mill(struct interp *interp);

#endif
