/* xml_scan.h - scans the bytes of a file before the XML parser reads them. */
#ifndef FIVECHECK_MACHINE_XML_XML_SCAN_H
#define FIVECHECK_MACHINE_XML_XML_SCAN_H

#include <stdbool.h>
#include <stddef.h>

#include "machine/xml/xml_reader.h"

/*
 * Stores the place of every start tag. Reports an encoding in which ASCII characters are other bytes, because the scan
 * must read the same characters as the parser. Reports a tag with too many attributes, because libxml2 compares each
 * attribute with all before it, which takes minutes for a hostile file. The parser finds all other faults.
 */
bool xml_scan(struct xml_reader *xml, const char *bytes, size_t length);

#endif
