/* xml_element.h - opens a file of one kind, and reads its elements by tables of the children that each may have. */
#ifndef FIVECHECK_MACHINE_XML_XML_ELEMENT_H
#define FIVECHECK_MACHINE_XML_XML_ELEMENT_H

#include "machine/xml/xml_reader.h"

/* One kind of child: its name, the function that reads it, and how often it may occur. */
struct xml_child {
	const char *name;
	void (*read)(struct xml_reader *xml, const xmlNode *node, void *context);
	bool once;	/* at most once */
	bool required;
};

/* More kinds of children than an element of these files can have. */
#define XML_CHILDREN_MAX 8

/*
 * Parses the file. Its root must be the first of `elements`, which lists all elements of such a file (NULL ends them).
 * No network, no entities, no document type. Lengths are in mm until the caller sets xml->unit. False: reported, and
 * nothing to close.
 */
bool xml_open(struct xml_reader *xml, const char *path, const char *const *elements, struct diag *diag);

/* The same for a text in memory, whose path is "". */
bool xml_open_text(struct xml_reader *xml, const char *text, const char *const *elements, struct diag *diag);

/*
 * The same for a file of another program: its version is not checked, and it may name a document type that is defined
 * elsewhere, which is not read.
 */
bool xml_open_foreign(struct xml_reader *xml, const char *path, const char *const *elements, struct diag *diag);

void xml_close(struct xml_reader *xml);

const xmlNode *xml_root(const struct xml_reader *xml);

/* The number of elements with the name at any depth below. */
size_t xml_count(const xmlNode *parent, const char *name);

/*
 * Reads the children of an element. Call it after the last request for its attributes. Reports unknown attributes,
 * text, and unknown, repeated and missing children. An entry without a name ends the table.
 */
void xml_read_children(struct xml_reader *xml, const xmlNode *node, const struct xml_child *children, void *context);

/* The same for an element without children. */
void xml_read_nothing(struct xml_reader *xml, const xmlNode *node);

#endif
