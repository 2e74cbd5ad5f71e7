/*
 * foreign_xml.h - reads XML files of other programs. They contain more than is needed. Therefore, unlike in fivecheck's
 * own files, elements and attributes that are not needed are ignored; a faulty one that is needed is an error with its
 * place.
 */
#ifndef FIVECHECK_MACHINE_XML_FOREIGN_XML_H
#define FIVECHECK_MACHINE_XML_FOREIGN_XML_H

#include "base/arena.h"
#include "geom/vec3.h"
#include "machine/xml/xml_reader.h"

/* The first child element with the name, or NULL; NULL as the name: with any name. No parent (NULL) has no child. */
const xmlNode *foreign_child(const xmlNode *parent, const char *name);

/* The next sibling element with the name, or NULL; NULL as the name: with any name. */
const xmlNode *foreign_next(const xmlNode *node, const char *name);

bool foreign_is(const xmlNode *node, const char *name);

/* The text of an attribute, or NULL. It is valid until the file is closed. */
const char *foreign_attribute(const xmlNode *node, const char *name);

/* Does the attribute exist with this value, in upper or lower case? */
bool foreign_attribute_is(const xmlNode *node, const char *name, const char *value);

/* The text inside an element, without white space around it, in the arena; "" if it is empty or the node NULL. */
const char *foreign_text(struct arena *arena, const xmlNode *node);

/* A number from an attribute, or from the text of an element. False, reported: it is missing, or not a number. */
bool foreign_number(struct xml_reader *xml, const xmlNode *node, const char *attribute, double *value);

/* Three numbers from three attributes. */
bool foreign_vector(struct xml_reader *xml, const xmlNode *node, const char *x, const char *y, const char *z,
		    vec3 *value);

#endif
