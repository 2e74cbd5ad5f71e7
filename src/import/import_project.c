#include "import/import_project.h"

#include <stdlib.h>

void import_project_release(struct import_project *project)
{
	for (size_t i = 0; i < project->setup_count; i++)
		import_machine_release(&project->setups[i].bodies);
	free(project->setups);
	import_machine_release(&project->machine);
	*project = (struct import_project){0};
}
