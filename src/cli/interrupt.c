#include "cli/interrupt.h"

#include <signal.h>
#include <stdatomic.h>
#include <stddef.h>
#include <unistd.h>

/* s: what usually takes less is finished, so that its findings are told. */
#define GRACE 1

/* The one thing that a signal handler can reach: it is handed no state. Atomic, as threads ask, too. */
static atomic_int seen, pressing;

static void note(int signal_number)
{
	(void)signal_number;
	seen = 1;
	alarm(GRACE);
}

static void press(int signal_number)
{
	(void)signal_number;
	pressing = 1;
}

void interrupt_watch(void)
{
	struct sigaction action = {.sa_handler = note, .sa_flags = (int)SA_RESETHAND};
	struct sigaction late = {.sa_handler = press, .sa_flags = SA_RESTART};
	struct sigaction old;

	/* Who starts a job in the background has SIGINT ignored. Without SA_RESTART a read that waits ends, too. */
	if (sigaction(SIGINT, NULL, &old) == 0 && old.sa_handler != SIG_IGN) {
		sigaction(SIGALRM, &late, NULL);
		sigaction(SIGINT, &action, NULL);
	}
}

bool interrupt_seen(void)
{
	return seen != 0;
}

bool interrupt_presses(void)
{
	return pressing != 0;
}
