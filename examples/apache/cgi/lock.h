/*
 * lock.h - locks that all requests share: at most so many of them unpack an upload, or use a processor, at a time.
 */
#ifndef CGI_LOCK_H
#define CGI_LOCK_H

struct request;

/*
 * Takes one of `count` locks of this name in the folder `work`. If all are taken, it waits for one, and refuses the
 * request with the message `none` when time is up. Closing the descriptor gives the lock back.
 */
int lock_take(const char *work, const char *name, long count, const char *none, struct request *request);
/* One lock for each processor. */
int lock_take_processor(const char *work, struct request *request);

#endif
