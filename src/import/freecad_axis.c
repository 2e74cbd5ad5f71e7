#include "import/freecad_axis.h"

#include <math.h>
#include <string.h>

#include "base/units.h"

/*
 * "joint" is {"origin": [], "axis": []}, or two vectors: the first versions of FreeCAD write the direction of a linear
 * axis first, later ones last. Therefore a joint of a linear axis with two vectors other than 0 is rejected.
 */
static bool read_joint(const struct freecad_reading *r, const json_t *data, char letter, struct axis_description *axis)
{
	const json_t *joint = json_object_get(data, "joint");
	vec3 first, second;

	if (json_is_object(joint)) {
		if (!freecad_read_vector(json_object_get(joint, "origin"), &axis->location) ||
		    !freecad_read_vector(json_object_get(joint, "axis"), &axis->direction) ||
		    freecad_is_none(axis->direction))
			return freecad_fault(r,
					     "axis %c: joint needs an origin and an axis of three numbers each, and "
					     "the axis must not be 0 0 0", letter);
		return true;
	}
	if (json_array_size(joint) != 2 || !freecad_read_vector(json_array_get(joint, 0), &first) ||
	    !freecad_read_vector(json_array_get(joint, 1), &second) ||
	    (freecad_is_none(first) && freecad_is_none(second)))
		return freecad_fault(r,
				     "axis %c: joint must be two vectors of three numbers each, and not both 0 0 0",
				     letter);
	if (!axis->rotary && !freecad_is_none(first) && !freecad_is_none(second))
		return freecad_fault(r,
				     "axis %c: versions of FreeCAD differ in which vector of this joint is the "
				     "direction of a linear axis: write it as {\"origin\": [0, 0, 0], \"axis\": "
				     "[...]}", letter);
	axis->direction = freecad_is_none(second) ? first : second;
	axis->location = freecad_is_none(second) || !axis->rotary ? (vec3){0, 0, 0} : first;
	return true;
}

/* "limits" contains the travel, and in files of the first versions the axis itself. */
static bool read_travel(struct freecad_reading *r, const json_t *data, char letter, struct axis_description *axis)
{
	const double scale = axis->rotary ? radians(1) : r->unit;
	const json_t *limits = json_object_get(data, "limits");
	double least = NAN, most = NAN, rate = 0;

	if (!json_file_number(data, "min", &least) || !json_file_number(data, "max", &most) ||
	    !json_file_number(limits, "min", &least) || !json_file_number(limits, "max", &most) ||
	    !json_file_number(data, "max_velocity", &rate))
		return freecad_fault(r, "axis %c: min, max and max_velocity must be numbers", letter);
	if (isnan(least) || isnan(most))
		freecad_warn(r, "the axis %c has no travel in this file: add limit_min and limit_max", letter);
	if (!isnan(least) && !isnan(most) && !(least < most))
		return freecad_fault(r, "axis %c: min is not below max", letter);
	axis->limit_min = isnan(least) ? -INFINITY : scale * least;
	axis->limit_max = isnan(most) ? INFINITY : scale * most;
	axis->rate_max = rate > 0 ? (axis->rotary ? 1 : r->unit) * rate : 0;
	return true;
}

static bool read_role(const struct freecad_reading *r, const json_t *data, char letter, struct freecad_axis *axis)
{
	static const struct {
		const char *name;
		enum freecad_side side;
		bool rotary;
	} roles[] = {
		{"table_linear", SIDE_TABLE, false},
		{"table_rotary", SIDE_TABLE, true},
		{"head_linear", SIDE_HEAD, false},
		{"head_rotary", SIDE_HEAD, true},
	};
	const json_t *at = json_object_get(data, "role");
	const char *role = json_string_value(at);

	if (!at || json_is_null(at))
		return true;
	for (size_t i = 0; role && i < sizeof(roles) / sizeof(*roles); i++)
		if (!strcmp(role, roles[i].name) && roles[i].rotary == axis->axis.rotary)
			axis->side = roles[i].side;
	return axis->side != SIDE_UNKNOWN ||
	       freecad_fault(r, "axis %c: role must be table_%s or head_%s", letter,
			     axis->axis.rotary ? "rotary" : "linear", axis->axis.rotary ? "rotary" : "linear");
}

static bool read_parent(const struct freecad_reading *r, const json_t *data, char letter, char *parent)
{
	const json_t *at = json_object_get(data, "parent");
	const char *name = json_string_value(at);

	if (!at || json_is_null(at))
		return true;
	if (!name || strlen(name) != 1 || !axis_letters_have(r->letters.text, *name) || *name == letter)
		return freecad_fault(r, "axis %c: parent must be another axis of this file, or null", letter);
	*parent = *name;
	return true;
}

/*
 * Controls count X, Y and Z toward their letter: an opposite direction is a mirrored machine, or has another meaning.
 */
static bool judge_direction(const struct freecad_reading *r, char letter, const struct axis_description *axis)
{
	if (axis->rotary || axis->slot > SLOT_Z ||
	    vec3_dot(axis->direction, axis_chains_direction(axis->slot, false)) > 0)
		return true;
	return freecad_fault(r,
			     "axis %c: its direction %g %g %g does not point to +%c, the positive direction of the "
			     "control (the tool relative to the work, also for an axis of the table)",
			     letter, axis->direction.x, axis->direction.y, axis->direction.z, letter);
}

bool freecad_axis_read(struct freecad_reading *r, const json_t *axes, char letter)
{
	const char name[2] = {letter, '\0'};
	const json_t *data = json_object_get(axes, name);
	const char *type = json_string_value(json_object_get(data, "type"));
	struct freecad_axis read = {.axis = {.slot = slot_of_letter(letter)}};
	bool rotary = type && (!strcmp(type, "rotary") || !strcmp(type, "angular"));

	if (!type || (!rotary && strcmp(type, "linear") != 0))
		return freecad_fault(r, "axis %c: type must be linear or rotary", letter);
	if (rotary != slot_is_rotary(read.axis.slot))
		return freecad_fault(r,
				     "axis %c: type is %s, but X, Y, Z, U, V and W are linear, and A, B and C rotary",
				     letter, type);
	read.axis.rotary = read.axis.has_location = rotary;
	if (!read_joint(r, data, letter, &read.axis) || !judge_direction(r, letter, &read.axis) ||
	    !read_travel(r, data, letter, &read.axis) || !read_role(r, data, letter, &read) ||
	    !read_parent(r, data, letter, &read.parent))
		return false;
	read.axis.location = vec3_scale(r->unit, read.axis.location);
	if (rotary && freecad_is_none(read.axis.location))
		freecad_warn(r,
			     "the axis %c is at 0 0 0, which FreeCAD writes if the location is not given: correct "
			     "its location", letter);
	r->axes[read.axis.slot] = read;
	return true;
}
