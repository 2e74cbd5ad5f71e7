/*
 * freecad_machine.h - reads a machine of FreeCAD's CAM workbench (.fcm, JSON): axes, travels, rates, the tool's mount.
 */
#ifndef FIVECHECK_IMPORT_FREECAD_MACHINE_H
#define FIVECHECK_IMPORT_FREECAD_MACHINE_H

#include <stdbool.h>

#include "import/import.h"

/*
 * The role of an axis shows whether it carries the work or the tool; files of the first versions have no roles, and
 * then options->table is needed. A linear axis counts the tool relative to the work; a rotary axis rotates the bodies
 * that it carries about its vector, as FreeCAD computes. For two rotary axes on one side, FreeCAD's "parent"
 * contradicts its computation in its own machines: the order is used if both agree, else options->table and
 * options->head must give it. Such a file has no bodies. False: reported.
 */
bool freecad_machine_read(struct import_machine *machine, const char *path, const struct import_options *options,
			  struct diag *diag);

#endif
