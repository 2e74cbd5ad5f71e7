/*
 * other_module.h - a module was asked for something that it has not: the smaller one for what only the module with
 * everything has, or either for a report without the script of the viewer. The run ends at once, with a status that
 * fivecheck(1) has not.
 */
#ifndef FIVECHECK_WASI_OTHER_MODULE_H
#define FIVECHECK_WASI_OTHER_MODULE_H

#include <stdlib.h>

/* STATUS.OTHER_MODULE of src/web/app/fivecheck.js. */
enum { STATUS_OTHER_MODULE = 4 };

_Noreturn static inline void other_module(void)
{
	exit(STATUS_OTHER_MODULE);
}

#endif
