/* setup_library.h - adds the tools and offsets of the files that a setup names with <tools>. */
#ifndef FIVECHECK_MACHINE_LIBRARY_SETUP_LIBRARY_H
#define FIVECHECK_MACHINE_LIBRARY_SETUP_LIBRARY_H

#include "base/diag.h"
#include "machine/description.h"

/*
 * Reads each library of the description and appends its contents to the setup's own tools and offsets. The values of a
 * tool table become those of the tools with their numbers. A fault inside a library is reported at its own place, and
 * then at the <tools> that names the library. A library outside the folder `root` is an error and not opened; NULL: any
 * folder is permitted.
 */
void setup_library_add(struct setup_description *described, const char *root, struct diag *diag);

#endif
