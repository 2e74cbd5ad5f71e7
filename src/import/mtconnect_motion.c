#include "import/mtconnect_motion.h"

#include <math.h>
#include <string.h>

#include "base/decimal.h"
#include "base/units.h"
#include "machine/xml/foreign_xml.h"

/* mm, and for directions: a smaller difference is rounding. */
#define AGREE 1e-6

/* No machine has a longer chain; a cycle of parents has. */
enum { CHAIN_MAX = 64 };

const xmlNode *mtconnect_next(const xmlNode *root, const xmlNode *node)
{
	const xmlNode *next = foreign_child(node, NULL);

	while (!next && node && node != root) {
		next = foreign_next(node, NULL);
		node = node->parent;
	}
	return next;
}

const xmlNode *mtconnect_motion(const xmlNode *component)
{
	return foreign_child(foreign_child(component, "Configuration"), "Motion");
}

bool mtconnect_parent(struct xml_reader *xml, const xmlNode *device, const xmlNode *motion, const xmlNode **parent)
{
	const char *name = foreign_attribute(motion, "parentIdRef"), *id;

	*parent = NULL;
	if (!name)
		return true;
	for (const xmlNode *at = device; at; at = mtconnect_next(device, at))
		if (foreign_is(at, "Motion") && (id = foreign_attribute(at, "id")) != NULL && !strcmp(id, name)) {
			*parent = at;
			return true;
		}
	xml_error(xml, motion, "parentIdRef", "no Motion of this device has the id '%s'", xml_quote(name).text);
	return false;
}

/* ------------------------------------------------------------------ numbers */

static bool three_fault(struct xml_reader *xml, const xmlNode *node)
{
	xml_error(xml, node, NULL, "<%s> must have three numbers", (const char *)node->name);
	return false;
}

static bool read_words(struct xml_reader *xml, const xmlNode *node, double values[3])
{
	const xmlNode *text = node->children;
	const char *at = text && text->type == XML_TEXT_NODE ? (const char *)text->content : "";

	for (int i = 0; i < 3; i++) {
		size_t length;

		at += strspn(at, " \t\r\n");
		length = strcspn(at, " \t\r\n");
		if (!length || !decimal_read(at, length, &values[i]) || !isfinite(values[i]))
			return three_fault(xml, node);
		at += length;
	}
	return !at[strspn(at, " \t\r\n")] || three_fault(xml, node);
}

/* Entries with the keys X, Y and Z, or A, B and C; one that is missing is 0. */
static bool read_entries(struct xml_reader *xml, const xmlNode *node, const char *keys, double values[3])
{
	for (const xmlNode *entry = foreign_child(node, "Entry"); entry; entry = foreign_next(entry, "Entry")) {
		const char *key = foreign_attribute(entry, "key");
		const char *at = key && strlen(key) == 1 ? strchr(keys, *key) : NULL;

		if (!at) {
			xml_error(xml, entry, "key", "the key must be one of %c, %c and %c", keys[0], keys[1], keys[2]);
			return false;
		}
		if (!foreign_number(xml, entry, NULL, &values[at - keys]))
			return false;
	}
	return true;
}

/* <Name>1 2 3</Name> or <NameDataSet>; *found: one of them exists. */
static bool read_three(struct xml_reader *xml, const xmlNode *parent, const char *name, const char *data_set,
		       const char *keys, double values[3], bool *found)
{
	const xmlNode *words = foreign_child(parent, name), *entries = foreign_child(parent, data_set);

	*found = words || entries;
	if (words)
		return read_words(xml, words, values);
	return !entries || read_entries(xml, entries, keys, values);
}

/* ------------------------------------------------------------------- frames */

/* The standard does not define the order of several angles of a Rotation. */
static bool read_rotation(struct xml_reader *xml, const xmlNode *transformation, mat3 *rotation)
{
	static const vec3 axes[3] = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
	double angles[3] = {0};
	int turned = 0;
	bool found;

	*rotation = mat3_identity();
	if (!read_three(xml, transformation, "Rotation", "RotationDataSet", "ABC", angles, &found))
		return false;
	for (int i = 0; i < 3; i++)
		if (fabs(angles[i]) > 0) {
			*rotation = mat3_turn(axes[i], radians(angles[i]));
			turned++;
		}
	if (turned > 1)
		xml_error(xml, transformation, NULL,
			  "a Rotation about several axes is not supported, because their order is not defined");
	return turned <= 1;
}

/* The place that the Motion defines: an Origin in its coordinate system, or a Transformation. */
static bool read_place(struct xml_reader *xml, const xmlNode *motion, xform *place)
{
	const xmlNode *transformation = foreign_child(motion, "Transformation");
	double p[3] = {0};
	bool found;

	*place = xform_identity();
	if (!read_three(xml, motion, "Origin", "OriginDataSet", "XYZ", p, &found))
		return false;
	if (found && transformation) {
		xml_error(xml, motion, NULL, "a Motion must not have both an Origin and a Transformation");
		return false;
	}
	if (transformation &&
	    (!read_three(xml, transformation, "Translation", "TranslationDataSet", "XYZ", p, &found) ||
	     !read_rotation(xml, transformation, &place->rotation)))
		return false;
	place->translation = (vec3){p[0], p[1], p[2]};
	return true;
}

/* The place of the Motion if every Transformation is relative to the parent. */
static bool chain_place(struct xml_reader *xml, const xmlNode *device, const xmlNode *motion, xform *place)
{
	*place = xform_identity();
	for (int depth = 0; motion; depth++) {
		xform own;

		if (depth == CHAIN_MAX) {
			xml_error(xml, motion, NULL, "the parents of this Motion form a circle");
			return false;
		}
		if (!read_place(xml, motion, &own))
			return false;
		*place = xform_mul(&own, place);
		if (foreign_child(motion, "Origin") || foreign_child(motion, "OriginDataSet"))
			return true;
		if (!mtconnect_parent(xml, device, motion, &motion))
			return false;
	}
	return true;
}

bool mtconnect_line(struct xml_reader *xml, const xmlNode *device, const xmlNode *motion, vec3 *direction,
		    vec3 *location)
{
	const bool along = foreign_attribute_is(motion, "type", "PRISMATIC");
	double a[3] = {0};
	bool found;
	xform own, chained;
	vec3 axis, other;

	if (!read_three(xml, motion, "Axis", "AxisDataSet", "XYZ", a, &found) ||
	    !read_place(xml, motion, &own) || !chain_place(xml, device, motion, &chained))
		return false;
	axis = (vec3){a[0], a[1], a[2]};
	if (!found || vec3_norm(axis) < AGREE) {
		xml_error(xml, motion, NULL, "the Axis of the Motion is missing or has no direction");
		return false;
	}
	*direction = mat3_apply(&own.rotation, axis);
	other = mat3_apply(&chained.rotation, axis);
	if (vec3_norm(vec3_sub(other, *direction)) <= AGREE * vec3_norm(axis) &&
	    (!location || along || vec3_norm(vec3_sub(chained.translation, own.translation)) <= AGREE)) {
		if (location)
			*location = own.translation;
		return true;
	}
	xml_error(xml, motion, NULL,
		  "it is not defined whether the position of this Motion is relative to the parent or to the "
		  "coordinate system: write <Origin> instead, in the coordinate system");
	return false;
}
