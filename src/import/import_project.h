/* import_project.h - the jobs in a file of another program: a machine, and setups with programs. */
#ifndef FIVECHECK_IMPORT_IMPORT_PROJECT_H
#define FIVECHECK_IMPORT_IMPORT_PROJECT_H

#include <stddef.h>

#include "import/import.h"

/* One setup. Its texts are in the arena of `bodies`. */
struct import_setup {
	const char *name;	/* letters, digits and "._-"; unique in the project */
	/* Fixtures, parts and the stock, as bodies of the workholding, with their roles; and the tasks for the user. */
	struct import_machine bodies;
	struct work_offset_description *offsets;
	size_t offset_count;
	const char *library;	/* the tool library, as it can be opened; or NULL */
	const char **programs;	/* can be opened from any folder; one that is missing: as it was written */
	size_t program_count;
};

struct import_project {
	struct import_machine machine;
	struct import_setup *setups;	/* owned, at least 1 */
	size_t setup_count;
};

/* All zero is an empty project. */
void import_project_release(struct import_project *project);

#endif
