/* library_file.h - reads a tool library, a tool table or an offset listing; the content determines the kind. */
#ifndef FIVECHECK_MACHINE_LIBRARY_LIBRARY_FILE_H
#define FIVECHECK_MACHINE_LIBRARY_LIBRARY_FILE_H

#include <stdbool.h>

#include "base/diag.h"
#include "machine/library/tool_library.h"

enum library_kind {
	LIBRARY_NONE,	/* something else */
	LIBRARY_VERICUT,	/* vericut_tools.h */
	LIBRARY_FUSION,	/* fusion_tools.h */
	LIBRARY_CSV,	/* csv_tools.h */
	LIBRARY_DIN_XML, LIBRARY_DIN_TABLE,	/* din4000_tools.h */
	LIBRARY_ISO13399,	/* iso13399_tools.h */
	LIBRARY_TOOL_TABLE,	/* tool_table_file.h */
	LIBRARY_TNC_TOOLS,	/* tnc_tools.h */
	LIBRARY_TOA,	/* toa_tools.h */
	LIBRARY_LISTING	/* offset_listing.h */
};

/* The kind of a file with this text, which ends with a NUL. */
enum library_kind library_kind_of(const char *text);

struct library_options {
	double unit;	/* mm per unit of length, for files that do not say theirs */
	bool number_all;	/* assign numbers to tools without one, in files that have tool names instead */
	bool shapes;	/* of a control's tool table: tools, with what it says of their shapes; else only its values */
};

/*
 * Adds the contents of the file to the library. False, reported: the file cannot be read, is faulty, or is of no known
 * kind.
 */
bool library_file_read(struct tool_library *tools, const char *path, const struct library_options *options,
		       struct diag *diag);

#endif
