#include "import/file_kind.h"

#include <string.h>
#include <strings.h>

#include "base/file_bytes.h"
#include "import/mesh_file.h"
#include "machine/library/library_file.h"

/* What stands between the start of an XML file and its root element is short. */
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
	/* A byte order mark may come first. */
	return at + strspn(at, " \t\r\n\xef\xbb\xbf");
}

/* The name of the first element, or NULL. Declarations and comments before it are passed over. */
static const char *root_name(const char *text)
{
	const char *at = skip_space(text);

	while (at && *at == '<' && (at[1] == '?' || at[1] == '!') && at - text < HEAD_MAX) {
		at = strncmp(at, "<!--", 4) == 0 ? strstr(at, "-->") : strchr(at, '>');
		at = at ? skip_space(strchr(at, '>') + 1) : NULL;
	}
	return at && *at == '<' ? at + 1 : NULL;
}

/* Is the root element of the XML file the one of this name? */
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

/* Sections that an ini file of such a machine has; one of them may be in a file that it includes. */
static bool is_ini(const char *text)
{
	static const char *const sections[] = {"\n[EMC]", "\n[KINS]", "\n[TRAJ]"};

	for (size_t i = 0; i < sizeof(sections) / sizeof(*sections); i++)
		if (strstr(text, sections[i]) || !strncmp(text, sections[i] + 1, strlen(sections[i]) - 1))
			return true;
	return false;
}

static bool ends_with(const char *path, const char *end)
{
	size_t length = strlen(path);

	return length >= strlen(end) && !strcasecmp(path + length - strlen(end), end);
}

/* A machine of FreeCAD's CAM workbench: JSON, as tool libraries are. */
static bool is_freecad(const char *path, const char *text)
{
	return *skip_space(text) == '{' && (ends_with(path, ".fcm") || strstr(text, "\"freecad_version\"")) &&
	       strstr(text, "\"machine\"");
}

static bool tell(enum file_kind *kind, const char *path, const char *text)
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

/* The digits and dots after the word "version" in the first lines; *length is 0 if there are none. */
static const char *version_of(const char *text, size_t *length)
{
	static const char word[] = "version";

	*length = 0;
	for (const char *at = text; *at && at - text < HEAD_MAX && !*length; at++) {
		const char *number;

		if (strncasecmp(at, word, sizeof(word) - 1) != 0)
			continue;
		number = at + sizeof(word) - 1;
		number += strspn(number, " \t:=-_\"");
		*length = strspn(number, "0123456789.");
		text = *length ? number : text;
	}
	return text;
}

/* Refuses the text form of VERICUT's files, whose grammar is not published. False: it is none of them. */
static bool refuse_old_vericut(const char *path, const char *text, struct diag *diag)
{
	static const struct {
		const char *end, *what;
	} kinds[] = {
		{".mch", "a machine"}, {".vcproject", "a project"}, {".usr", "a job (user file)"},
		{".tls", "a tool library"}, {".ctl", "a control"},
	};
	size_t length;
	const char *version;

	if (*skip_space(text) == '<' || !strncmp(text, "\xff\xfe", 2) || !strncmp(text, "\xfe\xff", 2))
		return false;
	for (size_t i = 0; i < sizeof(kinds) / sizeof(*kinds); i++) {
		if (!ends_with(path, kinds[i].end))
			continue;
		version = version_of(text, &length);
		diag_error(diag, (struct srcloc){.file = path},
			   "this is %s of VERICUT in its text form, %s%.*s: the grammar of that form is not published, so it "
			   "is not read. Open it in VERICUT 7 or later and save it under a new name: then it is XML, which "
			   "can be imported",
			   kinds[i].what, length ? "of version " : "of version 6 or before", (int)(length < 20 ? length : 20),
			   version);
		return true;
	}
	return false;
}

/* What is known of a file that cannot be imported, so that its owner knows what to do. */
static const char *advice(const char *path, const char *text)
{
	if (!strncmp(text, "\xff\xfe", 2) || !strncmp(text, "\xfe\xff", 2))
		return "this file is in UTF-16: save it as UTF-8 (a text editor does)";
	if (ends_with(path, ".step") || ends_with(path, ".stp") || ends_with(path, ".igs") || ends_with(path, ".iges"))
		return "this is a solid of a CAD program and has no axes: export each body that moves as STL from it, "
		       "with all axes at 0, and name the meshes in a machine file ('fivecheck init' writes one to "
		       "begin with)";
	if (!strncmp(text, "PK\003\004", 4))
		return "this is a zip archive: unpack it; a .tools file of Fusion 360 has tools.json in it, which can "
		       "be imported";
	return "this is no file that can be imported: a machine or a project of VERICUT 7 (XML), an ini file, a "
	       "machine of FreeCAD (.fcm), MTConnect or URDF; a tool library of VERICUT or Fusion 360 (JSON), a table "
	       "of tools (CSV, tool.tbl) or a listing of offsets (G10); or a mesh (OBJ, PLY, 3MF, glTF)";
}

bool file_kind_of(enum file_kind *kind, const char *path, struct diag *diag)
{
	struct file_bytes file;
	bool known;

	if (!file_bytes_read(&file, path, diag))
		return false;
	known = tell(kind, path, file.bytes);
	if (!known && !refuse_old_vericut(path, file.bytes, diag))
		diag_error(diag, (struct srcloc){.file = path}, "%s", advice(path, file.bytes));
	file_bytes_release(&file);
	return known;
}
