/* xml_scan.h - looks through the bytes of a file for what would keep the XML parser busy for minutes. */
#ifndef FIVECHECK_MACHINE_XML_XML_SCAN_H
#define FIVECHECK_MACHINE_XML_XML_SCAN_H

#include <stdbool.h>
#include <stddef.h>

#include "machine/xml/xml_read.h"

/*
 * Reports bytes that are no superset of ASCII (so that the scan sees what the
 * parser sees), and tags with more attributes than any element can have:
 * libxml2 compares each attribute with all before it. What else is wrong
 * with the file is the parser's to say.
 */
bool xml_scan(struct xml_reader *xml, const char *bytes, size_t length);

#endif
