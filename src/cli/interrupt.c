#include "cli/interrupt.h"

#include <signal.h>
#include <stdatomic.h>
#include <stddef.h>
#include <unistd.h>

/* s: current work usually ends within this time and can still report its findings. */
#define GRACE 1

/* Signal handlers receive no state, so these are the only mutable globals. Atomic, because threads read them. */
static atomic_int seen, pressing;

static void on_interrupt(int signal_number)
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
	struct sigaction action = {.sa_handler = on_interrupt, .sa_flags = (int)SA_RESETHAND};
	struct sigaction late = {.sa_handler = press, .sa_flags = SA_RESTART};
	struct sigaction old;

	/* A job in the background ignores SIGINT. Without SA_RESTART the signal also ends a read that waits. */
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
