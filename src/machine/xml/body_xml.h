/* body_xml.h - reads the common parts of all elements that name a mesh. */
#ifndef FIVECHECK_MACHINE_XML_BODY_XML_H
#define FIVECHECK_MACHINE_XML_BODY_XML_H

#include "machine/xml/xml_reader.h"

/* The path in an attribute, relative to the folder of the file, made so that it can be opened; or NULL. */
const char *body_xml_path(struct xml_reader *xml, const xmlNode *node, const char *name, struct arena *arena);

/* The same for the attribute `mesh`. */
const char *body_xml_mesh(struct xml_reader *xml, const xmlNode *node, struct arena *arena);

/* A <body>, <fixture> or <part> with all its contents; the caller sets role and link. */
void body_xml_read(struct xml_reader *xml, const xmlNode *node, struct arena *arena, struct body_description *body);

#endif
