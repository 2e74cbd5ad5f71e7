#include "import/mtconnect_travel.h"

#include <math.h>
#include <string.h>

#include "base/units.h"
#include "import/mtconnect_motion.h"
#include "machine/xml/foreign_xml.h"

struct unit {
	const char *name;
	double scale;	/* to mm, radians, and mm or degrees a minute */
};

static const struct unit lengths[] = {{"MILLIMETER", 1}, {"INCH", MM_PER_INCH}, {NULL, 0}};
static const struct unit angles[] = {{"DEGREE", PI / 180}, {"RADIAN", 1}, {NULL, 0}};
static const struct unit linear_rates[] = {{"MILLIMETER/SECOND", SECONDS_PER_MINUTE},
					   {"MILLIMETER/MINUTE", 1},
					   {"INCH/SECOND", SECONDS_PER_MINUTE * MM_PER_INCH},
					   {"INCH/MINUTE", MM_PER_INCH},
					   {NULL, 0}};
static const struct unit rotary_rates[] = {{"DEGREE/SECOND", SECONDS_PER_MINUTE},
					   {"DEGREE/MINUTE", 1},
					   {"REVOLUTION/MINUTE", 360},
					   {NULL, 0}};

/* False, reported: the unit is none of these. According to the standard a document without a unit has the first one. */
static bool read_unit(struct xml_reader *xml, const xmlNode *node, const struct unit *units, double *scale)
{
	const char *name = foreign_attribute(node, "units");

	*scale = units[0].scale;
	if (!name)
		return true;
	for (; units->name; units++)
		if (!strcmp(name, units->name)) {
			*scale = units->scale;
			return true;
		}
	xml_error(xml, node, "units", "the unit '%s' is not supported here", xml_quote(name).text);
	return false;
}

/* Narrows the travel by Minimum and Maximum below `node`. */
static bool narrow(struct xml_reader *xml, const xmlNode *node, double scale, struct axis_description *axis)
{
	const xmlNode *least = foreign_child(node, "Minimum"), *most = foreign_child(node, "Maximum");
	double value;

	if (least) {
		if (!foreign_number(xml, least, NULL, &value))
			return false;
		axis->limit_min = fmax(axis->limit_min, scale * value);
	}
	if (most) {
		if (!foreign_number(xml, most, NULL, &value))
			return false;
		axis->limit_max = fmin(axis->limit_max, scale * value);
	}
	return true;
}

static bool read_rate(struct xml_reader *xml, const xmlNode *spec, struct axis_description *axis)
{
	const xmlNode *most = foreign_child(spec, "Maximum");
	double scale, value;

	if (!most || foreign_attribute_is(spec, "subType", "PROGRAMMED"))
		return true;
	if (!read_unit(xml, spec, axis->rotary ? rotary_rates : linear_rates, &scale) ||
	    !foreign_number(xml, most, NULL, &value))
		return false;
	if (value > 0 && (!(axis->rate_max > 0) || scale * value < axis->rate_max))
		axis->rate_max = scale * value;
	return true;
}

static bool read_specifications(struct xml_reader *xml, const xmlNode *node, struct axis_description *axis)
{
	const xmlNode *list = foreign_child(foreign_child(node, "Configuration"), "Specifications");

	for (const xmlNode *at = foreign_child(list, "Specification"); at; at = foreign_next(at, "Specification")) {
		double scale;

		if (foreign_attribute_is(at, "type", axis->rotary ? "ANGLE" : "POSITION")) {
			if (!read_unit(xml, at, axis->rotary ? angles : lengths, &scale) ||
			    !narrow(xml, at, scale, axis))
				return false;
		} else if (foreign_attribute_is(at, "type", "VELOCITY") ||
			   (axis->rotary && foreign_attribute_is(at, "type", "ANGULAR_VELOCITY"))) {
			if (!read_rate(xml, at, axis))
				return false;
		}
	}
	return true;
}

/* Is the data item in machine coordinates? */
static bool is_machine_item(const xmlNode *device, const xmlNode *item)
{
	const char *name = foreign_attribute(item, "coordinateSystemIdRef"), *id;

	for (const xmlNode *at = device; name && at; at = mtconnect_next(device, at))
		if (foreign_is(at, "CoordinateSystem") && (id = foreign_attribute(at, "id")) != NULL &&
		    !strcmp(id, name))
			return foreign_attribute_is(at, "type", "MACHINE");
	return foreign_attribute_is(item, "coordinateSystem", "MACHINE");
}

static bool read_constraints(struct xml_reader *xml, const xmlNode *device, const xmlNode *node,
			     struct axis_description *axis)
{
	const xmlNode *list = foreign_child(node, "DataItems");

	for (const xmlNode *at = foreign_child(list, "DataItem"); at; at = foreign_next(at, "DataItem")) {
		const xmlNode *constraints = foreign_child(at, "Constraints");
		double scale;

		if (!constraints || !is_machine_item(device, at) ||
		    !foreign_attribute_is(at, "type", axis->rotary ? "ANGLE" : "POSITION"))
			continue;
		if (!read_unit(xml, at, axis->rotary ? angles : lengths, &scale) ||
		    !narrow(xml, constraints, scale, axis))
			return false;
	}
	return true;
}

bool mtconnect_travel(struct xml_reader *xml, const xmlNode *device, const xmlNode *component,
		      struct axis_description *axis)
{
	axis->limit_min = -INFINITY;
	axis->limit_max = INFINITY;
	if (!read_specifications(xml, component, axis) || !read_constraints(xml, device, component, axis))
		return false;
	if (!(axis->limit_min < axis->limit_max))
		xml_error(xml, component, NULL, "the Minimum of the travel of this axis is not below its Maximum");
	return axis->limit_min < axis->limit_max;
}
