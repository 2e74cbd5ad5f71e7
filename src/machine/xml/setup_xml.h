/* setup_xml.h - reads a <setup> element from its own file or from inside a machine's file. */
#ifndef FIVECHECK_MACHINE_XML_SETUP_XML_H
#define FIVECHECK_MACHINE_XML_SETUP_XML_H

#include "machine/xml/xml_reader.h"

/* The elements that a setup may contain, itself first; for tables of elements. */
#define SETUP_XML_ELEMENTS                                                                                             \
	"setup", "work_offset", "fixture", "part", "stock", "tool", "tools", "edge", "offset", "holder", "shank",      \
	    "cutter", "section", "variable"

/* Fills in a description that is all zero; faults are counted by the reader. */
void setup_xml_read(struct xml_reader *xml, const xmlNode *node, struct setup_description *described);

#endif
