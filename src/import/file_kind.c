#include "import/file_kind.h"

#include <string.h>

#include "import/file_bytes.h"

/* What stands between the start of an XML file and its root element is short. */
#define HEAD_MAX 4096

static const struct {
	const char *root;
	enum file_kind kind;
} xml_roots[] = {
	{"VcMachine", FILE_VERICUT_MACHINE},
	{"CGTechToolLibrary", FILE_VERICUT_TOOLS},
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

static bool tell(enum file_kind *kind, const char *text)
{
	const char *root = root_name(text), *first = skip_space(text);

	for (size_t i = 0; root && i < sizeof(xml_roots) / sizeof(*xml_roots); i++) {
		size_t length = strlen(xml_roots[i].root);

		*kind = xml_roots[i].kind;
		if (!strncmp(root, xml_roots[i].root, length) && strchr(" \t\r\n/>", root[length]))
			return true;
	}
	*kind = FILE_FUSION_TOOLS;
	return *first == '{' || *first == '[';
}

bool file_kind_of(enum file_kind *kind, const char *path, struct diag *diag)
{
	struct file_bytes file;
	bool known;

	if (!file_bytes_read(&file, path, diag))
		return false;
	known = tell(kind, file.bytes);
	file_bytes_release(&file);
	if (!known)
		diag_error(diag, (struct srcloc){.file = path},
			   "this is no file that can be imported: a machine or a tool library of VERICUT 7 (XML), or a tool "
			   "library of Fusion 360 (JSON)");
	return known;
}
