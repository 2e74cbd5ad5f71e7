#include "import/freecad_machine.h"

#include <ctype.h>
#include <math.h>
#include <stdarg.h>
#include <string.h>

#include "base/axes.h"
#include "base/strbuf.h"
#include "base/units.h"
#include "control/dialects.h"
#include "import/axis_chains.h"
#include "machine/library/json_file.h"

/* FreeCAD ignores a shorter vector, and treats one with a larger part along Z as an axis along Z. */
#define SHORTEST 1e-6
#define ALONG_Z 0.9

enum side { SIDE_UNKNOWN, SIDE_TABLE, SIDE_HEAD };

struct freecad_axis {
	struct axis_description axis;
	enum side side;
	char parent;	/* letter; 0: none */
	bool placed;
};

struct reading {
	struct import_machine *machine;
	const struct import_options *options;
	struct diag *diag;
	const char *path;
	double unit;	/* mm */
	struct freecad_axis axes[SLOT_COUNT];
	struct axis_letters letters;	/* of all axes: linear ones, rotary ones, U, V and W */
};

static struct srcloc place(const struct reading *r)
{
	return (struct srcloc){.file = r->path};
}

static bool fault(const struct reading *r, const char *format, ...) __attribute__((format(printf, 2, 3)));

static bool fault(const struct reading *r, const char *format, ...)
{
	struct strbuf text = {0};
	va_list args;

	va_start(args, format);
	strbuf_addv(&text, format, args);
	va_end(args);
	diag_error(r->diag, place(r), "%s", strbuf_text(&text));
	strbuf_release(&text);
	return false;
}

/* Notes a task for the user, and reports it at once. */
static void warn(struct reading *r, const char *format, ...) __attribute__((format(printf, 2, 3)));

static void warn(struct reading *r, const char *format, ...)
{
	struct strbuf text = {0};
	va_list args;

	va_start(args, format);
	strbuf_addv(&text, format, args);
	va_end(args);
	diag_warning(r->diag, place(r), "%s", strbuf_text(&text));
	text.text[0] = (char)toupper((unsigned char)text.text[0]);
	import_machine_todo(r->machine, "%s.", strbuf_text(&text));
	strbuf_release(&text);
}

/* ------------------------------------------------------------------- values */

static bool read_vector(const json_t *array, vec3 *vector)
{
	double parts[3];

	if (json_array_size(array) != 3)
		return false;
	for (size_t i = 0; i < 3; i++) {
		const json_t *part = json_array_get(array, i);

		if (!json_is_number(part) || !isfinite(json_number_value(part)))
			return false;
		parts[i] = json_number_value(part);
	}
	*vector = (vec3){parts[0], parts[1], parts[2]};
	return true;
}

static bool is_none(vec3 v)
{
	return vec3_norm(v) <= SHORTEST;
}

/*
 * "joint" is {"origin": [], "axis": []}, or two vectors: the first versions of FreeCAD write the direction of a linear
 * axis first, later ones last. Therefore a joint of a linear axis with two vectors other than 0 is rejected.
 */
static bool read_joint(const struct reading *r, const json_t *data, char letter, struct axis_description *axis)
{
	const json_t *joint = json_object_get(data, "joint");
	vec3 first, second;

	if (json_is_object(joint)) {
		if (!read_vector(json_object_get(joint, "origin"), &axis->location) ||
		    !read_vector(json_object_get(joint, "axis"), &axis->direction) || is_none(axis->direction))
			return fault(r,
				     "axis %c: joint needs an origin and an axis of three numbers each, and the axis "
				     "must not be 0 0 0", letter);
		return true;
	}
	if (json_array_size(joint) != 2 || !read_vector(json_array_get(joint, 0), &first) ||
	    !read_vector(json_array_get(joint, 1), &second) || (is_none(first) && is_none(second)))
		return fault(r, "axis %c: joint must be two vectors of three numbers each, and not both 0 0 0", letter);
	if (!axis->rotary && !is_none(first) && !is_none(second))
		return fault(r,
			     "axis %c: versions of FreeCAD differ in which vector of this joint is the direction of a "
			     "linear axis: write it as {\"origin\": [0, 0, 0], \"axis\": [...]}", letter);
	axis->direction = is_none(second) ? first : second;
	axis->location = is_none(second) || !axis->rotary ? (vec3){0, 0, 0} : first;
	return true;
}

/* "limits" contains the travel, and in files of the first versions the axis itself. */
static bool read_travel(struct reading *r, const json_t *data, char letter, struct axis_description *axis)
{
	const double scale = axis->rotary ? radians(1) : r->unit;
	const json_t *limits = json_object_get(data, "limits");
	double least = NAN, most = NAN, rate = 0;

	if (!json_file_number(data, "min", &least) || !json_file_number(data, "max", &most) ||
	    !json_file_number(limits, "min", &least) || !json_file_number(limits, "max", &most) ||
	    !json_file_number(data, "max_velocity", &rate))
		return fault(r, "axis %c: min, max and max_velocity must be numbers", letter);
	if (isnan(least) || isnan(most))
		warn(r, "the axis %c has no travel in this file: add limit_min and limit_max", letter);
	if (!isnan(least) && !isnan(most) && !(least < most))
		return fault(r, "axis %c: min is not below max", letter);
	axis->limit_min = isnan(least) ? -INFINITY : scale * least;
	axis->limit_max = isnan(most) ? INFINITY : scale * most;
	axis->rate_max = rate > 0 ? (axis->rotary ? 1 : r->unit) * rate : 0;
	return true;
}

static bool read_role(const struct reading *r, const json_t *data, char letter, struct freecad_axis *axis)
{
	static const struct {
		const char *name;
		enum side side;
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
	       fault(r, "axis %c: role must be table_%s or head_%s", letter,
		     axis->axis.rotary ? "rotary" : "linear", axis->axis.rotary ? "rotary" : "linear");
}

static bool read_parent(const struct reading *r, const json_t *data, char letter, char *parent)
{
	const json_t *at = json_object_get(data, "parent");
	const char *name = json_string_value(at);

	if (!at || json_is_null(at))
		return true;
	if (!name || strlen(name) != 1 || !axis_letters_have(r->letters.text, *name) || *name == letter)
		return fault(r, "axis %c: parent must be another axis of this file, or null", letter);
	*parent = *name;
	return true;
}

/* ------------------------------------------------------------------- axes */

/* Reads the letters first, because a parent may come after its child. */
static bool read_letters(struct reading *r, const json_t *axes)
{
	static const char usual[] = "XYZABCUVW";
	const char *name;
	json_t *data;

	json_object_foreach ((json_t *)axes, name, data)
		if (strlen(name) != 1 || slot_of_letter(*name) < 0)
			return fault(r, "the name of an axis must be one of X, Y, Z, A, B, C, U, V and W, but one is "
					"\"%.20s\": rename it in FreeCAD", name);
	for (const char *at = usual; *at; at++) {
		const char letter[2] = {*at, '\0'};

		if (json_object_get(axes, letter))
			axis_letters_add(&r->letters, *at);
	}
	return *r->letters.text || fault(r, "the machine has no axes");
}

/*
 * Controls count X, Y and Z toward their letter: an opposite direction is a mirrored machine, or has another meaning.
 */
static bool judge_direction(const struct reading *r, char letter, const struct axis_description *axis)
{
	if (axis->rotary || axis->slot > SLOT_Z ||
	    vec3_dot(axis->direction, axis_chains_direction(axis->slot, false)) > 0)
		return true;
	return fault(r,
		     "axis %c: its direction %g %g %g does not point to +%c, the positive direction of the control "
		     "(the tool relative to the work, also for an axis of the table)", letter,
		     axis->direction.x, axis->direction.y, axis->direction.z, letter);
}

static bool read_axis(struct reading *r, const json_t *axes, char letter)
{
	const char name[2] = {letter, '\0'};
	const json_t *data = json_object_get(axes, name);
	const char *type = json_string_value(json_object_get(data, "type"));
	struct freecad_axis read = {.axis = {.slot = slot_of_letter(letter)}};
	bool rotary = type && (!strcmp(type, "rotary") || !strcmp(type, "angular"));

	if (!type || (!rotary && strcmp(type, "linear") != 0))
		return fault(r, "axis %c: type must be linear or rotary", letter);
	if (rotary != slot_is_rotary(read.axis.slot))
		return fault(r, "axis %c: type is %s, but X, Y, Z, U, V and W are linear, and A, B and C rotary",
			     letter, type);
	read.axis.rotary = read.axis.has_location = rotary;
	if (!read_joint(r, data, letter, &read.axis) || !judge_direction(r, letter, &read.axis) ||
	    !read_travel(r, data, letter, &read.axis) || !read_role(r, data, letter, &read) ||
	    !read_parent(r, data, letter, &read.parent))
		return false;
	read.axis.location = vec3_scale(r->unit, read.axis.location);
	if (rotary && is_none(read.axis.location))
		warn(r,
		     "the axis %c is at 0 0 0, which FreeCAD writes if the location is not given: correct its location",
		     letter);
	r->axes[read.axis.slot] = read;
	return true;
}

/* ------------------------------------------------------------------ chains */

static struct freecad_axis *axis_of(struct reading *r, char letter)
{
	return &r->axes[slot_of_letter(letter)];
}

/* FreeCAD computes with a table whose axis along Z is carried by the one perpendicular to Z. */
static bool is_along_z(const struct axis_description *axis)
{
	return fabs(vec3_unit(axis->direction).z) > ALONG_Z;
}

/* The position of an axis among those without a parent. */
static int turn_of(const struct freecad_axis *axis, enum side side)
{
	if (!axis->axis.rotary)
		return axis->axis.slot < SLOT_A ? 0 : 3;
	return side == SIDE_TABLE && is_along_z(&axis->axis) ? 2 : 1;
}

/* The next axis of the side: its parent is placed. 0: none remains, or all that remain wait for another. */
static char next_axis(struct reading *r, enum side side)
{
	for (int turn = 0; turn < 4; turn++)
		for (const char *at = r->letters.text; *at; at++) {
			const struct freecad_axis *axis = axis_of(r, *at);

			if (axis->side == side && !axis->placed && turn_of(axis, side) == turn &&
			    (!axis->parent || axis_of(r, axis->parent)->placed))
				return *at;
		}
	return 0;
}

static bool order_side(struct reading *r, enum side side, struct axis_letters *letters)
{
	for (char next; (next = next_axis(r, side)) != 0;) {
		axis_letters_add(letters, next);
		axis_of(r, next)->placed = true;
	}
	for (const char *at = r->letters.text; *at; at++) {
		const struct freecad_axis *axis = axis_of(r, *at);

		if (axis->side == side && axis->parent && axis_of(r, axis->parent)->side != side)
			return fault(r, "axis %c: its parent %c is on the other side, between base and %s", *at,
				     axis->parent, side == SIDE_TABLE ? "tool" : "work");
		if (axis->side == side && !axis->placed)
			return fault(r, "axis %c: the parents form a circle", *at);
	}
	return true;
}

/* Is the order of the table's rotary axes the one that FreeCAD computes with? */
static bool table_agrees(struct reading *r, const char *table)
{
	const struct freecad_axis *last = NULL;

	for (const char *at = table; *at; at++) {
		const struct freecad_axis *axis = axis_of(r, *at);

		if (!axis->axis.rotary)
			continue;
		if (last && (is_along_z(&last->axis) || !is_along_z(&axis->axis)))
			return fault(r,
				     "the table has several rotary axes, and the order of FreeCAD's parents "
				     "contradicts what FreeCAD computes: name the axes that carry the work (%s), in "
				     "order from the base, with --table=LETTERS", table);
		last = axis;
	}
	return true;
}

/* The sides of all axes: those of the user, else from their roles. */
static bool find_sides(struct reading *r)
{
	struct axis_letters asked;

	if (!axis_letters_read(&asked, "table", r->options->table, r->letters.text, r->diag))
		return false;
	for (const char *at = r->letters.text; *at; at++) {
		struct freecad_axis *axis = axis_of(r, *at);

		if (r->options->table)
			axis->side = axis_letters_have(asked.text, *at) ? SIDE_TABLE : SIDE_HEAD;
		if (axis->side == SIDE_UNKNOWN)
			return fault(r,
				     "this file does not say which axes carry the work and which the tool (\"role\", "
				     "which later versions of FreeCAD write): name those that carry the work, in order "
				     "from the base, with --table=LETTERS, such as --table=YX, or --table= for none");
	}
	return true;
}

static bool find_table(struct reading *r, struct axis_letters *table)
{
	if (r->options->table)
		return axis_letters_read(table, "table", r->options->table, r->letters.text, r->diag);
	*table = (struct axis_letters){""};
	return order_side(r, SIDE_TABLE, table) && table_agrees(r, table->text);
}

static bool find_head(struct reading *r, const char *table, struct axis_letters *head)
{
	struct axis_letters usual = {""}, ordered = {""};

	if (r->options->head || r->options->table)
		return axis_letters_head(head, r->options->head, r->letters.text, table, place(r), r->diag);
	/* The first call rejects several rotary axes; the second takes parents into account. */
	if (!axis_letters_head(&usual, NULL, r->letters.text, table, place(r), r->diag) ||
	    !order_side(r, SIDE_HEAD, &ordered))
		return false;
	*head = ordered;
	return true;
}

static bool add_chains(struct reading *r)
{
	struct axis_description axes[SLOT_COUNT];
	struct axis_letters table, head;

	if (!find_sides(r) || !find_table(r, &table) || !find_head(r, table.text, &head))
		return false;
	for (int slot = 0; slot < SLOT_COUNT; slot++) {
		axes[slot] = r->axes[slot].axis;
		if (!axes[slot].rotary && r->axes[slot].side == SIDE_TABLE)
			axes[slot].direction = vec3_scale(-1, axes[slot].direction);
	}
	axis_chains_hang(r->machine, axes, table.text, head.text);
	import_machine_todo(r->machine,
			    "Compare the order of the axes with the machine: the work is carried by %s and the tool by "
			    "%s, from the base on.",
			    *table.text ? table.text : "the base", *head.text ? head.text : "the base");
	return true;
}

/* ------------------------------------------------------------------ machine */

static bool read_unit(struct reading *r, const json_t *data)
{
	const json_t *at = json_object_get(data, "units");
	const char *units = json_string_value(at);

	r->unit = 1;
	if (!at || (units && !strcmp(units, "metric")))
		return true;
	if (!units || strcmp(units, "imperial") != 0)
		return fault(r, "units must be metric or imperial");
	r->unit = MM_PER_INCH;
	warn(r,
	     "the units of this file are imperial: its lengths are assumed to be inches; compare the travels with the "
	     "machine");
	return true;
}

/* The vector of a tool head points to the tip of the tool; later files have none, and FreeCAD computes with -Z. */
static bool read_tool(struct reading *r, const json_t *data)
{
	const json_t *list = json_object_get(data, "toolheads"), *tool, *axis;
	const char *type;

	list = list ? list : json_object_get(data, "spindles");
	if (list && !json_is_array(list))
		return fault(r, "toolheads must be a list");
	tool = json_array_get(list, 0);
	type = json_string_value(json_object_get(tool, "toolhead_type"));
	axis = json_object_get(tool, "tool_axis");
	if (json_array_size(list) > 1)
		warn(r,
		     "this file has %zu tool heads, but a fivecheck machine has one spindle: the first is used",
		     json_array_size(list));
	if (type && strcmp(type, "rotary") != 0)
		warn(r, "the tool head is a %.20s: only the motion of its mount is checked", type);
	if (!axis)
		return true;
	if (!read_vector(axis, &r->machine->description.spindles[0].direction) ||
	    is_none(r->machine->description.spindles[0].direction))
		return fault(r, "tool_axis must be three numbers, and not 0 0 0");
	return true;
}

/* The frame of the base moves all axes in the same way, so no check depends on it. */
static bool judge_base(struct reading *r, const json_t *data)
{
	const json_t *frame = json_object_get(json_object_get(data, "kinematics"), "base_frame");
	const json_t *turn = json_object_get(frame, "orientation_quaternion");

	for (size_t i = 0; i < 3 && json_is_array(turn); i++)
		if (fabs(json_number_value(json_array_get(turn, i))) > SHORTEST)
			return fault(r,
				     "the base_frame of the machine is rotated, which is not supported: set "
				     "orientation_quaternion to 0, 0, 0, 1");
	return true;
}

static void take_control(struct reading *r, const json_t *root)
{
	const char *post = json_string_value(json_object_get(json_object_get(root, "postprocessor"), "file_name"));

	/*
	 * The name of a post-processor is a good guess; a comment of the machine file still asks the user to confirm
	 * it.
	 */
	for (int i = 0; post && dialect_names[i]; i++)
		if (!strcmp(post, dialect_names[i]))
			r->machine->description.controller.told.dialect = i;
}

static bool read_machine(struct reading *r, const json_t *root)
{
	struct import_machine *machine = r->machine;
	const json_t *data = json_object_get(root, "machine"), *axes = json_object_get(data, "axes");
	const char *name = json_string_value(json_object_get(data, "name"));

	if (!json_is_object(data) || !json_is_object(axes))
		return fault(r, "a FreeCAD machine needs \"machine\" with \"axes\" in it");
	if (!read_unit(r, data) || !judge_base(r, data) || !read_letters(r, axes))
		return false;
	for (const char *at = r->letters.text; *at; at++)
		if (!read_axis(r, axes, *at))
			return false;
	if (!add_chains(r) || !read_tool(r, data))
		return false;
	take_control(r, root);
	machine->description.name = name ? arena_strdup(&machine->description.arena, name) : NULL;
	import_machine_todo(machine, "The file has no bodies: add <body> elements, drawn with every axis at 0.");
	import_machine_todo(machine,
			    "The gauge point of the spindle and the mount of the work are at 0 0 0: correct both.");
	return true;
}

bool freecad_machine_read(struct import_machine *machine, const char *path, const struct import_options *options,
			  struct diag *diag)
{
	struct reading r = {.machine = machine, .options = options, .diag = diag, .path = path};
	json_t *root = json_file_read(path, diag);
	bool good;

	if (!root)
		return false;
	good = read_machine(&r, root);
	json_decref(root);
	return good;
}
