/* For O_PATH, where the system has it. */
#define _GNU_SOURCE

#include "base/path_sandbox.h"

#include <errno.h>
#include <fcntl.h>
#include <stddef.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include "base/mem.h"

/* A folder on the way need not be readable. */
#ifdef O_PATH
#define PASS_THROUGH (O_PATH | O_DIRECTORY | O_CLOEXEC)
#else
#define PASS_THROUGH (O_RDONLY | O_DIRECTORY | O_CLOEXEC)
#endif

#define READ_ONLY (O_RDONLY | O_NONBLOCK | O_NOCTTY | O_CLOEXEC)

/* The resolved path of the file or, if it is missing, of its folder; NULL: both are missing. */
static char *resolve(const char *path)
{
	const char *slash = strrchr(path, '/');
	char *real = realpath(path, NULL), *folder;

	if (real)
		return real;
	folder = slash ? mem_strndup(path, (size_t)(slash - path) + 1) : mem_strndup(".", 1);
	real = realpath(folder, NULL);
	free(folder);
	return real;
}

/* The part of a resolved path below a resolved root, without a slash at its start; NULL: the path is not below it. */
static char *below(const char *root, char *path)
{
	size_t length = strlen(root);

	if (strncmp(root, path, length) != 0)
		return NULL;
	/* The root of all files ends in a slash, other roots do not. */
	if (root[length - 1] == '/')
		return path + length;
	return path[length] == '/' ? path + length + 1 : path[length] == '\0' ? path + length : NULL;
}

bool path_sandbox_holds(const char *root, const char *path)
{
	char *outer, *inner;
	bool holds;

	if (!root)
		return true;
	outer = realpath(root, NULL);
	inner = resolve(path);
	holds = outer && inner && below(outer, inner);
	free(outer);
	free(inner);
	return holds;
}

/* Step by step along a path without links: a link that has appeared since is not followed. */
static int walk(int folder, char *path)
{
	for (char *slash; folder >= 0 && (slash = strchr(path, '/')); path = slash + 1) {
		int outer = folder;

		*slash = '\0';
		folder = openat(outer, path, PASS_THROUGH | O_NOFOLLOW);
		close(outer);
	}
	if (folder >= 0) {
		int file = openat(folder, *path ? path : ".", READ_ONLY | O_NOFOLLOW);
		int error = errno;

		close(folder);
		errno = error;
		return file;
	}
	return -1;
}

int path_sandbox_open(const char *root, const char *path)
{
	char *outer, *inner, *rest;
	int fd = -1, error;

	if (!root)
		return open(path, READ_ONLY);
	outer = realpath(root, NULL);
	inner = outer ? realpath(path, NULL) : NULL;
	if (inner) {
		rest = below(outer, inner);
		errno = EXDEV;
		fd = rest ? walk(open(outer, PASS_THROUGH | O_NOFOLLOW), rest) : -1;
		/* A link or something other than a folder has replaced a folder. */
		if (fd < 0 && (errno == ELOOP || errno == ENOTDIR))
			errno = EXDEV;
	}
	error = errno;
	free(outer);
	free(inner);
	errno = error;
	return fd;
}
