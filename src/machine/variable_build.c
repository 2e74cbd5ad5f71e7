#include "machine/variable_build.h"

#include <math.h>
#include <string.h>

#include "base/ascii.h"
#include "base/decimal.h"
#include "control/control_variable.h"
#include "control/dialects.h"

/* Elements of an array along one dimension. */
#define SIZE_MAX_EACH 32767

/* "10" or "3,4". False: the text has another form. */
static bool read_sizes(const char *text, struct control_variable *variable)
{
	for (;; text++) {
		int size = 0;

		text += strspn(text, " ");
		for (; ascii_is_digit(*text) && size <= SIZE_MAX_EACH; text++)
			size = 10 * size + (*text - '0');
		if (size < 1 || size > SIZE_MAX_EACH || variable->dimensions == CONTROL_DIMENSIONS)
			return false;
		variable->size[variable->dimensions++] = size;
		text += strspn(text, " ");
		if (*text != ',')
			return *text == '\0';
	}
}

static double number_of(const char *text, bool truths)
{
	double value;

	if (truths && (!strcmp(text, "TRUE") || !strcmp(text, "FALSE")))
		return text[0] == 'T';
	return decimal_read(text, strlen(text), &value) && isfinite(value) ? value : NAN;
}

static bool is_axis(const char *text)
{
	return text[0] && !text[1] && strchr(AXIS_LETTERS, text[0]);
}

/* An empty value, as in the element that messages print, was not filled in yet. */
static void check_value(struct description_file *file, const struct variable_description *described,
			const struct control_variable *variable)
{
	const bool number = variable->typed && variable->type != CONTROL_STRING && variable->type != CONTROL_AXIS;
	const bool macro = variable->name[0] == '#';

	if (!variable->text)
		return;
	if (!variable->text[0] && !(variable->typed && variable->type == CONTROL_STRING))
		description_fault(file, described->at, "value", "value of <variable> is empty: give the value of %s",
				  variable->name);
	else if ((number || (macro && strcmp(variable->text, "vacant") != 0)) && isnan(variable->number))
		description_fault(file, described->at, "value", "value=\"%s\" of <variable> is not a number%s",
				  description_quote(file, described->at, "value").text,
				  macro ? " and not \"vacant\"" : "");
	else if (variable->typed && variable->type == CONTROL_AXIS && !is_axis(variable->text))
		description_fault(file, described->at, "value", "value=\"%s\" of <variable> is not an axis letter",
				  description_quote(file, described->at, "value").text);
}

/* "#500", in one spelling: programs that are read use no other name for this variable. */
static bool is_numbered(const char *name)
{
	return name[0] == '#' && name[1] >= '1' && name[1] <= '9' && !name[1 + strspn(name + 1, "0123456789")];
}

static bool is_known(struct description_file *file, const struct variable_description *described,
		     const struct control_variable *variables, size_t count, const char *name)
{
	for (size_t i = 0; i < count; i++) {
		if (!strcmp(variables[i].name, name)) {
			description_fault(file, described->at, "name", "%s is given twice", name);
			return true;
		}
	}
	return false;
}

static void build_one(struct description_file *file, const struct variable_description *described,
		      const struct dialect_row *row, struct arena *arena, struct control_variable *variables,
		      size_t *count)
{
	const bool types = row->has_frames, numbered = row->has_parameters && !row->has_frames;
	struct control_variable variable = {.typed = described->type >= 0,
					    .type = described->type >= 0 ? (enum control_type)described->type
									 : CONTROL_REAL,
					    .text = described->value,
					    .number = described->value ? number_of(described->value, types) : NAN};
	char name[CONTROL_VARIABLE_NAME];

	if (!described->name)
		return;
	if (!control_variable_name_normalise(described->name, name) || (numbered && !is_numbered(name))) {
		description_fault(file, described->at, "name", "name=\"%s\" of <variable> is not a name%s",
				  description_quote(file, described->at, "name").text,
				  numbered ? ", such as #500" : "");
		return;
	}
	if ((variable.typed || described->size) && !types) {
		description_fault(file, described->at, variable.typed ? "type" : "size",
				  "<variable> of this control has only a name and a value, no type and no size");
		return;
	}
	if (described->size && (!variable.typed || !read_sizes(described->size, &variable)))
		description_fault(file, described->at, "size",
				  "size of <variable> must be one to three whole numbers, and needs a type: "
				  "size=\"10\", size=\"3,4\"");
	variable.name = arena_strdup(arena, name);
	variable.at = description_place(file, described->at);
	variable.at.file = arena_strdup(arena, variable.at.file);
	check_value(file, described, &variable);
	if (!is_known(file, described, variables, *count, name))
		variables[(*count)++] = variable;
}

/* Fills `variables`, which has room for all of them; returns the new count. */
static size_t build_all(struct description_file *file, const struct variable_description *described, size_t given,
			const struct dialect_row *row, struct arena *arena, struct control_variable *variables)
{
	size_t count = 0;

	if (given > 0 && !row->has_parameters && !row->has_planes && !row->has_frames) {
		description_fault(file, described[0].at, NULL,
				  "<variable>: only the program determines the value of %s",
				  row->title);
		return 0;
	}
	for (size_t i = 0; i < given; i++)
		build_one(file, &described[i], row, arena, variables, &count);
	return count;
}

void variable_build(struct machine_description *described, struct machine *machine)
{
	const struct controller_description *from = &described->controller;
	struct control_variable *variables = arena_alloc(&machine->arena, from->variable_count * sizeof(*variables));

	machine->controller.variable_count =
		build_all(&described->file, from->variables, from->variable_count,
			  &dialect_rows[from->told.dialect], &machine->arena, variables);
	machine->controller.variables = variables;
}

/*
 * A name with a type makes a variable; without a type it sets a value, which does not replace the type. A new
 * definition of an array removes all of its earlier elements.
 */
static bool replaces(const struct control_variable *own, const struct control_variable *other)
{
	const size_t length = strlen(own->name);

	if (strncmp(own->name, other->name, length) != 0)
		return false;
	return other->name[length] == '\0' ? own->typed || !other->typed : own->typed && other->name[length] == '[';
}

static bool is_replaced(const struct control_variable *items, size_t count, const struct control_variable *other)
{
	for (size_t i = 0; i < count; i++) {
		if (replaces(&items[i], other))
			return true;
	}
	return false;
}

void variable_build_setup(struct setup_description *described, const struct machine *machine, struct setup *setup)
{
	const struct controller *controller = &machine->controller;
	const size_t given = described->variable_count;
	struct control_variable *own, *all;
	size_t count, kept = 0;

	if (given == 0)
		return;
	own = arena_alloc(&setup->arena, given * sizeof(*own));
	all = arena_alloc(&setup->arena, (given + controller->variable_count) * sizeof(*all));
	count = build_all(&described->file, described->variables, given, &dialect_rows[controller->dialect],
			  &setup->arena, own);
	for (size_t i = 0; i < controller->variable_count; i++) {
		if (!is_replaced(own, count, &controller->variables[i]))
			all[kept++] = controller->variables[i];
	}
	memcpy(all + kept, own, count * sizeof(*all));
	setup->variables = all;
	setup->variable_count = kept + count;
}
