#include "machine/library/library_file.h"

#include <string.h>

#include "base/file_bytes.h"
#include "base/file_signature.h"
#include "machine/library/catalog_tool.h"
#include "machine/library/csv_tools.h"
#include "machine/library/din4000_tools.h"
#include "machine/library/fusion_tools.h"
#include "machine/library/iso13399_tools.h"
#include "machine/library/offset_listing.h"
#include "machine/library/tnc_tools.h"
#include "machine/library/toa_tools.h"
#include "machine/library/tool_table_file.h"
#include "machine/library/vericut_text.h"
#include "machine/library/vericut_tools.h"

/* The text between the start of an XML file and its root element is short. */
#define HEAD_MAX 4096

/* Does the root element of the XML file have this name? */
static bool is_root(const char *text, const char *name)
{
	const size_t length = strlen(name);

	for (const char *at = strchr(text, '<'); at && at - text < HEAD_MAX; at = strchr(at + 1, '<'))
		if (!strncmp(at + 1, name, length) && at[1 + length] && strchr(" \t\r\n/>", at[1 + length]))
			return true;
	return false;
}

enum library_kind library_kind_of(const char *text)
{
	/* The file may begin with a byte order mark. */
	const char *at = text + strspn(text, " \t\r\n\xef\xbb\xbf");

	if (*at == '<')
		return is_root(at, "CGTechToolLibrary") ? LIBRARY_VERICUT :
		       is_root(at, "Tool-Data")		? LIBRARY_DIN_XML :
							  LIBRARY_NONE;
	if (*at == '{' || *at == '[')
		return LIBRARY_FUSION;
	if (tnc_tools_is(text))
		return LIBRARY_TNC_TOOLS;
	if (toa_tools_is(text))
		return LIBRARY_TOA;
	if (iso13399_tools_is(text))
		return LIBRARY_ISO13399;
	if (din4000_table_is(text))
		return LIBRARY_DIN_TABLE;
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
	case LIBRARY_DIN_XML:
		return catalog_tools_are_numbered(options->number_all, path, diag) &&
		       din4000_xml_read(tools, path, diag);
	case LIBRARY_DIN_TABLE:
		return catalog_tools_are_numbered(options->number_all, path, diag) &&
		       din4000_table_read(tools, text, path, diag);
	case LIBRARY_ISO13399:
		return catalog_tools_are_numbered(options->number_all, path, diag) &&
		       iso13399_tools_read(tools, text, path, diag);
	case LIBRARY_TOOL_TABLE:
		return tool_table_file_read(tools, text, path, options->unit, diag);
	case LIBRARY_TNC_TOOLS:
		return tnc_tools_read(tools, text, path, options->unit, options->shapes, diag);
	case LIBRARY_TOA:
		return toa_tools_read(tools, text, path, options->unit, options->shapes, diag);
	case LIBRARY_LISTING:
		return offset_listing_read(tools, text, path, options->unit, diag);
	case LIBRARY_NONE:
		break;
	}
	if (vericut_text_refuse(path, text, diag))
		return false;
	diag_error(diag, (struct srcloc){.file = path},
		   "this is not a tool library. Supported are libraries of Fusion 360 (.json) and VERICUT (.tls), a "
		   "table with a first line of column names (number, length, diameter), a tool table (T1 P1 Z0 D6, "
		   "BEGIN TOOL.T MM, or $TC_DP3[1,1]=0) and a listing of offsets (G10 L10 P1 R0.)");
	return false;
}

/* Is the file an archive, a document, or in an encoding that has NUL bytes? */
static bool is_no_text(const struct file_bytes *file, const char *path, struct diag *diag)
{
	const char *advice = file_signature_advice(file->bytes, file->count);

	if (!advice)
		return false;
	if (!strncmp(file->bytes, "PK\003\004", 4))
		advice = "this is a zip archive: unpack it; a Fusion 360 .tools file contains tools.json, which can be "
			 "read";
	diag_error(diag, (struct srcloc){.file = path}, "%s", advice);
	return true;
}

/* Text after a NUL byte would not be read. */
static bool has_nul(const struct file_bytes *file, const char *path, struct diag *diag)
{
	const char *bytes = file->bytes;
	long line = 1;

	if (strlen(bytes) == file->count || library_kind_of(bytes) == LIBRARY_NONE)
		return false;
	for (; *bytes; bytes++)
		line += *bytes == '\n';
	diag_error(diag, (struct srcloc){.file = path, .line = line}, "the file has a NUL byte: it is not a text file");
	return true;
}

bool library_file_read(struct tool_library *tools, const char *path, const struct library_options *options,
		       struct diag *diag)
{
	struct file_bytes file;
	bool good;

	if (!file_bytes_read(&file, path, diag))
		return false;
	good = !is_no_text(&file, path, diag) && !has_nul(&file, path, diag) &&
	       read_text(tools, library_kind_of(file.bytes), file.bytes, path, options, diag);
	file_bytes_release(&file);
	return good;
}
