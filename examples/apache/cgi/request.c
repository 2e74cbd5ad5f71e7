#define _XOPEN_SOURCE 700
#include "request.h"

#include <ftw.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

#include "time_limit.h"

void request_make_folder(struct request *request, const char *work)
{
	snprintf(request->folder, sizeof(request->folder), "%.400s/job-XXXXXX", work);
	if (!mkdtemp(request->folder)) {
		*request->folder = '\0';
		request_refuse(request, "500 Internal Server Error", "the folder of the checker cannot be written to");
	}
	if (chdir(request->folder))
		request_refuse(request, "500 Internal Server Error", "the folder of the job was lost");
}

static int remove_one(const char *path, const struct stat *status, int flag, struct FTW *where)
{
	(void)status;
	(void)flag;
	(void)where;
	return remove(path);
}

void request_remove_folder(struct request *request)
{
	if (*request->folder && chdir("/") == 0)
		nftw(request->folder, remove_one, 16, FTW_DEPTH | FTW_PHYS);
	*request->folder = '\0';
}

bool request_read(struct request *request, char *to, size_t count)
{
	if ((long)count > request->unread || fread(to, 1, count, stdin) != count)
		return false;
	request->unread -= (long)count;
	return true;
}

void request_discard(struct request *request)
{
	while (!time_limit_is_over() && request->unread > 0 && getchar() != EOF)
		request->unread--;
}

void request_refuse(struct request *request, const char *status, const char *format, ...)
{
	va_list arguments;

	request_remove_folder(request);
	/* A server that cannot hand over the whole body may drop the answer. */
	request_discard(request);
	printf("Status: %s\r\nContent-Type: text/plain; charset=utf-8\r\nCache-Control: no-store\r\n", status);
	if (!strncmp(status, "503", 3))
		printf("Retry-After: 10\r\n");
	printf("\r\n");
	va_start(arguments, format);
	vprintf(format, arguments);
	va_end(arguments);
	printf("\n");
	exit(EXIT_SUCCESS);
}
