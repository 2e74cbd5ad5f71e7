#include "cli/interrupt.h"

#include <signal.h>
#include <stddef.h>

/* The one thing that a signal handler can reach: it is handed no state. */
static volatile sig_atomic_t seen;

static void note(int signal_number)
{
	(void)signal_number;
	seen = 1;
}

void interrupt_watch(void)
{
	struct sigaction action = {.sa_handler = note, .sa_flags = (int)SA_RESETHAND};
	struct sigaction old;

	/* Who starts a job in the background has SIGINT ignored. Without SA_RESTART a read that waits ends, too. */
	if (sigaction(SIGINT, NULL, &old) == 0 && old.sa_handler != SIG_IGN)
		sigaction(SIGINT, &action, NULL);
}

bool interrupt_seen(void)
{
	return seen != 0;
}
