/* interrupt.h - the interrupt key (SIGINT) ends a check in good order: findings so far are reported. */
#ifndef FIVECHECK_CLI_INTERRUPT_H
#define FIVECHECK_CLI_INTERRUPT_H

#include <stdbool.h>

/* From now on the first SIGINT is recorded and a second one ends the process. SIGALRM is used, too. */
void interrupt_watch(void);

/* Has SIGINT come? */
bool interrupt_seen(void);

/* Has SIGINT come more than a second ago? Then work that is still under way must be broken off. */
bool interrupt_presses(void);

#endif
