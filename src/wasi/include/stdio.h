/* stdio.h - that of wasi-libc, and tmpfile. */
#ifndef FIVECHECK_WASI_STDIO_H
#define FIVECHECK_WASI_STDIO_H

#include_next <stdio.h>

FILE *wasi_tmpfile(void);
#define tmpfile wasi_tmpfile

#endif
