/* xml_schema.h - holds a parsed file against the RELAX NG schemas that are compiled into the program. */
#ifndef FIVECHECK_MACHINE_XML_XML_SCHEMA_H
#define FIVECHECK_MACHINE_XML_XML_SCHEMA_H

#include <stdbool.h>

#include "machine/xml/xml_read.h"

/*
 * Reports every element, attribute and value that the schema does not know,
 * with what was probably meant, and whatever is missing or too many; what
 * passes this is validated by libxml2 as well.
 */
bool xml_validate(struct xml_reader *xml, const char *root);

#endif
