/* unistd.h - that of wasi-libc, and dup. */
#ifndef FIVECHECK_WASI_UNISTD_H
#define FIVECHECK_WASI_UNISTD_H

#include_next <unistd.h>

/* Duplicates an open file, for close() only. */
int dup(int fd);

#endif
