/* stdlib.h - that of wasi-libc, and realpath. */
#ifndef FIVECHECK_WASI_STDLIB_H
#define FIVECHECK_WASI_STDLIB_H

#include_next <stdlib.h>

char *realpath(const char *path, char *resolved);

#endif
