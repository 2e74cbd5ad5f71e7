/* xml_file.h - from a path to a well-formed document, however hostile the file. */
#ifndef FIVECHECK_MACHINE_XML_XML_FILE_H
#define FIVECHECK_MACHINE_XML_XML_FILE_H

#include <libxml/xmlerror.h>

#include <stdbool.h>

#include "machine/xml/xml_read.h"

/* Sets xml->doc; false after a reported fault. */
bool xml_parse_file(struct xml_reader *xml);

/* While it is in force, libxml2's messages become errors of the reader and nothing reaches standard error. */
struct xml_capture {
	struct xml_reader *xml;
	const char *prefix;	/* stands before libxml2's message */
	void *old_context, *old_generic_context;
	xmlStructuredErrorFunc old_handler;
	xmlGenericErrorFunc old_generic;
	bool reported;	/* the first message; those that follow from it are not shown */
};

void xml_capture_begin(struct xml_capture *capture, struct xml_reader *xml, const char *prefix);
void xml_capture_end(struct xml_capture *capture);

#endif
