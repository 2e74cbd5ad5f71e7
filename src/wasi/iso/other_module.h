/*
 * other_module.h - the smaller module was asked for something that only the module with everything has. The run ends
 * at once, with a status that fivecheck(1) has not.
 */
#ifndef FIVECHECK_WASI_ISO_OTHER_MODULE_H
#define FIVECHECK_WASI_ISO_OTHER_MODULE_H

#include <stdlib.h>

/* STATUS.OTHER_MODULE of src/web/app/fivecheck.js. */
enum { STATUS_OTHER_MODULE = 4 };

_Noreturn static inline void other_module(void)
{
	exit(STATUS_OTHER_MODULE);
}

#endif
