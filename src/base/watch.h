/* watch.h - who wants to know which files a program opened besides its own. */
#ifndef FIVECHECK_BASE_WATCH_H
#define FIVECHECK_BASE_WATCH_H

/* Called with each file once a program, from any thread. */
struct watch {
	void *context;
	void (*opened)(void *context, const char *path);
};

#endif
