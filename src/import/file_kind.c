#include "import/file_kind.h"

#include <string.h>

#include "base/file_bytes.h"
#include "base/file_signature.h"
#include "base/has_ending.h"
#include "import/mesh_file.h"
#include "machine/library/library_file.h"
#include "machine/library/vericut_text.h"

/* The text between the start of an XML file and its root element is short. */
#define HEAD_MAX 4096

static const struct {
	const char *root;
	enum file_kind kind;
} xml_roots[] = {
	{"VcMachine", FILE_VERICUT_MACHINE},
	{"robot", FILE_URDF},
	{"VcProject", FILE_VERICUT_PROJECT},
	{"MTConnectDevices", FILE_MTCONNECT},
};

static const char *skip_space(const char *at)
{
	/* The file may begin with a byte order mark. */
	return at + strspn(at, " \t\r\n\xef\xbb\xbf");
}

/* The name of the first element, or NULL. Skips declarations and comments before it. */
static const char *root_name(const char *text)
{
	const char *at = skip_space(text);

	while (at && *at == '<' && (at[1] == '?' || at[1] == '!') && at - text < HEAD_MAX) {
		at = strncmp(at, "<!--", 4) == 0 ? strstr(at, "-->") : strchr(at, '>');
		at = at ? skip_space(strchr(at, '>') + 1) : NULL;
	}
	return at && *at == '<' ? at + 1 : NULL;
}

/* Does the root element of the XML file have this name? */
static bool is_root(const char *text, const char *name)
{
	const char *root = root_name(text);
	size_t length = strlen(name), prefix;

	if (!root)
		return false;
	/* The prefix of a name space. */
	prefix = strcspn(root, ": \t\r\n/>");
	root += root[prefix] == ':' ? prefix + 1 : 0;
	return !strncmp(root, name, length) && root[length] && strchr(" \t\r\n/>", root[length]);
}

/* Is the line the name of a section, such as [DISPLAY]? JSON does not begin like this. */
static bool is_section(const char *line)
{
	size_t name = line[0] == '[' ? strspn(line + 1, "ABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_") : 0;

	return name && line[1 + name] == ']';
}

/* In an ini file the first line with content is a section, or includes a file with sections. */
static bool is_ini(const char *text)
{
	const char *line = skip_space(text);

	while (*line == '#' || *line == ';') {
		if (!strncmp(line, "#INCLUDE ", strlen("#INCLUDE ")))
			return true;
		line = skip_space(line + strcspn(line, "\n"));
	}
	return is_section(line);
}

/* A machine of FreeCAD's CAM workbench: JSON, like tool libraries. */
static bool is_freecad(const char *path, const char *text)
{
	return *skip_space(text) == '{' && (has_ending(path, ".fcm") || strstr(text, "\"freecad_version\"")) &&
	       strstr(text, "\"machine\"");
}

static bool kind_of_text(enum file_kind *kind, const char *path, const char *text)
{
	for (size_t i = 0; i < sizeof(xml_roots) / sizeof(*xml_roots); i++) {
		*kind = xml_roots[i].kind;
		if (is_root(text, xml_roots[i].root))
			return true;
	}
	*kind = FILE_MESH;
	if (mesh_file_format(path) != MESH_OTHER)
		return true;
	*kind = FILE_EMC_MACHINE;
	if (!root_name(text) && is_ini(text))
		return true;
	*kind = FILE_FREECAD;
	if (is_freecad(path, text))
		return true;
	*kind = FILE_TOOLS;
	return library_kind_of(text) != LIBRARY_NONE;
}

/* Files of this program. */
static const char *own_advice(const char *text)
{
	static const char *const roots[] = {"machine", "setup", "jobs", "waivers"};

	for (size_t i = 0; i < sizeof(roots) / sizeof(*roots); i++)
		if (is_root(text, roots[i]))
			return "fivecheck reads this file directly: it needs no import";
	return NULL;
}

/* Advice for a file that cannot be imported. */
static const char *advice(const char *path, const struct file_bytes *file)
{
	const char *text = file->bytes;

	/* Also for a file of white space only. */
	if (skip_space(text) == text + file->count)
		return "this file is empty";
	if (own_advice(text))
		return own_advice(text);
	if (has_ending(path, ".stl"))
		return "an STL file needs no import: name it in a machine file or a setup (mesh=\"\")";
	if (has_ending(path, ".hsmlib"))
		return "this is a tool library of HSMWorks: save it as JSON (Fusion 360 exports it), which can be "
		       "imported";
	if (strstr(text, "(tool_number)"))
		return "this is a table of Fusion 360: export the library as JSON, which can be imported";
	if (has_ending(path, ".csv") || has_ending(path, ".tsv"))
		return "a table of tools needs a first line with the names of its columns: number, with length and "
		       "diameter for tools, or with length_offset and radius_offset for offsets; "
		       "fivecheck-machine(5) lists all names";
	if (has_ending(path, ".step") || has_ending(path, ".stp") || has_ending(path, ".igs") ||
	    has_ending(path, ".iges"))
		return "this is a CAD solid without axes: export each body that moves as STL, with all axes at 0, and "
		       "name the meshes in a machine file ('fivecheck init' writes one as a start)";
	if (!strncmp(text, "PK\003\004", 4))
		return "this is a zip archive: unpack it; a Fusion 360 .tools file contains tools.json, and a GTC "
		       "package .p21 files, which can be imported";
	if (file_signature_advice(text, file->count))
		return file_signature_advice(text, file->count);
	return "import does not know this format. It reads machines (VERICUT 7 .mch and .VcProject, ini files, FreeCAD "
	       ".fcm, MTConnect, URDF), tools (VERICUT .tls, Fusion 360 .json, DIN 4000, ISO 13399, CSV, tool.tbl, "
	       "TOOL.T, $TC_DP), offset listings (G10) and meshes (OBJ, PLY, 3MF, glTF)";
}

bool file_kind_of(enum file_kind *kind, const char *path, struct diag *diag)
{
	struct file_bytes file;
	bool known;

	if (!file_bytes_read(&file, path, diag))
		return false;
	known = kind_of_text(kind, path, file.bytes);
	if (!known && !vericut_text_refuse(path, file.bytes, diag))
		diag_error(diag, (struct srcloc){.file = path}, "%s", advice(path, &file));
	file_bytes_release(&file);
	return known;
}
