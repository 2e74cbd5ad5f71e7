/*
 * xml_attribute.h - reads attributes with their units. Attributes that the reader asks for are known; all others are
 * faults.
 */
#ifndef FIVECHECK_MACHINE_XML_XML_ATTRIBUTE_H
#define FIVECHECK_MACHINE_XML_XML_ATTRIBUTE_H

#include "base/arena.h"
#include "geom/vec3.h"
#include "geom/xform.h"
#include "machine/xml/xml_reader.h"

/* The largest accepted magnitude of a length in mm and of an angle in degrees. */
#define XML_MAGNITUDE_MAX 1e7

/* The value as written, or NULL; valid until the file is closed. Marks the attribute as known. */
const char *xml_attribute(struct xml_reader *xml, const xmlNode *node, const char *name);

/* Reports each of the named attributes that is missing; NULL ends the names. */
void xml_require(struct xml_reader *xml, const xmlNode *node, ...) __attribute__((sentinel));

/* Reports attributes that the reader did not request. Call it after the last request for the element. */
void xml_attributes_end(struct xml_reader *xml, const xmlNode *node);

/*
 * Typed values: decimal numbers, in any locale; white space around them is permitted. An absent attribute gives the
 * fallback; so does a faulty one, which is reported.
 */
double xml_number(struct xml_reader *xml, const xmlNode *node, const char *name, double fallback);
double xml_length(struct xml_reader *xml, const xmlNode *node, const char *name, double fallback);	/* mm */
double xml_angle(struct xml_reader *xml, const xmlNode *node, const char *name, double fallback);	/* radians */
long xml_whole(struct xml_reader *xml, const xmlNode *node, const char *name, long fallback);	/* 0 or more */
long xml_positive(struct xml_reader *xml, const xmlNode *node, const char *name, long fallback);	/* 1 or more */
vec3 xml_vector(struct xml_reader *xml, const xmlNode *node, const char *name);	/* as written; absent: 0 */
vec3 xml_point(struct xml_reader *xml, const xmlNode *node, const char *name);	/* mm; absent: 0 */

/* Two lengths, mm; both stay as they are if the attribute is absent or faulty. */
void xml_two_lengths(struct xml_reader *xml, const xmlNode *node, const char *name, double *first, double *second);

/* The same, if the attribute is there. */
struct optional_number xml_optional_number(struct xml_reader *xml, const xmlNode *node, const char *name);
struct optional_number xml_optional_length(struct xml_reader *xml, const xmlNode *node, const char *name);
struct optional_number xml_optional_angle(struct xml_reader *xml, const xmlNode *node, const char *name);

/* Attributes named by axis letters: lengths and angles, each in its slot. */
void xml_axis_values(struct xml_reader *xml, const xmlNode *node, struct optional_number value[SLOT_COUNT]);

/* `location` and `rotation` as a pose: R = Rz Ry Rx. */
xform xml_frame(struct xml_reader *xml, const xmlNode *node);

/* The index of the value in the list of words, which NULL ends; the fallback if the attribute is absent. */
int xml_choice(struct xml_reader *xml, const xmlNode *node, const char *name, const char *const *words, int fallback);

/* mm per unit, from the attribute `units`; the fallback if it is absent. xml_file_units knows mm and inch only. */
double xml_file_units(struct xml_reader *xml, const xmlNode *node, double fallback);
double xml_mesh_units(struct xml_reader *xml, const xmlNode *node, double fallback);

/* A printable copy in the arena, or NULL if absent or faulty. xml_name: an empty text is faulty, too. */
const char *xml_label(struct xml_reader *xml, const xmlNode *node, const char *name, struct arena *arena);
const char *xml_name(struct xml_reader *xml, const xmlNode *node, const char *name, struct arena *arena);

#endif
