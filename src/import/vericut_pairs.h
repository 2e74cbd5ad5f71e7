/* vericut_pairs.h - the collision list of a VERICUT machine. */
#ifndef FIVECHECK_IMPORT_VERICUT_PAIRS_H
#define FIVECHECK_IMPORT_VERICUT_PAIRS_H

#include <stdbool.h>

#include "base/axes.h"
#include "import/import.h"
#include "import/vericut_components.h"

/* The letters of the axes as strings, as pairs name them. */
extern const char *const vericut_axis_names[SLOT_COUNT];

/*
 * <Between>: two components, each alone or with all that it carries (Sub1, Sub2), and a tolerance, which is the least
 * clearance. A component that is an axis or the base stands for the bodies of its link, a tool for holder, shank and
 * cutter, any other component for its own bodies, whose `at` points to the component. An attach, and what carries the
 * work, stands for fixture and part, too. fivecheck checks more than such a list: the pairs are added as those that are
 * checked in any case, with their clearances.
 */
bool vericut_pairs_read(struct import_machine *machine, const struct vericut_components *components,
			struct xml_reader *xml);

#endif
