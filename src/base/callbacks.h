/* callbacks.h - callbacks of long work to its caller. */
#ifndef FIVECHECK_BASE_CALLBACKS_H
#define FIVECHECK_BASE_CALLBACKS_H

#include <stdbool.h>

/* Called for each file that a program opens besides its own, once for each program and file, from any thread. */
typedef void file_opened_fn(void *context, const char *path);

struct file_opened {
	void *context;
	file_opened_fn *call;
};

/* Should the present work be given up? Called from any thread; after the first yes the answer stays yes. */
typedef bool cancel_fn(void *context);

struct cancel {
	void *context;
	cancel_fn *call;
};

/* A null callback never cancels. */
static inline bool cancel_asked(const struct cancel *cancel)
{
	return cancel && cancel->call(cancel->context);
}

#endif
