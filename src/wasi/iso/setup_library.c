/* setup_library.c - in place of src/machine/library: the tool libraries of other programs. */
#include "machine/library/setup_library.h"

#include "wasi/other_module.h"

void setup_library_add(struct setup_description *described, const char *root, struct diag *diag)
{
	(void)root;
	(void)diag;
	if (described->library_count)
		other_module();
}
