/* setup_xml.h - reads a <setup> element, from its own file or from within a machine's. */
#ifndef FIVECHECK_MACHINE_XML_SETUP_XML_H
#define FIVECHECK_MACHINE_XML_SETUP_XML_H

#include "machine/machine.h"
#include "machine/setup.h"
#include "machine/xml/xml_read.h"

/* The setup, or NULL after reported faults. */
struct setup *setup_read(struct xml_reader *xml, const xmlNode *node, const struct machine *machine);

#endif
