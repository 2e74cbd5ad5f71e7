/* vericut_pairs.h - the collision list of a VERICUT machine. */
#ifndef FIVECHECK_IMPORT_VERICUT_PAIRS_H
#define FIVECHECK_IMPORT_VERICUT_PAIRS_H

#include <stdbool.h>

#include "base/axes.h"
#include "import/import.h"
#include "import/vericut_components.h"

/* The letters of the axes as strings, for the names in pairs. */
extern const char *const vericut_axis_names[SLOT_COUNT];

/*
 * <Between>: two components, each alone or with all that it carries (Sub1, Sub2), and a tolerance, which is the least
 * clearance. A component that is an axis or the base represents the bodies of its link, a tool holder, shank and
 * cutter, any other component its own bodies, whose `at` points to the component. An attach component, and one that
 * carries the work, also represents fixture and part. fivecheck checks more than such a list: the pairs are added as
 * pairs that are always checked, with their clearances.
 */
bool vericut_pairs_read(struct import_machine *machine, const struct vericut_components *components,
			struct xml_reader *xml);

#endif
