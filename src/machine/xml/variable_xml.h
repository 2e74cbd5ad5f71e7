/* variable_xml.h - <variable> of a machine file or a setup: a value in the control when a program begins. */
#ifndef FIVECHECK_MACHINE_XML_VARIABLE_XML_H
#define FIVECHECK_MACHINE_XML_VARIABLE_XML_H

#include "machine/description.h"
#include "machine/xml/xml_reader.h"

/* Fills in the description; texts go into the arena, and faults are counted by the reader. */
void variable_xml_read(struct xml_reader *xml, const xmlNode *node, struct arena *arena,
		       struct variable_description *variable);

#endif
