#define _XOPEN_SOURCE 700
#include "archive.h"

#include <errno.h>
#include <fcntl.h>
#include <stdbool.h>
#include <stdio.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

#include "request.h"
#include "safe_path.h"

enum {
	FILES_MAX = 1000, /* and folders */
	RECORD = 512 /* bytes: the unit of a tar archive */
};

/* Octal digits, which a space or 0 ends. -1: malformed. */
static long octal(const char *field, size_t length)
{
	long value = 0;
	size_t i = 0;

	while (i < length && field[i] == ' ')
		i++;
	for (; i < length && field[i] >= '0' && field[i] <= '7'; i++) {
		if (value > 1L << 40)
			return -1;
		value = 8 * value + (field[i] - '0');
	}
	return i < length && field[i] != ' ' && field[i] != '\0' ? -1 : value;
}

static bool has_checksum(const char *head)
{
	long sum = 0;

	for (int i = 0; i < RECORD; i++)
		sum += i >= 148 && i < 156 ? ' ' : (unsigned char)head[i];
	return octal(head + 148, 8) == sum;
}

static void count_one(int *files, struct request *request)
{
	if (++*files > FILES_MAX)
		request_refuse(request, "413 Content Too Large", "the archive has more than %d files and folders",
			       FILES_MAX);
}

/* Each folder counts: the name of one empty file can hold a hundred of them. */
static void make_folder(const char *path, int *files, struct request *request)
{
	if (mkdir(path, 0700) == 0)
		count_one(files, request);
	else if (errno != EEXIST)
		request_refuse(request, "400 Bad Request", "a name in the archive is used twice");
}

static void make_folders(char *path, int *files, struct request *request)
{
	for (char *slash = strchr(path, '/'); slash; slash = strchr(slash + 1, '/')) {
		*slash = '\0';
		make_folder(path, files, request);
		*slash = '/';
	}
}

static void unpack_file(const char *path, long size, struct request *request)
{
	int fd = open(path, O_WRONLY | O_CREAT | O_EXCL | O_NOFOLLOW | O_CLOEXEC, 0600);
	char record[RECORD];

	if (fd < 0)
		request_refuse(request, "400 Bad Request", "a name in the archive is used twice");
	for (; size > 0; size -= RECORD) {
		size_t count = size < RECORD ? (size_t)size : RECORD;

		if (!request_read(request, record, RECORD))
			request_refuse(request, "400 Bad Request", "the archive is cut off");
		if (write(fd, record, count) != (ssize_t)count)
			request_refuse(request, "507 Insufficient Storage", "there is no room for the upload");
	}
	close(fd);
}

/* The name in a header: the prefix of ustar, a slash, the name; without the dot that tar may begin with. */
static void name_of(const char *head, char path[PATH_LENGTH + 101])
{
	char full[300];
	const char *from = full;
	size_t length;

	if (memcmp(head + 257, "ustar", 5) == 0 && head[345])
		snprintf(full, sizeof(full), "%.155s/%.100s", head + 345, head);
	else
		snprintf(full, sizeof(full), "%.100s", head);
	if (from[0] == '.' && from[1] == '/')
		from += 2;
	length = strlen(from);
	if (length && from[length - 1] == '/')
		length--;
	snprintf(path, PATH_LENGTH + 101, "%.*s", (int)length, from);
}

void archive_unpack(struct request *request)
{
	char head[RECORD], path[PATH_LENGTH + 101];
	int files = 0;

	while (request->unread > 0 && request_read(request, head, RECORD) && head[0]) {
		long size = octal(head + 124, 12);
		char kind = head[156];

		if (!has_checksum(head) || size < 0)
			request_refuse(request, "400 Bad Request",
				       "this is no tar archive; make it with tar --format=ustar");
		if (kind != '0' && kind != '\0' && kind != '5')
			request_refuse(request, "400 Bad Request",
				       "the archive has a link, a device, or a form of tar that is not read here "
				       "(tar --format=ustar)");
		name_of(head, path);
		if (kind == '5' && (!*path || !strcmp(path, ".")))
			continue;
		if (!is_safe_path(path))
			request_refuse(request, "400 Bad Request",
				       "the archive has a name that is not allowed: it leads elsewhere, or begins "
				       "with a dot or a dash");
		make_folders(path, &files, request);
		if (kind == '5') {
			make_folder(path, &files, request);
		} else {
			count_one(&files, request);
			unpack_file(path, size, request);
		}
	}
	/* Nothing follows that matters, but the server wants to hand over the whole body. */
	request_discard(request);
}
