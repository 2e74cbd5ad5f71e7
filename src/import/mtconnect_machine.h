/* mtconnect_machine.h - reads the device description (probe document) of MTConnect, versions 1.0 to 2.x. */
#ifndef FIVECHECK_IMPORT_MTCONNECT_MACHINE_H
#define FIVECHECK_IMPORT_MTCONNECT_MACHINE_H

#include <stdbool.h>

#include "import/import.h"

/*
 * Linear and Rotary components become axes; nativeName, else name, gives the letter, and a Rotary that only rotates a
 * tool or a part is a spindle. Travels are Specifications (POSITION, ANGLE) or Constraints in machine coordinates,
 * rates Specifications (VELOCITY, ANGULAR_VELOCITY). If every axis and a spindle have a Motion, these define the chain:
 * the axes that carry the spindle carry the tool. Else options->table gives the axes that carry the work. Bodies are
 * not imported; SolidModels are listed. False: reported.
 */
bool mtconnect_machine_read(struct import_machine *machine, const char *path, const struct import_options *options,
			    struct diag *diag);

#endif
