/* vericut_offsets.h - the work offsets of a setup of a VERICUT project. */
#ifndef FIVECHECK_IMPORT_VERICUT_OFFSETS_H
#define FIVECHECK_IMPORT_VERICUT_OFFSETS_H

#include <stdbool.h>

#include "import/import_project.h"
#include "import/vericut_components.h"

/*
 * Reads the tables of <GCode> into the setup. `components` are those of its <Build>, placed relative to the mount of
 * the work on the machine. False, reported: a number is faulty.
 */
bool vericut_offsets_read(struct import_setup *setup, const struct import_machine *machine,
			  const struct vericut_components *components, struct xml_reader *xml, const xmlNode *node);

#endif
