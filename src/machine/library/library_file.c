#include "machine/library/library_file.h"

#include <string.h>

#include "base/file_bytes.h"
#include "machine/library/csv_tools.h"
#include "machine/library/fusion_tools.h"
#include "machine/library/offset_listing.h"
#include "machine/library/tool_table_file.h"
#include "machine/library/vericut_text.h"
#include "machine/library/vericut_tools.h"

/* What stands between the start of an XML file and its root element is short. */
#define HEAD_MAX 4096

static bool is_vericut_root(const char *text)
{
	static const char root[] = "<CGTechToolLibrary";
	const char *at = strstr(text, root);

	return at && at - text < HEAD_MAX && at[sizeof(root) - 1] && strchr(" \t\r\n/>", at[sizeof(root) - 1]);
}

enum library_kind library_kind_of(const char *text)
{
	/* A byte order mark may come first. */
	const char *at = text + strspn(text, " \t\r\n\xef\xbb\xbf");

	if (*at == '<')
		return is_vericut_root(at) ? LIBRARY_VERICUT : LIBRARY_NONE;
	if (*at == '{' || *at == '[')
		return LIBRARY_FUSION;
	if (csv_tools_is(text))
		return LIBRARY_CSV;
	if (tool_table_file_is(text))
		return LIBRARY_TOOL_TABLE;
	return offset_listing_is(text) ? LIBRARY_LISTING : LIBRARY_NONE;
}

static bool read_text(struct tool_library *tools, enum library_kind kind, const char *text, const char *path,
		      const struct library_options *options, struct diag *diag)
{
	switch (kind) {
	case LIBRARY_VERICUT:
		return vericut_tools_read(tools, path, options->number_all, diag);
	case LIBRARY_FUSION:
		return fusion_tools_read(tools, path, diag);
	case LIBRARY_CSV:
		return csv_tools_read(tools, text, path, options->unit, diag);
	case LIBRARY_TOOL_TABLE:
		return tool_table_file_read(tools, text, path, options->unit, diag);
	case LIBRARY_LISTING:
		return offset_listing_read(tools, text, path, options->unit, diag);
	case LIBRARY_NONE:
		break;
	}
	if (vericut_text_refuse(path, text, diag))
		return false;
	if (!strncmp(text, "\xff\xfe", 2) || !strncmp(text, "\xfe\xff", 2)) {
		diag_error(diag, (struct srcloc){.file = path},
			   "this file is in UTF-16: save it as UTF-8 (a text editor does)");
		return false;
	}
	if (!strncmp(text, "PK\003\004", 4)) {
		diag_error(diag, (struct srcloc){.file = path},
			   "this is a zip archive: unpack it; a .tools file of Fusion 360 has tools.json in it, which "
			   "can be read");
		return false;
	}
	diag_error(diag, (struct srcloc){.file = path},
		   "this is no tool library: those of Fusion 360 (.json) and VERICUT (.tls), a CSV file with a line of "
		   "column names, a tool table (T1 P1 Z0 D6) and a listing of offsets (G10 L10 P1 R0.) can be read");
	return false;
}

bool library_file_read(struct tool_library *tools, const char *path, const struct library_options *options,
		       struct diag *diag)
{
	struct file_bytes file;
	bool good;

	if (!file_bytes_read(&file, path, diag))
		return false;
	good = read_text(tools, library_kind_of(file.bytes), file.bytes, path, options, diag);
	file_bytes_release(&file);
	return good;
}
