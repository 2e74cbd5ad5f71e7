/*
 * vericut_project.h - reads the project files of VERICUT 7 (.VcProject), which are XML with the root VcProject: a
 * machine, and setups with fixtures, stock, design, work offsets, tools and programs.
 */
#ifndef FIVECHECK_IMPORT_VERICUT_PROJECT_H
#define FIVECHECK_IMPORT_VERICUT_PROJECT_H

#include <stdbool.h>

#include "import/import_project.h"

/*
 * All setups must be of one machine. A work offset that is given by From and To becomes the place of To, reached by the
 * gauge point: the values of X, Y and Z, with every rotary axis at 0. Data that is not imported causes a warning and a
 * note in `todo`. False, reported: a file is faulty, or missing, or contains something that cannot be converted.
 */
bool vericut_project_read(struct import_project *project, const char *path, const struct import_options *options,
			  struct diag *diag);

#endif
