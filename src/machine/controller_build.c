#include "machine/controller_build.h"

#include <math.h>
#include <string.h>

#include "base/ascii.h"
#include "control/dialects.h"
#include "machine/variable_build.h"

#define MCODE_MAX 9999
/* mm or degrees: Fanuc's increment systems are IS-A (0.01) to IS-E (0.000001). */
#define LEAST_INPUT_MIN 1e-6
#define LEAST_INPUT_MAX 1.0

/* ------------------------------------------------------------- parameters */

static void build_mcode(struct description_file *file, const struct mcode_description *described, struct mcode *mcodes,
			size_t *count)
{
	if (described->number > MCODE_MAX) {
		description_fault(file, described->at, "number", "number=\"%s\" of <mcode> is not between 0 and %d",
				  description_quote(file, described->at, "number").text, MCODE_MAX);
		return;
	}
	/* M-codes for stops, program ends, spindle, coolant, tool change and calls. Every control agrees on these. */
	if (described->number <= 9 || described->number == 30 || described->number == 98 || described->number == 99) {
		description_fault(file, described->at, "number", "M%ld has a fixed meaning and cannot be redefined",
				  described->number);
		return;
	}
	for (size_t i = 0; i < *count; i++) {
		if (mcodes[i].number == described->number) {
			description_fault(file, described->at, "number", "M%ld is given twice", described->number);
			return;
		}
	}
	mcodes[(*count)++] = (struct mcode){(int)described->number, described->action};
}

/* Programs of users have lower numbers; O8000 to O9999 can be protected. */
#define PROGRAM_MAX 99999999
#define G_CODE_MAX 999.9
#define SAME_CODE 1e-9
/* 840D sl: names of programs. */
#define MACRO_NAME_MAX 32

/* The name in upper case, as controls store names; '$' begins the name of a setting. NULL: it is not a name. */
static const char *macro_name(struct arena *arena, const char *given)
{
	char *name = arena_strdup(arena, given);
	size_t length = name[0] == '$';

	for (; name[length]; length++) {
		const char byte = name[length];

		if (!ascii_is_letter(byte) && !ascii_is_digit(byte) && byte != '_')
			return NULL;
		name[length] = ascii_upper(byte);
	}
	return length <= MACRO_NAME_MAX ? name : NULL;
}

static bool is_same_name(const struct builder_macro *one, const struct builder_macro *other)
{
	return one->name && other->name && !strcmp(one->name, other->name);
}

/* Does the description identify one of the builder's macros? False: reported. */
static bool names_macro(struct description_file *file, const struct macro_description *described, bool names,
			const struct builder_macro *macro)
{
	if (!described->has_program && !described->code.given) {
		description_fault(file, described->at, NULL,
				  "<macro> needs a program or a code");
		return false;
	}
	if (described->name && !names) {
		description_fault(file, described->at, "program",
				  "program=\"%s\" of <macro> must be a number on this control",
				  description_quote(file, described->at, "program").text);
		return false;
	}
	if (described->name && !macro->name) {
		description_fault(file, described->at, "program",
				  "program=\"%s\" of <macro> is not a valid name (letters, digits and _, at most %d)",
				  description_quote(file, described->at, "program").text, MACRO_NAME_MAX);
		return false;
	}
	if (described->has_program && !described->name &&
	    (described->program < 1 || described->program > PROGRAM_MAX)) {
		description_fault(file, described->at, "program", "program=\"%s\" of <macro> is not between 1 and %d",
				  description_quote(file, described->at, "program").text, PROGRAM_MAX);
		return false;
	}
	if (described->code.given && !(macro->code > 0 && macro->code <= G_CODE_MAX))
		description_fault(file, described->at, "code", "code=\"%s\" of <macro> is not a G-code",
				  description_quote(file, described->at, "code").text);
	return true;
}

/* Reads X, Y and Z of action="around"; an error for any other action. */
static void read_around(struct description_file *file, const struct macro_description *described,
			struct builder_macro *macro)
{
	const bool around = described->action == MACRO_AROUND;
	bool any = false;

	for (int slot = 0; slot < SLOT_COUNT; slot++) {
		const char letter[] = {AXIS_LETTERS[slot], '\0'};
		double value = described->around[slot].value;

		if (!described->around[slot].given)
			continue;
		any = true;
		if (!around || slot > SLOT_Z || !(value >= 0))
			description_fault(
			    file, described->at, letter,
			    "%s of <macro>: X, Y and Z are the distances, 0 or more, that a macro with "
			    "action=\"around\" may move",
			    letter);
		else
			macro->around[slot] = value;
	}
	if (around && !any)
		description_fault(file, described->at, NULL, "<macro action=\"around\"> needs the distances X, Y, Z");
}

/* Does one of the earlier macros have the same name, number or code? If so, reports it. */
static bool is_given_twice(struct description_file *file, const struct macro_description *described,
			   const struct builder_macro *macro, const struct builder_macro *macros, size_t count)
{
	for (size_t i = 0; i < count; i++) {
		if (is_same_name(&macros[i], macro)) {
			description_fault(file, described->at, "program", "%s is given twice", macro->name);
			return true;
		}
		if (described->has_program && !described->name && macros[i].program == macro->program) {
			description_fault(file, described->at, "program", "O%d is given twice", macro->program);
			return true;
		}
		if (described->code.given && fabs(macros[i].code - macro->code) < SAME_CODE) {
			description_fault(file, described->at, "code", "G%.9g is given twice", macro->code);
			return true;
		}
	}
	return false;
}

/* `names`: the control also calls the builder's programs by name. */
static void build_macro(struct description_file *file, const struct macro_description *described, struct arena *arena,
			bool names, struct builder_macro *macros, size_t *count)
{
	struct builder_macro macro = {.program = described->has_program && !described->name ? (int)described->program
											   : MACRO_OF_CODE,
				      .code = described->code.value,
				      .action = described->action,
				      .name = described->name ? macro_name(arena, described->name) : NULL};

	if (!names_macro(file, described, names, &macro))
		return;
	read_around(file, described, &macro);
	if (!is_given_twice(file, described, &macro, macros, *count))
		macros[(*count)++] = macro;
}

/* A setting that this control does not have. */
struct needless {
	bool given;
	const char *name, *why;	/* the attribute; and what the control does instead */
};

#define NO_PARAMETER "has no such parameter"

static void refuse(struct description_file *file, const struct controller_description *described,
		   const struct needless *answers, size_t count)
{
	for (size_t i = 0; i < count; i++) {
		if (answers[i].given)
			description_fault(file, described->at, answers[i].name, "%s of <controller>: %s %s",
					  answers[i].name, dialect_rows[described->told.dialect].title, answers[i].why);
	}
}

#define REFUSE(file, described, answers) refuse(file, described, answers, sizeof(answers) / sizeof((answers)[0]))

/* Settings of a control whose programs have frames, tool edges, and planes that a cycle or a PLANE swivels. */
static void check_frames(struct description_file *file, const struct controller_description *described)
{
	const struct dialect_row *row = &dialect_rows[described->told.dialect];
	const bool frames = row->has_frames, planes = row->has_planes;
	const struct controller *told = &described->told;
	const struct needless answers[] = {
		{told->orientation_interpolation && !frames &&
		     (!row->has_tool_vectors ||
		      told->orientation_interpolation == ORIENTATION_INTERPOLATION_ORIWKS),
		 "orientation_interpolation", NO_PARAMETER},
		{told->rotation_order && !frames, "rotation_order", NO_PARAMETER},
		{told->comp_idle_blocks && !row->reads_idle_blocks, "cutter_comp_idle_blocks", NO_PARAMETER},
		{told->edge_after_tool_change && !frames, "edge_after_tool_change", NO_PARAMETER},
		{told->t_changes_tool && !frames, "t_changes_tool", NO_PARAMETER},
		{told->mirror_toggle && !frames, "mirror_toggle", NO_PARAMETER},
		{told->frames_outlive_traori && !frames, "frames_outlive_traori", NO_PARAMETER},
		{told->frames_outlive_cycle800 && !frames, "frames_outlive_cycle800", NO_PARAMETER},
		{told->length_along_z && !frames && !row->has_length_axis, "tool_length_axis", NO_PARAMETER},
		{told->swivel_axis && !frames, "swivel_axis", NO_PARAMETER},
		{told->orientation_pole && !frames, "orientation_pole", NO_PARAMETER},
		{told->power_on_work_offset && !frames, "power_on_work_offset", NO_PARAMETER},
		{told->increments_after_shift && !frames && !planes, "increments_after_shift", NO_PARAMETER},
		{told->increments_after_shift == INCREMENTS_TRAVERSE_SHIFT && !frames && planes,
		 "increments_after_shift", "supports only \"stay\""},
		{told->cycle_19_angles && !planes, "cycle_19_angles", NO_PARAMETER},
		{told->cycle_11_axes && !planes, "cycle_11_axes", NO_PARAMETER},
		{told->tool_def && !planes, "tool_def", NO_PARAMETER},
		{told->plane_retract && !planes, "plane_retract", NO_PARAMETER},
		{told->shift_behind_plane && !planes, "shift_behind_plane", NO_PARAMETER},
		{told->rotary_way && !planes && !frames, "rotary_way", NO_PARAMETER},
		{told->rotary_angle && !planes, "rotary_angle", NO_PARAMETER},
		{told->m6 && !planes, "m6", NO_PARAMETER},
		{told->plane_rotation && !planes, "plane_rotation", NO_PARAMETER},
		{told->swivel_pole && !planes && !frames, "swivel_pole", NO_PARAMETER},
	};

	REFUSE(file, described, answers);
}

/* Settings of a control with parameters that the builder sets. */
static void check_parameters(struct description_file *file, const struct controller_description *described)
{
	const struct controller *told = &described->told;
	const char *modes = "always starts with G21, G90 and G17";
	const struct needless answers[] = {
		{described->least_input.given, "least_input", "has no least input increment"},
		{told->length_moves, "length_offset_moves", "moves no axis when the length offset changes"},
		{told->g53_with_g91, "g53_with_g91", "refuses G53 while G91 is active"},
		{told->length_after_reference, "length_after_reference", "keeps the length offset"},
		{described->overrun.given, "unidirectional_overrun", "has no G60"},
		{described->arc_radius_tolerance.given, "arc_radius_tolerance", NO_PARAMETER},
		{told->m6_with_move, "m6_with_move", "changes the tool before a block moves"},
		{told->m6_with_t, "m6_with_t", "loads the tool of the T beside M6"},
		{told->length_under_g68, "length_under_g68", "has no G68 with I, J and K"},
		{told->polar_axis, "polar_axes", "has no polar coordinate interpolation"},
		{told->semicolon, "semicolon", "uses ';' for comments"},
		{told->power_on_motion, "power_on_motion", "starts without G0 or G1"},
		{told->cycle_axis, "cycle_axis", NO_PARAMETER},
		{told->cycle_repeats, "cycle_repeats", NO_PARAMETER},
		{told->colon, "colon", "has no program numbers after ':'"},
	}, others[] = {
		{told->comp_start, "cutter_comp_start", "has only one way to start cutter compensation"},
		{told->comp_corner, "cutter_comp_corner", "always rounds outside corners"},
		{told->power_on_units, "power_on_units", modes},
		{told->power_on_distance, "power_on_distance", modes},
		{told->power_on_plane, "power_on_plane", modes},
	};

	REFUSE(file, described, answers);
	if (told->comp_d != COMP_D_UNKNOWN)
		description_fault(file, described->at, "cutter_comp_d",
				  "cutter_comp_d of <controller>: in %s, D is the number of a tool",
				  dialect_rows[described->told.dialect].title);
	REFUSE(file, described, others);
}

/* Rejects settings for which the control has no parameter, according to the dialect's row. */
static void check_dialect(struct description_file *file, const struct controller_description *described)
{
	const struct dialect_row *row = &dialect_rows[described->told.dialect];

	check_frames(file, described);
	if (row->has_parameters)
		return;
	if (described->macro_count > 0 && !row->has_planes)
		description_fault(
		    file, described->macros[0].at, NULL,
		    "<macro> of <controller>: %s does not call a builder's programs by number; put a file of each into "
		    "a folder of --include",
		    row->title);
	check_parameters(file, described);
}

/* A setting that the file omits may be in the manual of the control's generation. */
static void apply_preset(struct description_file *file, const struct controller_description *described,
			 struct controller *controller)
{
	const struct dialect_row *row = &dialect_rows[described->told.dialect];
	const struct control_preset *preset;
	char names[128];

	if (!described->preset)
		return;
	preset = control_preset_find(row->presets, described->preset);
	if (preset) {
		control_preset_apply(preset, controller);
		return;
	}
	if (!row->presets) {
		description_fault(file, described->at, "preset",
				  "preset of <controller>: %s has no presets", row->title);
		return;
	}
	control_preset_names(row->presets, names, sizeof(names));
	description_fault(file, described->at, "preset", "preset=\"%s\" of <controller>: the presets of %s are %s",
			  description_quote(file, described->at, "preset").text, row->title, names);
}

static void check_ranges(struct description_file *file, const struct controller_description *from)
{
	if (from->path_tolerance.given && from->path_tolerance.value <= 0)
		description_fault(file, from->at, "path_tolerance",
				  "path_tolerance of <controller> must be greater than 0");
	if (from->arc_radius_tolerance.given && !(from->arc_radius_tolerance.value > 0))
		description_fault(file, from->at, "arc_radius_tolerance",
				  "arc_radius_tolerance of <controller> must be greater than 0");
	if (from->overrun.given && !(from->overrun.value > 0))
		description_fault(file, from->at, "unidirectional_overrun",
				  "unidirectional_overrun of <controller> must be greater than 0");
	if (from->least_input.given &&
	    !(from->least_input.value >= LEAST_INPUT_MIN && from->least_input.value <= LEAST_INPUT_MAX))
		description_fault(file, from->at, "least_input",
				  "least_input=\"%s\" of <controller> is not between 1e-6 and 1",
				  description_quote(file, from->at, "least_input").text);
}

void controller_build(struct machine_description *described, struct machine *machine)
{
	const struct controller_description *from = &described->controller;
	struct description_file *file = &described->file;
	const struct dialect_row *row = &dialect_rows[from->told.dialect];
	struct controller *to = &machine->controller;
	struct builder_macro *macros;
	struct mcode *mcodes;

	*to = from->told;
	to->unit = described->unit;
	if (!from->at)
		return;
	to->path_tolerance = from->path_tolerance.value;
	to->least_input = from->least_input.value;
	to->overrun = from->overrun.value;
	to->arc_radius_tolerance = from->arc_radius_tolerance.value;
	check_ranges(file, from);
	check_dialect(file, from);
	apply_preset(file, from, to);
	mcodes = arena_alloc(&machine->arena, from->mcode_count * sizeof(*mcodes));
	for (size_t i = 0; i < from->mcode_count; i++)
		build_mcode(file, &from->mcodes[i], mcodes, &to->mcode_count);
	to->mcodes = mcodes;
	macros = arena_alloc(&machine->arena, from->macro_count * sizeof(*macros));
	for (size_t i = 0; i < from->macro_count; i++)
		build_macro(file, &from->macros[i], &machine->arena, row->has_frames || row->has_planes, macros,
			    &to->macro_count);
	to->macros = macros;
	variable_build(described, machine);
}

/* ----------------------------------------------------------------- places */

static const char *element_of(const struct place_description *described)
{
	return described->tool_change ? "tool_change" : described->swivel_retract ? "swivel_retract" : "reference";
}

static void build_order(struct description_file *file, const struct place_description *described,
			struct control_place *place)
{
	bool seen[SLOT_COUNT] = {false};

	for (const char *at = described->order; *at; at++) {
		int slot = slot_of_letter(*at);

		if (*at == ' ')
			continue;
		if (slot < 0 || !place->has[slot]) {
			description_fault(file, described->at, "order",
					  "order of <%s> names '%c', but <%s> has no position for it",
					  element_of(described), *at > ' ' && *at < 127 ? *at : '?',
					  element_of(described));
			return;
		}
		if (seen[slot]) {
			description_fault(file, described->at, "order", "order of <%s> names %c twice",
					  element_of(described), *at);
			return;
		}
		seen[slot] = true;
		place->order[place->order_count++] = slot;
	}
	for (int slot = 0; slot < SLOT_COUNT; slot++)
		if (place->has[slot] && !seen[slot])
			description_fault(file, described->at, "order", "order of <%s> leaves out %c",
					  element_of(described), AXIS_LETTERS[slot]);
}

/* The default order: Z first, so that the tool leaves the work, then one axis after another. */
static void set_default_order(struct control_place *place)
{
	if (place->has[SLOT_Z])
		place->order[place->order_count++] = SLOT_Z;
	for (int slot = 0; slot < SLOT_COUNT; slot++)
		if (place->has[slot] && slot != SLOT_Z)
			place->order[place->order_count++] = slot;
}

static void build_value(struct description_file *file, const struct place_description *described,
			const struct machine *machine, int slot, struct control_place *place)
{
	const char letter[] = {AXIS_LETTERS[slot], '\0'};
	const struct axis *axis = machine_axis(machine, slot);
	double value = described->value[slot].value;

	if (!described->value[slot].given)
		return;
	if (!axis) {
		description_fault(file, described->at, letter,
				  "<%s> has a position for %s, but the machine has no axis %s", element_of(described),
				  letter, letter);
		return;
	}
	if (!axis_allows(axis, value))
		description_fault(file, described->at, letter, "%s=\"%s\" of <%s> is outside the limits of axis %s",
				  letter, description_quote(file, described->at, letter).text, element_of(described),
				  letter);
	place->has[slot] = true;
	place->value.v[slot] = value;
}

static void build_place(struct description_file *file, const struct place_description *described,
			const struct machine *machine, struct control_place *place)
{
	bool any = false;

	if (place->given) {
		description_fault(file, described->at, NULL, "<%s> is given twice", element_of(described));
		return;
	}
	place->given = true;
	for (int slot = 0; slot < SLOT_COUNT; slot++) {
		build_value(file, described, machine, slot, place);
		any = any || place->has[slot];
	}
	/* A <tool_change> without positions: the tool is changed at the current position of the spindle. */
	if (!any && (!described->tool_change || described->order))
		description_fault(file, described->at, NULL, "<%s> has no position", element_of(described));
	else if (described->order)
		build_order(file, described, place);
	else if (described->tool_change)
		set_default_order(place);
}

void controller_build_places(struct machine_description *described, struct machine *machine)
{
	struct description_file *file = &described->file;
	struct controller *controller = &machine->controller;

	for (size_t i = 0; i < described->controller.place_count; i++) {
		const struct place_description *place = &described->controller.places[i];

		if (place->tool_change) {
			build_place(file, place, machine, &controller->tool_change);
		} else if (place->swivel_retract) {
			build_place(file, place, machine, &controller->swivel_retract);
		} else if (place->number >= 1 && place->number <= REFERENCES_MAX) {
			build_place(file, place, machine, &controller->references[place->number - 1]);
		} else {
			struct control_place none = {0};

			description_fault(file, place->at, "number",
					  "number=\"%s\" of <reference> is not between 1 and %d",
					  description_quote(file, place->at, "number").text, REFERENCES_MAX);
			build_place(file, place, machine, &none);
		}
	}
}
