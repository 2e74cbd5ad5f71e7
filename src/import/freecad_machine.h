/*
 * freecad_machine.h - reads a machine of FreeCAD's CAM workbench (.fcm, JSON): axes, travels, rates, the tool's mount.
 */
#ifndef FIVECHECK_IMPORT_FREECAD_MACHINE_H
#define FIVECHECK_IMPORT_FREECAD_MACHINE_H

#include <stdbool.h>

#include "import/import.h"

/*
 * The role of an axis says whether it carries the work or the tool; files of the first versions have none, and then
 * options->table does. A linear axis counts the tool relative to the work; a rotary axis turns what it carries about
 * its vector, as FreeCAD computes. Of two rotary axes on one side, FreeCAD's "parent" contradicts in its own machines
 * what it computes: the order is taken where both agree, else options->table and options->head have to say it. Such a
 * file names no body. False: reported.
 */
bool freecad_machine_read(struct import_machine *machine, const char *path, const struct import_options *options,
			  struct diag *diag);

#endif
