/* sys/ioctl.h - for WebAssembly: that of wasi-libc, and the size of a terminal, although there is none. */
#ifndef FIVECHECK_WASI_SYS_IOCTL_H
#define FIVECHECK_WASI_SYS_IOCTL_H

#include_next <sys/ioctl.h>

#define TIOCGWINSZ 0x5413

struct winsize {
	unsigned short ws_row, ws_col;
};

#endif
