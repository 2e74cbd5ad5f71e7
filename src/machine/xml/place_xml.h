/* place_xml.h - reads <reference> and <tool_change>: where the control sends axes by itself. */
#ifndef FIVECHECK_MACHINE_XML_PLACE_XML_H
#define FIVECHECK_MACHINE_XML_PLACE_XML_H

#include "machine/machine.h"
#include "machine/xml/xml_read.h"

/* A position this near to a limit, in mm or degrees, is inside. */
#define LIMIT_TOLERANCE 1e-6

/* The children of <controller>, once the axes are known. */
void places_read(struct xml_reader *xml, const xmlNode *controller, struct machine *machine);

#endif
