#include "import/mesh_file.h"

#include <dirent.h>
#include <stdio.h>
#include <string.h>
#include <strings.h>
#include <unistd.h>

#include "geom/stl.h"
#include "import/vericut_mesh.h"

/* The length of the next part of a path. */
static size_t part_length(const char *path)
{
	return strcspn(path, "/\\");
}

static bool is_harmless(const char *part, size_t length)
{
	return length > 0 && strncmp(part, ".", length) != 0 && strncmp(part, "..", length) != 0;
}

/* Appends the entry of the folder whose name is the part, whatever its case; the exact name is preferred. */
static bool add_entry(struct strbuf *path, const char *part, size_t length)
{
	size_t before = path->length;
	struct dirent *entry;
	bool found = false;
	DIR *folder;

	strbuf_addf(path, "/%.*s", (int)length, part);
	if (access(strbuf_text(path), F_OK) == 0)
		return true;
	path->text[path->length = before] = '\0';
	folder = opendir(strbuf_text(path));
	while (folder && !found && (entry = readdir(folder))) {
		found = strlen(entry->d_name) == length && !strncasecmp(entry->d_name, part, length);
		if (found)
			strbuf_addf(path, "/%s", entry->d_name);
	}
	if (folder)
		closedir(folder);
	return found;
}

/* Is the relative path there, below what *path holds? */
static bool follow(struct strbuf *path, const char *relative)
{
	while (*relative) {
		size_t length = part_length(relative);

		if (!is_harmless(relative, length) || !add_entry(path, relative, length))
			return false;
		relative += length;
		relative += strspn(relative, "/\\");
	}
	return true;
}

static bool find_below(struct strbuf *found, const char *folder, size_t length, const char *written)
{
	for (const char *end = written; *end;) {
		strbuf_clear(found);
		strbuf_add(found, folder, length);
		if (follow(found, end))
			return true;
		end += part_length(end);
		end += strspn(end, "/\\");
	}
	return false;
}

bool mesh_file_find(struct strbuf *found, const char *folder, const char *file, const char *written)
{
	const char *slash = file ? strrchr(file, '/') : NULL;

	if (folder && find_below(found, folder, strlen(folder), written))
		return true;
	if (!file)
		return false;
	return slash ? find_below(found, file, (size_t)(slash - file), written) : find_below(found, ".", 1, written);
}

static bool is_vericut(const char *path)
{
	char bytes[16];
	FILE *file = fopen(path, "re");
	size_t count = file ? fread(bytes, 1, sizeof(bytes), file) : 0;

	if (file)
		fclose(file);
	return vericut_mesh_is(bytes, count);
}

bool mesh_file_read(struct mesh *out, const char *path, double scale, struct diag *diag)
{
	if (is_vericut(path))
		return vericut_mesh_read(out, path, scale, diag);
	if (!stl_read(out, path, diag))
		return false;
	mesh_scale(out, scale);
	return true;
}
