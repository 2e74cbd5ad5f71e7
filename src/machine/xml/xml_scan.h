/* xml_scan.h - looks through the bytes of a file before the XML parser does. */
#ifndef FIVECHECK_MACHINE_XML_XML_SCAN_H
#define FIVECHECK_MACHINE_XML_XML_SCAN_H

#include <stdbool.h>
#include <stddef.h>

#include "machine/xml/xml_reader.h"

/*
 * Notes where every start tag is. Reports an encoding in which ASCII characters are other bytes (the scan must see
 * what the parser sees), and a tag with more attributes than any element can have: libxml2 compares each attribute
 * with all before it, which takes minutes for a hostile file. All other faults are left to the parser.
 */
bool xml_scan(struct xml_reader *xml, const char *bytes, size_t length);

#endif
