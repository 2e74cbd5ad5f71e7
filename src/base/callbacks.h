/* callbacks.h - what long work asks and tells its caller on the way. */
#ifndef FIVECHECK_BASE_CALLBACKS_H
#define FIVECHECK_BASE_CALLBACKS_H

#include <stdbool.h>

/* Called with each file that a program opens besides its own, once a program and file, from any thread. */
typedef void file_opened_fn(void *context, const char *path);

struct file_opened {
	void *context;
	file_opened_fn *call;
};

/* Is the work under way to be given up? Called from any thread; once the answer is yes it stays yes. */
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
