/* signal.h - for WebAssembly, which has no signals: no handler can be set, and none is ever called. */
#ifndef FIVECHECK_WASI_SIGNAL_H
#define FIVECHECK_WASI_SIGNAL_H

#include <errno.h>

typedef void signal_fn(int signal_number);

#define SIGINT 2
#define SIGABRT 6
#define SIGPIPE 13
#define SIGALRM 14
#define SIGXFSZ 25
#define SIG_DFL ((signal_fn *)0)
#define SIG_IGN ((signal_fn *)1)
#define SIG_ERR ((signal_fn *)-1)
#define SA_RESTART 1
#define SA_RESETHAND 2

typedef int sig_atomic_t;

struct sigaction {
	signal_fn *sa_handler;
	int sa_flags;
};

static inline signal_fn *signal(int signal_number, signal_fn *handler)
{
	(void)signal_number;
	(void)handler;
	return SIG_ERR;
}

static inline int sigaction(int signal_number, const struct sigaction *action, struct sigaction *old)
{
	(void)signal_number;
	(void)action;
	(void)old;
	errno = ENOSYS;
	return -1;
}

static inline unsigned alarm(unsigned seconds)
{
	(void)seconds;
	return 0;
}

#endif
