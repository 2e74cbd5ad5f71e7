/* library_file.h - reads a tool library, a tool table or an offset listing; its content tells which of them it is. */
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
	LIBRARY_LISTING	/* offset_listing.h */
};

/* What the text of a file is. `text` ends with a NUL. */
enum library_kind library_kind_of(const char *text);

struct library_options {
	double unit;	/* mm per unit of length, for files that do not say theirs */
	bool number_all;	/* give tools without a number one, where the file has names of tools instead */
};

/* Adds what the file holds to the library. False, reported: it cannot be read, or is faulty, or none of these kinds. */
bool library_file_read(struct tool_library *tools, const char *path, const struct library_options *options,
		       struct diag *diag);

#endif
