#define _XOPEN_SOURCE 700
#include "time_limit.h"

#include <signal.h>
#include <unistd.h>

/* A signal handler can see only global variables. */
static volatile sig_atomic_t job, over;

/* The signal comes again a second later, for a wait that began just after it. */
static void on_end(int number)
{
	(void)number;
	over = 1;
	alarm(1);
	if (job > 0)
		kill(-job, SIGKILL);
}

void time_limit_init(void)
{
	const struct sigaction end = {.sa_handler = on_end};

	sigaction(SIGALRM, &end, NULL);
	sigaction(SIGTERM, &end, NULL);
	sigaction(SIGHUP, &end, NULL);
}

void time_limit_set(unsigned seconds)
{
	alarm(seconds);
}

bool time_limit_is_over(void)
{
	return over;
}

void time_limit_kills(pid_t group)
{
	job = group;
	if (group > 0 && over)
		kill(-group, SIGKILL);
}
