/* interrupt.h - the user's interrupt key ends a check in good order: what was found, and how far it came. */
#ifndef FIVECHECK_CLI_INTERRUPT_H
#define FIVECHECK_CLI_INTERRUPT_H

#include <stdbool.h>

/* From now on the first SIGINT is only noted, and SIGALRM is taken; the second ends the process as ever. */
void interrupt_watch(void);

bool interrupt_seen(void);

/* Has what was under way then had its time to come to an end? */
bool interrupt_presses(void);

#endif
