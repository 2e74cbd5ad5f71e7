#include "report/format/uri.h"

#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include "base/mem.h"

/* The current folder, which the caller frees; NULL: unknown. */
static char *current_folder(void)
{
	size_t size = 256;
	char *folder = mem_alloc(size);

	while (!getcwd(folder, size)) {
		if (size > 1 << 20) {
			free(folder);
			return NULL;
		}
		size *= 2;
		folder = mem_realloc(folder, size, 1);
	}
	return folder;
}

/* The rest of an absolute path that begins with the current folder; NULL: the path does not begin with it. */
static const char *below_current(const char *path)
{
	char *folder = current_folder();
	size_t length = folder ? strlen(folder) : 0;
	const char *rest = NULL;

	if (folder && !strncmp(path, folder, length) && path[length] == '/')
		rest = path + length + 1;
	free(folder);
	return rest && *rest ? rest : NULL;
}

void uri_add(struct strbuf *out, const char *path)
{
	static const char plain[] = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789-._~/";
	const char *rest = path[0] == '/' ? below_current(path) : NULL;

	if (rest)
		path = rest;
	while (!strncmp(path, "./", 2) && path[2])
		path += 2;
	if (path[0] == '/')
		strbuf_addf(out, "file://");
	for (; *path; path++) {
		if (strchr(plain, *path))
			strbuf_add(out, path, 1);
		else
			strbuf_addf(out, "%%%02X", (unsigned)(unsigned char)*path);
	}
}
