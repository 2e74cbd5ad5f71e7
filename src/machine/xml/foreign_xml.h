/*
 * foreign_xml.h - reads XML files of other programs. They have more in them than is needed, so unlike in fivecheck's
 * own files, what nobody asks for is passed over; what is asked for and is wrong is an error with its place.
 */
#ifndef FIVECHECK_MACHINE_XML_FOREIGN_XML_H
#define FIVECHECK_MACHINE_XML_FOREIGN_XML_H

#include "base/arena.h"
#include "geom/vec3.h"
#include "machine/xml/xml_reader.h"

/* The first child element of the name, or NULL; NULL as the name: of any name. No parent (NULL) has no child. */
const xmlNode *foreign_child(const xmlNode *parent, const char *name);

/* The next sibling element of the name, or NULL; NULL as the name: of any name. */
const xmlNode *foreign_next(const xmlNode *node, const char *name);

bool foreign_is(const xmlNode *node, const char *name);

/* The text of an attribute, or NULL. It is valid until the file is closed. */
const char *foreign_attribute(const xmlNode *node, const char *name);

/* Is the attribute there, and has it this value, whatever the case? */
bool foreign_attribute_is(const xmlNode *node, const char *name, const char *value);

/* The text inside of an element, without white space around it, in the arena; "" if it is empty or the node NULL. */
const char *foreign_text(struct arena *arena, const xmlNode *node);

/* A number of an attribute, or of the text of an element. False, reported: it is missing, or no number. */
bool foreign_number(struct xml_reader *xml, const xmlNode *node, const char *attribute, double *value);

/* Three numbers of three attributes. */
bool foreign_vector(struct xml_reader *xml, const xmlNode *node, const char *x, const char *y, const char *z,
		    vec3 *value);

#endif
