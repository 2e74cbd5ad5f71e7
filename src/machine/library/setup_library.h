/* setup_library.h - adds the tools and offsets of the files that a setup names with <tools>. */
#ifndef FIVECHECK_MACHINE_LIBRARY_SETUP_LIBRARY_H
#define FIVECHECK_MACHINE_LIBRARY_SETUP_LIBRARY_H

#include "base/diag.h"
#include "machine/description.h"

/*
 * Reads each library of the description and adds what it holds behind what the setup itself has. The values of a tool
 * table become those of the tools with their numbers. A fault inside of a library is reported at its own place, and
 * then at the <tools> that names the library. A library outside of the folder `root` is an error and not opened; NULL:
 * it may be anywhere.
 */
void setup_library_add(struct setup_description *described, const char *root, struct diag *diag);

#endif
