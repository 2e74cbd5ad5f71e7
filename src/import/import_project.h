/* import_project.h - what a file of another program says of jobs: a machine, and setups with programs. */
#ifndef FIVECHECK_IMPORT_IMPORT_PROJECT_H
#define FIVECHECK_IMPORT_IMPORT_PROJECT_H

#include <stddef.h>

#include "import/import.h"

/* One setup. Its texts are in the arena of `bodies`. */
struct import_setup {
	const char *name;	/* letters, digits and "._-"; unique in the project */
	/* Fixtures, parts and the stock, as bodies of the workholding, with their roles; and what is left to do. */
	struct import_machine bodies;
	struct work_offset_description *offsets;
	size_t offset_count;
	const char *library;	/* the tool library, as it can be opened; or NULL */
	const char **programs;	/* as they are called from anywhere; one that is not there: as it was written */
	size_t program_count;
};

struct import_project {
	struct import_machine machine;
	struct import_setup *setups;	/* owned, at least 1 */
	size_t setup_count;
};

/* All zero is empty. */
void import_project_release(struct import_project *project);

#endif
