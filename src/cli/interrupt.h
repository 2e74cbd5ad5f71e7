/* interrupt.h - the user's interrupt key ends a check in good order: what was found, and how far it came. */
#ifndef FIVECHECK_CLI_INTERRUPT_H
#define FIVECHECK_CLI_INTERRUPT_H

#include <stdbool.h>

/* From now on the first SIGINT is only noted; the second ends the process as ever. */
void interrupt_watch(void);

bool interrupt_seen(void);

#endif
