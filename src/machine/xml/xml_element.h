/* xml_element.h - opens a file of one kind, and walks through elements by tables of what each may hold. */
#ifndef FIVECHECK_MACHINE_XML_XML_ELEMENT_H
#define FIVECHECK_MACHINE_XML_XML_ELEMENT_H

#include "machine/xml/xml_reader.h"

/* One kind of child: its name, who reads it, how often it may stand there. */
struct xml_child {
	const char *name;
	void (*read)(struct xml_reader *xml, const xmlNode *node, void *context);
	bool once;	/* at most once */
	bool required;
};

/* More kinds of children than an element of these files can have. */
#define XML_CHILDREN_MAX 8

/*
 * Parses the file, whose root element must be the first of `elements`, all that such a file may hold (NULL ends them).
 * No network, no entities, no document type. Lengths are in mm until the caller sets xml->unit. False: reported, and nothing to close.
 */
bool xml_open(struct xml_reader *xml, const char *path, const char *const *elements, struct diag *diag);
void xml_close(struct xml_reader *xml);

const xmlNode *xml_root(const struct xml_reader *xml);

/* How many elements of the name are anywhere below. */
size_t xml_count(const xmlNode *parent, const char *name);

/*
 * Reads the children of an element, once all of its attributes were asked for: reports unknown attributes, unknown,
 * repeated and missing children, and text. An entry without a name ends the table.
 */
void xml_read_children(struct xml_reader *xml, const xmlNode *node, const struct xml_child *children, void *context);

/* The same for an element that holds nothing. */
void xml_read_nothing(struct xml_reader *xml, const xmlNode *node);

#endif
