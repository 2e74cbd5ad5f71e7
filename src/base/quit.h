/* quit.h - asks, in the middle of long work, whether it has become pointless. */
#ifndef FIVECHECK_BASE_QUIT_H
#define FIVECHECK_BASE_QUIT_H

#include <stdbool.h>

/* Asked from any thread; once the answer is yes it stays yes. */
struct quit {
	void *context;
	bool (*asked)(void *context);
};

/* Who brings nobody to ask goes on. */
static inline bool quit_asked(const struct quit *quit)
{
	return quit && quit->asked(quit->context);
}

#endif
