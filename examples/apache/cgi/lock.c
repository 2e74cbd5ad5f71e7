#define _DEFAULT_SOURCE
#include "lock.h"

#include <fcntl.h>
#include <stdio.h>
#include <sys/file.h>
#include <unistd.h>

#include "request.h"
#include "time_limit.h"

enum { SLOTS_MAX = 64 };

int lock_take(const char *work, const char *name, long count, const char *none, struct request *request)
{
	int last = -1;

	for (long i = 0; i < count; i++) {
		char path[600];

		snprintf(path, sizeof(path), "%s/%s-%ld", work, name, (getpid() + i) % count);
		if (last >= 0)
			close(last);
		last = open(path, O_RDWR | O_CREAT | O_CLOEXEC | O_NOFOLLOW, 0600);
		if (last < 0)
			request_refuse(request, "500 Internal Server Error",
				       "the folder of the checker cannot be written to");
		if (flock(last, LOCK_EX | LOCK_NB) == 0)
			return last;
	}
	if (time_limit_is_over() || flock(last, LOCK_EX))
		request_refuse(request, "503 Service Unavailable", "%s; try again", none);
	return last;
}

int lock_take_processor(const char *work, struct request *request)
{
	long count = sysconf(_SC_NPROCESSORS_ONLN);

	if (count < 1)
		count = 1;
	if (count > SLOTS_MAX)
		count = SLOTS_MAX;
	return lock_take(work, "slot", count, "all processors are at work", request);
}
