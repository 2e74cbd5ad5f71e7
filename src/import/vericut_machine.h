/* vericut_machine.h - reads the machine files of VERICUT 7 (.mch, .xmch), which are XML with the root VcMachine. */
#ifndef FIVECHECK_IMPORT_VERICUT_MACHINE_H
#define FIVECHECK_IMPORT_VERICUT_MACHINE_H

#include <stdbool.h>

#include "import/import.h"
#include "import/vericut_build.h"

/*
 * What is taken over: components with their places, axes with travels and rapid rates, models, the mount of tools and
 * of work, and the pairs of the collision list with their tolerances as clearances. Everything else of the file, such
 * as colours, tables of locations and accelerations, is no matter of collisions or stands in the setup.
 *
 * An axis that carries the work moves against its positive sense, as VERICUT has it unless DisableAuto or PartSide says
 * otherwise (ISO 841: a positive value is a motion of the tool relative to the work).
 *
 * `build`: the components of a setup, which the machine gets as far as they belong to it, and which say what carries
 * the work; or NULL.
 *
 * False, reported: the file is faulty, or says something that cannot be taken over.
 */
bool vericut_machine_read(struct import_machine *machine, const char *path, const struct vericut_build *build,
			  const struct import_options *options, struct diag *diag);

#endif
