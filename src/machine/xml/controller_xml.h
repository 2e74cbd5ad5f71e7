/* controller_xml.h - <controller> of a machine file: the settings that only the control knows. */
#ifndef FIVECHECK_MACHINE_XML_CONTROLLER_XML_H
#define FIVECHECK_MACHINE_XML_CONTROLLER_XML_H

#include "machine/xml/xml_reader.h"

/* The elements inside <controller>, for the list of elements that a file may have. */
#define CONTROLLER_XML_ELEMENTS "mcode", "macro", "variable", "reference", "tool_change", "swivel_retract"

/* Reads the element into the struct machine_description at `context`. Errors are reported. */
void controller_xml_read(struct xml_reader *xml, const xmlNode *node, void *context);

#endif
