#include "import/mesh_file.h"

#include <dirent.h>
#include <fcntl.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

#include "base/ascii.h"
#include "base/has_ending.h"
#include "geom/stl.h"
#include "import/mesh_helper.h"
#include "import/ply_check.h"
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

/* Appends the entry of the folder with this name, in upper or lower case; the exact name is preferred. */
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
		found = strlen(entry->d_name) == length && ascii_same_start(entry->d_name, part, length);
		if (found)
			strbuf_addf(path, "/%s", entry->d_name);
	}
	if (folder)
		closedir(folder);
	return found;
}

/* Does the relative path exist below *path? */
static bool follow_path(struct strbuf *path, const char *relative)
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
		if (follow_path(found, end))
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

/* Reads the first bytes of a regular file; returns their number. Opening a FIFO must not wait for its writer. */
static size_t read_head(const char *path, char *bytes, size_t size)
{
	const int fd = open(path, O_RDONLY | O_CLOEXEC | O_NONBLOCK | O_NOCTTY);
	struct stat status;
	ssize_t count = 0;

	if (fd < 0)
		return 0;
	if (fstat(fd, &status) == 0 && S_ISREG(status.st_mode))
		count = read(fd, bytes, size);
	close(fd);
	return count > 0 ? (size_t)count : 0;
}

static bool is_vericut(const char *path)
{
	char bytes[16];

	return vericut_mesh_is(bytes, read_head(path, bytes, sizeof(bytes)));
}

enum mesh_format mesh_file_format(const char *path)
{
	char bytes[5] = "";
	const size_t count = read_head(path, bytes, sizeof(bytes) - 1);

	if (count == 4 && !memcmp(bytes, "glTF", 4))
		return MESH_GLTF;
	if (count == 4 && !memcmp(bytes, "PK\003\004", 4))
		return has_ending(path, ".3mf") ? MESH_3MF : MESH_OTHER;
	if (count == 4 && !memcmp(bytes, "ply", 3) && strchr("\r\n", bytes[3]))
		return MESH_PLY;
	if (has_ending(path, ".gltf"))
		return MESH_GLTF;
	return has_ending(path, ".obj") ? MESH_OBJ : MESH_OTHER;
}

/* All parts of the file as one mesh. */
static bool read_parts(struct mesh *out, const char *path, double scale, struct diag *diag)
{
	struct mesh_build all = {.scale = 1};
	struct mesh_parts parts = {0};
	bool good = (mesh_file_format(path) != MESH_PLY || ply_check(path, diag)) &&
		    mesh_helper_read(&parts, path, scale, false, diag);

	for (size_t i = 0; good && i < parts.count; i++)
		for (size_t t = 0; good && t < parts.items[i].build.mesh.count; t++) {
			const mesh_triangle *triangle = &parts.items[i].build.mesh.triangles[t];
			vec3 corners[3];

			for (int k = 0; k < 3; k++)
				corners[k] = mesh_corner(triangle, k);
			good = mesh_build_add(&all, corners);
		}
	mesh_parts_release(&parts);
	if (good)
		mesh_build_finish(&all, out);
	else
		mesh_build_discard(&all);
	return good;
}

bool mesh_file_read(struct mesh *out, const char *path, double scale, struct diag *diag)
{
	const enum mesh_format format = mesh_file_format(path);

	if (is_vericut(path))
		return vericut_mesh_read(out, path, scale, diag);
	if (format == MESH_OBJ || format == MESH_PLY)
		return read_parts(out, path, scale, diag);
	if (format != MESH_OTHER) {
		diag_error(diag, (struct srcloc){.file = path},
			   "such a mesh has its own units: convert it to STL with 'fivecheck import', and name the "
			   "STL");
		return false;
	}
	if (!stl_read(out, path, diag))
		return false;
	mesh_scale(out, scale);
	return true;
}
