/* run_status.h - the exit status of the program. */
#ifndef FIVECHECK_CLI_RUN_STATUS_H
#define FIVECHECK_CLI_RUN_STATUS_H

/* The greatest of several statuses is the status of the whole run. */
enum run_status {
	RUN_CLEAR = 0,
	RUN_FOUND = 1,
	RUN_INCOMPLETE = 2,	/* wrong usage, unreadable or unsupported input, output that could not be written */
	RUN_INTERNAL = 3
};

#endif
