/* realpath is an XSI extension. */
#define _XOPEN_SOURCE 700

#include "base/confine.h"

#include <stddef.h>
#include <stdlib.h>
#include <string.h>

#include "base/mem.h"

/* The resolved path of the file or, if there is none, of its folder; NULL: neither is there. */
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

bool confine_holds(const char *root, const char *path)
{
	char *outer, *inner;
	size_t length;
	bool holds;

	if (!root)
		return true;
	outer = realpath(root, NULL);
	inner = resolve(path);
	length = outer ? strlen(outer) : 0;
	/* The root of all files ends in the slash that others lack. */
	holds = outer && inner && strncmp(outer, inner, length) == 0 &&
		(inner[length] == '/' || inner[length] == '\0' || outer[length - 1] == '/');
	free(outer);
	free(inner);
	return holds;
}
