/*
 * missing.c - functions of POSIX that wasi-libc lacks, for a host whose files are a tree without links
 * (src/web/app/wasi.js).
 */
#include <errno.h>
#include <fcntl.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

/* No file of this host is a terminal: there are no questions, and no line is renewed. */
int isatty(int fd)
{
	(void)fd;
	errno = ENOTTY;
	return 0;
}

/* Appends the next part of a path to the part resolved so far, which has no slash at its end. */
static void append(char *resolved, const char *part, size_t length)
{
	size_t at = strlen(resolved);

	if (length == 0 || (length == 1 && part[0] == '.'))
		return;
	if (length == 2 && part[0] == '.' && part[1] == '.') {
		char *slash = strrchr(resolved, '/');

		if (slash)
			*slash = '\0';
		return;
	}
	resolved[at++] = '/';
	memcpy(resolved + at, part, length);
	resolved[at + length] = '\0';
}

static void append_all(char *resolved, const char *path)
{
	while (*path) {
		size_t length = strcspn(path, "/");

		append(resolved, path, length);
		path += length;
		path += *path == '/';
	}
}

/* `resolved` must be NULL, as POSIX recommends. */
char *realpath(const char *path, char *resolved)
{
	char *folder = *path == '/' ? NULL : getcwd(NULL, 0);
	struct stat status;

	if (resolved || !*path) {
		errno = *path ? EINVAL : ENOENT;
		free(folder);
		return NULL;
	}
	resolved = malloc(strlen(path) + (folder ? strlen(folder) : 0) + 3);
	if (resolved) {
		*resolved = '\0';
		if (folder)
			append_all(resolved, folder);
		append_all(resolved, path);
		if (!*resolved)
			strcpy(resolved, "/");
		if (stat(resolved, &status)) {
			free(resolved);
			resolved = NULL;
		}
	}
	free(folder);
	return resolved;
}

/* There is no other process, so any unused name will do. */
FILE *wasi_tmpfile(void)
{
	char name[] = "/tmp/record-0000";
	struct stat status;

	for (int i = 0; i < 10000; i++) {
		FILE *file;

		snprintf(name, sizeof(name), "/tmp/record-%04d", i);
		if (stat(name, &status) == 0)
			continue;
		file = fopen(name, "w+b");
		if (file)
			unlink(name);
		return file;
	}
	errno = EEXIST;
	return NULL;
}

/* The host writes at once, so closing a file reports no errors. The copy is of "/", which always exists. */
int dup(int fd)
{
	struct stat status;

	return fstat(fd, &status) ? -1 : open("/", O_RDONLY | O_DIRECTORY);
}
