/* vericut_machine.h - reads the machine files of VERICUT 7 (.mch, .xmch), which are XML with the root VcMachine. */
#ifndef FIVECHECK_IMPORT_VERICUT_MACHINE_H
#define FIVECHECK_IMPORT_VERICUT_MACHINE_H

#include <stdbool.h>

#include "import/import.h"
#include "import/vericut_build.h"

/*
 * The reader uses: components with their places, axes with travels and rapid rates, models, the mounts of tools and of
 * work, and the pairs of the collision list with their tolerances as clearances. Everything else in the file, such as
 * colours, tables of locations and accelerations, does not affect collisions or belongs to the setup.
 *
 * An axis that carries the work moves in the negative direction, as in VERICUT unless DisableAuto or PartSide says
 * otherwise (ISO 841: a positive value is a motion of the tool relative to the work).
 *
 * `build`: the components of a setup. Those that belong to the machine are added to it, and they define the carrier of
 * the work; or NULL.
 *
 * False, reported: the file is faulty, or contains something that cannot be converted.
 */
bool vericut_machine_read(struct import_machine *machine, const char *path, const struct vericut_build *build,
			  const struct import_options *options, struct diag *diag);

#endif
