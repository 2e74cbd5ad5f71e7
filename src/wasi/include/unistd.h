/* unistd.h - wasi-libc's, and dup. */
#ifndef FIVECHECK_WASI_UNISTD_H
#define FIVECHECK_WASI_UNISTD_H

#include_next <unistd.h>

/* Of an open file, for close() alone. */
int dup(int fd);

#endif
