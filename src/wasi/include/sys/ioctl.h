/* sys/ioctl.h - of WebAssembly: wasi-libc's, and the size of a terminal, which nothing here is. */
#ifndef FIVECHECK_WASI_SYS_IOCTL_H
#define FIVECHECK_WASI_SYS_IOCTL_H

#include_next <sys/ioctl.h>

#define TIOCGWINSZ 0x5413

struct winsize {
	unsigned short ws_row, ws_col;
};

#endif
