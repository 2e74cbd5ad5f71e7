/* setup_writer.h - writes the description of a setup as a setup file. */
#ifndef FIVECHECK_IMPORT_SETUP_WRITER_H
#define FIVECHECK_IMPORT_SETUP_WRITER_H

#include "base/strbuf.h"
#include "import/import_project.h"
#include "machine/description.h"

/*
 * Appends a setup file with the tools and offsets of `tools`, and with the bodies and work offsets of `job` (NULL:
 * unknown). `origin`: the source of the file, for a comment.
 */
void setup_writer_xml(struct strbuf *out, const struct setup_description *tools, const struct import_setup *job,
		      const char *origin);

#endif
