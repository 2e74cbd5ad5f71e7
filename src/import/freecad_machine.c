#include "import/freecad_machine.h"

#include <math.h>
#include <string.h>

#include "base/units.h"
#include "control/dialects.h"
#include "import/freecad_axis.h"

/* FreeCAD treats a vector with a larger part along Z as an axis along Z. */
#define ALONG_Z 0.9

/* Reads the letters first, because a parent may come after its child. */
static bool read_letters(struct freecad_reading *r, const json_t *axes)
{
	static const char usual[] = "XYZABCUVW";
	const char *name;
	json_t *data;

	json_object_foreach ((json_t *)axes, name, data)
		if (strlen(name) != 1 || slot_of_letter(*name) < 0)
			return freecad_fault(r,
					     "the name of an axis must be one of X, Y, Z, A, B, C, U, V and W, but "
					     "one is \"%.20s\": rename it in FreeCAD", name);
	for (const char *at = usual; *at; at++) {
		const char letter[2] = {*at, '\0'};

		if (json_object_get(axes, letter))
			axis_letters_add(&r->letters, *at);
	}
	return *r->letters.text || freecad_fault(r, "the machine has no axes");
}

/* ------------------------------------------------------------------ chains */

static struct freecad_axis *axis_of(struct freecad_reading *r, char letter)
{
	return &r->axes[slot_of_letter(letter)];
}

/* FreeCAD computes with a table whose axis along Z is carried by the one perpendicular to Z. */
static bool is_along_z(const struct axis_description *axis)
{
	return fabs(vec3_unit(axis->direction).z) > ALONG_Z;
}

/* The position of an axis among those without a parent. */
static int turn_of(const struct freecad_axis *axis, enum freecad_side side)
{
	if (!axis->axis.rotary)
		return axis->axis.slot < SLOT_A ? 0 : 3;
	return side == SIDE_TABLE && is_along_z(&axis->axis) ? 2 : 1;
}

/* The next axis of the side: its parent is placed. 0: none remains, or all that remain wait for another. */
static char next_axis(struct freecad_reading *r, enum freecad_side side)
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

static bool order_side(struct freecad_reading *r, enum freecad_side side, struct axis_letters *letters)
{
	for (char next; (next = next_axis(r, side)) != 0;) {
		axis_letters_add(letters, next);
		axis_of(r, next)->placed = true;
	}
	for (const char *at = r->letters.text; *at; at++) {
		const struct freecad_axis *axis = axis_of(r, *at);

		if (axis->side == side && axis->parent && axis_of(r, axis->parent)->side != side)
			return freecad_fault(r, "axis %c: its parent %c is on the other side, between base and %s", *at,
					     axis->parent, side == SIDE_TABLE ? "tool" : "work");
		if (axis->side == side && !axis->placed)
			return freecad_fault(r, "axis %c: the parents form a circle", *at);
	}
	return true;
}

/* Is the order of the table's rotary axes the one that FreeCAD computes with? */
static bool table_agrees(struct freecad_reading *r, const char *table)
{
	const struct freecad_axis *last = NULL;

	for (const char *at = table; *at; at++) {
		const struct freecad_axis *axis = axis_of(r, *at);

		if (!axis->axis.rotary)
			continue;
		if (last && (is_along_z(&last->axis) || !is_along_z(&axis->axis)))
			return freecad_fault(r,
					     "the table has several rotary axes, and the order of FreeCAD's parents "
					     "contradicts what FreeCAD computes: name the axes that carry the work "
					     "(%s), in order from the base, with --table=LETTERS", table);
		last = axis;
	}
	return true;
}

/* The sides of all axes: those of the user, else from their roles. */
static bool find_sides(struct freecad_reading *r)
{
	struct axis_letters asked;

	if (!axis_letters_read(&asked, "table", r->options->table, r->letters.text, r->diag))
		return false;
	for (const char *at = r->letters.text; *at; at++) {
		struct freecad_axis *axis = axis_of(r, *at);

		if (r->options->table)
			axis->side = axis_letters_have(asked.text, *at) ? SIDE_TABLE : SIDE_HEAD;
		if (axis->side == SIDE_UNKNOWN)
			return freecad_fault(r,
					     "this file does not say which axes carry the work and which the tool "
					     "(\"role\", which later versions of FreeCAD write): name those that "
					     "carry the work, in order from the base, with --table=LETTERS, such as "
					     "--table=YX, or --table= for none");
	}
	return true;
}

static bool find_table(struct freecad_reading *r, struct axis_letters *table)
{
	if (r->options->table)
		return axis_letters_read(table, "table", r->options->table, r->letters.text, r->diag);
	*table = (struct axis_letters){""};
	return order_side(r, SIDE_TABLE, table) && table_agrees(r, table->text);
}

static bool find_head(struct freecad_reading *r, const char *table, struct axis_letters *head)
{
	struct axis_letters usual = {""}, ordered = {""};

	if (r->options->head || r->options->table)
		return axis_letters_head(head, r->options->head, r->letters.text, table, freecad_place(r), r->diag);
	/* The first call rejects several rotary axes; the second takes parents into account. */
	if (!axis_letters_head(&usual, NULL, r->letters.text, table, freecad_place(r), r->diag) ||
	    !order_side(r, SIDE_HEAD, &ordered))
		return false;
	*head = ordered;
	return true;
}

static bool add_chains(struct freecad_reading *r)
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

static bool read_unit(struct freecad_reading *r, const json_t *data)
{
	const json_t *at = json_object_get(data, "units");
	const char *units = json_string_value(at);

	r->unit = 1;
	if (!at || (units && !strcmp(units, "metric")))
		return true;
	if (!units || strcmp(units, "imperial") != 0)
		return freecad_fault(r, "units must be metric or imperial");
	r->unit = MM_PER_INCH;
	freecad_warn(r,
		     "the units of this file are imperial: its lengths are assumed to be inches; compare the travels "
		     "with the machine");
	return true;
}

/* The vector of a tool head points to the tip of the tool; later files have none, and FreeCAD computes with -Z. */
static bool read_tool(struct freecad_reading *r, const json_t *data)
{
	const json_t *list = json_object_get(data, "toolheads"), *tool, *axis;
	const char *type;

	list = list ? list : json_object_get(data, "spindles");
	if (list && !json_is_array(list))
		return freecad_fault(r, "toolheads must be a list");
	tool = json_array_get(list, 0);
	type = json_string_value(json_object_get(tool, "toolhead_type"));
	axis = json_object_get(tool, "tool_axis");
	if (json_array_size(list) > 1)
		freecad_warn(r,
			     "this file has %zu tool heads, but a fivecheck machine has one spindle: the first is "
			     "used", json_array_size(list));
	if (type && strcmp(type, "rotary") != 0)
		freecad_warn(r, "the tool head is a %.20s: only the motion of its mount is checked", type);
	if (!axis)
		return true;
	if (!freecad_read_vector(axis, &r->machine->description.spindles[0].direction) ||
	    freecad_is_none(r->machine->description.spindles[0].direction))
		return freecad_fault(r, "tool_axis must be three numbers, and not 0 0 0");
	return true;
}

/* The frame of the base moves all axes in the same way, so no check depends on it. */
static bool judge_base(struct freecad_reading *r, const json_t *data)
{
	const json_t *frame = json_object_get(json_object_get(data, "kinematics"), "base_frame");
	const json_t *turn = json_object_get(frame, "orientation_quaternion");

	for (size_t i = 0; i < 3 && json_is_array(turn); i++)
		if (fabs(json_number_value(json_array_get(turn, i))) > FREECAD_SHORTEST)
			return freecad_fault(r,
					     "the base_frame of the machine is rotated, which is not supported: set "
					     "orientation_quaternion to 0, 0, 0, 1");
	return true;
}

static void take_control(struct freecad_reading *r, const json_t *root)
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

static bool read_machine(struct freecad_reading *r, const json_t *root)
{
	struct import_machine *machine = r->machine;
	const json_t *data = json_object_get(root, "machine"), *axes = json_object_get(data, "axes");
	const char *name = json_string_value(json_object_get(data, "name"));

	if (!json_is_object(data) || !json_is_object(axes))
		return freecad_fault(r, "a FreeCAD machine needs \"machine\" with \"axes\" in it");
	if (!read_unit(r, data) || !judge_base(r, data) || !read_letters(r, axes))
		return false;
	for (const char *at = r->letters.text; *at; at++)
		if (!freecad_axis_read(r, axes, *at))
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
	struct freecad_reading r = {.machine = machine, .options = options, .diag = diag, .path = path};
	json_t *root = json_file_read(path, diag);
	bool good;

	if (!root)
		return false;
	good = read_machine(&r, root);
	json_decref(root);
	return good;
}
