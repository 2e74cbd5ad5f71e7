/* interrupt.h - the interrupt key (SIGINT) ends a check with a report of the findings so far. */
#ifndef FIVECHECK_CLI_INTERRUPT_H
#define FIVECHECK_CLI_INTERRUPT_H

#include <stdbool.h>

/* From now on the first SIGINT is recorded and a second one ends the process. SIGALRM is used, too. */
void interrupt_watch(void);

/* Did SIGINT come? */
bool interrupt_seen(void);

/* Did SIGINT come more than a second ago? Then running work must stop. */
bool interrupt_presses(void);

#endif
