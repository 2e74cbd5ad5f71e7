/* tool_xml.h - reads a <tool>: its numbers, and its holder, shank and cutter as sections or meshes. */
#ifndef FIVECHECK_MACHINE_XML_TOOL_XML_H
#define FIVECHECK_MACHINE_XML_TOOL_XML_H

#include <stddef.h>

#include "machine/machine.h"
#include "machine/setup.h"
#include "machine/xml/xml_read.h"

/* Bodies of one tool: holder, shank, cutter, and the neck above the cutter's flutes. */
#define TOOL_BODIES_MAX 4

/* T and H words of eight digits exist. */
#define TOOL_NUMBER_MAX 99999999

/* Triangles of all the tools of a setup together. */
#define TOOL_TRIANGLES_MAX ((size_t)10 * 1000 * 1000)

struct tool_reader {
	struct xml_reader *xml;
	struct setup *setup;	/* receives the tool and its bodies; has room for them */
	const struct machine *machine;
	size_t triangles;	/* so far */
};

/* Appends the tool and its holder, shank and cutter, as far as it has them. */
void tool_read(struct tool_reader *reader, const xmlNode *node);

#endif
