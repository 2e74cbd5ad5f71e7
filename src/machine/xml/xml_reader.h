/* xml_reader.h - the state of reading an XML file: its bytes, its document, the places of its elements, its faults. */
#ifndef FIVECHECK_MACHINE_XML_XML_READER_H
#define FIVECHECK_MACHINE_XML_XML_READER_H

#include <libxml/tree.h>

#include <stdarg.h>
#include <stdbool.h>
#include <stddef.h>

#include "base/diag.h"
#include "machine/description.h"

/* The place of a start tag in the bytes. */
struct xml_tag {
	size_t offset;	/* of its '<' */
	long line;
};

/* More attributes than an element of these files can have. */
#define XML_ASKED_MAX 32

struct xml_reader {
	const char *path;	/* borrowed */
	const char *text;	/* read instead of the file; NULL: the file is read; borrowed */
	struct diag *diag;
	size_t errors;
	double unit;	/* mm per unit of length of the file */
	const char *root;	/* libraries outside this folder are not read; NULL: all are; borrowed */
	/* A file of another program: a document type is ignored if it has only a name and a place of definition. */
	bool foreign;
	const char *const *elements;	/* all elements that such a file may have; NULL ends them */
	xmlDoc *doc;
	char *bytes;	/* of the file, ended by a NUL byte */
	struct xml_tag *tags;	/* the n-th belongs to the n-th element of the document */
	size_t tag_count, tag_capacity;
	const xmlNode *asked_of;	/* the last element whose attributes were requested, */
	const char *asked[XML_ASKED_MAX];	/* and their names */
	size_t asked_count;
};

/* Releases what the reader owns, but keeps its counts. */
void xml_reader_release(struct xml_reader *xml);

/*
 * Reports an error at the element, or at one of its attributes (or NULL). After a certain number errors are only
 * counted.
 */
void xml_error(struct xml_reader *xml, const xmlNode *node, const char *attribute, const char *format, ...)
	__attribute__((format(printf, 4, 5)));

/* Reports an error at a line of the file; 0: at no line. */
void xml_error_at(struct xml_reader *xml, long line, const char *format, ...) __attribute__((format(printf, 3, 4)));

/* Have so many errors been reported that further ones are only counted? */
bool xml_is_full(const struct xml_reader *xml);

/* The line in which the element starts. */
long xml_line(const struct xml_reader *xml, const xmlNode *node);

struct quotation xml_quote(const char *text);

/* Is there a control character at `at`: C0, or C1 in UTF-8? */
bool xml_is_control(const char *at);

/* The functions by which a builder reports faults of this file; valid until the file is closed. */
struct description_file xml_description_file(struct xml_reader *xml);

#endif
