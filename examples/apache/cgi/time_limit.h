/*
 * time_limit.h - ends what takes too long: the reading of an upload, the wait for a processor, a job.
 *
 * When time is up, or when the server ends this process (the client has gone), system calls that wait are interrupted
 * and the job is killed. The process then finishes in the normal way, so it leaves nothing behind.
 */
#ifndef CGI_TIME_LIMIT_H
#define CGI_TIME_LIMIT_H

#include <stdbool.h>
#include <sys/types.h>

void time_limit_init(void);
/* Replaces the limit before it; 0: none. */
void time_limit_set(unsigned seconds);
bool time_limit_is_over(void);
/* This group of processes is killed when time is up; 0: none. */
void time_limit_kills(pid_t group);

#endif
