/* xml_read.h - opens machine and setup files for reading, and reads their attributes with units and faults. */
#ifndef FIVECHECK_MACHINE_XML_XML_READ_H
#define FIVECHECK_MACHINE_XML_XML_READ_H

#include <libxml/tree.h>

#include <stdbool.h>
#include <stddef.h>

#include "base/arena.h"
#include "base/diag.h"
#include "geom/vec3.h"
#include "geom/xform.h"

/* The largest magnitude of a length in mm and of an angle in degrees that is believed. */
#define XML_MAGNITUDE_MAX 1e7

struct xml_reader {
	const char *path;	/* borrowed */
	struct diag *diag;
	size_t errors;
	xmlDoc *doc;
	double unit;	/* mm per unit of length of the file */
};

/*
 * Parses the file, whose root element is `root` ("machine", "setup" or "waivers"), and
 * validates it against that schema; a fault is reported with its line. No
 * network, no entities, no document type. False: there is nothing to close.
 */
bool xml_open(struct xml_reader *xml, const char *path, const char *root, struct diag *diag);
void xml_close(struct xml_reader *xml);
xmlNode *xml_root(const struct xml_reader *xml);

/* At the node's line. After a number of errors the rest is counted, not reported. */
void xml_error(struct xml_reader *xml, const xmlNode *node, const char *format, ...)
	__attribute__((format(printf, 3, 4)));
void xml_error_at(struct xml_reader *xml, long line, const char *format, ...) __attribute__((format(printf, 3, 4)));

/* True once nothing more is reported. */
bool xml_is_full(const struct xml_reader *xml);

/* Text of the file for a message: shortened, control characters replaced. */
struct xml_quote {
	char text[84];
};
struct xml_quote xml_quote(const char *text);

/* A decimal number, surrounded by nothing but white space; whatever the locale. */
bool xml_parse_number(const char *text, double *out);

/* Element nodes: is it one of this name; the first, the next one; how many anywhere below. */
bool xml_is(const xmlNode *node, const char *name);
xmlNode *xml_first(const xmlNode *parent);
xmlNode *xml_next(const xmlNode *node);
size_t xml_count(const xmlNode *parent, const char *name);

/* The value as it stands, until the file is closed, or NULL. */
const char *xml_attribute(const xmlNode *node, const char *name);

/*
 * Typed values. An absent attribute yields the fallback, a faulty one too,
 * after it was reported.
 */
double xml_number(struct xml_reader *xml, const xmlNode *node, const char *name, double fallback);
double xml_length(struct xml_reader *xml, const xmlNode *node, const char *name, double fallback);	/* mm */
double xml_angle(struct xml_reader *xml, const xmlNode *node, const char *name, double fallback);	/* radians */
vec3 xml_vector(struct xml_reader *xml, const xmlNode *node, const char *name);	/* as written; absent: 0 */
vec3 xml_point(struct xml_reader *xml, const xmlNode *node, const char *name);	/* mm */
vec3 xml_direction(struct xml_reader *xml, const xmlNode *node, const char *name);	/* unit */
int xml_integer(struct xml_reader *xml, const xmlNode *node, const char *name, int fallback, int least, int most);

/* `location` and `rotation` as a pose: R = Rz Ry Rx. */
xform xml_frame(struct xml_reader *xml, const xmlNode *node);

/* The place of the value in the list that NULL ends; 0 if absent. */
int xml_choice(const xmlNode *node, const char *name, const char *const *words);

/* mm per unit of the attribute `units`; the fallback if there is none. */
double xml_units(const xmlNode *node, double fallback);

/* A printable copy in the arena, or NULL if absent or faulty. xml_name: not empty either. */
const char *xml_label(struct xml_reader *xml, const xmlNode *node, const char *name, struct arena *arena);
const char *xml_name(struct xml_reader *xml, const xmlNode *node, const char *name, struct arena *arena);

#endif
