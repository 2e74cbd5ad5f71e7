#include "machine/machine_build.h"

#include <math.h>
#include <string.h>

#include "base/mem.h"
#include "base/units.h"
#include "machine/body_build.h"
#include "machine/controller_build.h"
#include "machine/setup_build.h"

/* The range of plausible rates, in mm or degrees a minute. */
#define RATE_MIN 1e-6
#define RATE_MAX 1e9
/*
 * mm: two bodies of neighbouring links within this distance at home are regarded as a guideway (fivecheck-machine(5)).
 */
#define ADJACENT_WITHIN 5.0
/* The permitted lengths of a vector that gives a direction. */
#define DIRECTION_MIN 1e-6
#define DIRECTION_MAX 1e6

/* The direction as a unit vector; Z after a fault. `element` is the name of the element with the attribute. */
static vec3 build_direction(struct description_file *file, const void *at, const char *element, vec3 v)
{
	double norm = vec3_norm(v);

	if (norm >= DIRECTION_MIN && norm <= DIRECTION_MAX)
		return vec3_scale(1 / norm, v);
	description_fault(file, at, "direction",
			  "direction=\"%s\" of <%s> is not a direction: its length must be between 1e-6 and 1e6",
			  description_quote(file, at, "direction").text, element);
	return (vec3){0, 0, 1};
}

/* ------------------------------------------------------------------- axes */

static void check_limits(struct description_file *file, const struct axis_description *described,
			 const struct axis *axis)
{
	if (!(axis->limit_min < axis->limit_max)) {
		description_fault(file, described->at, "limit_min",
				  "limit_min=\"%s\" of axis %s is not less than limit_max=\"%s\"",
				  description_quote(file, described->at, "limit_min").text, axis->name,
				  description_quote(file, described->at, "limit_max").text);
		return;
	}
	if (axis_allows(axis, axis->home))
		return;
	if (described->home.given)
		description_fault(file, described->at, "home", "home=\"%s\" of axis %s is outside its limits",
				  description_quote(file, described->at, "home").text, axis->name);
	else
		description_fault(file, described->at, NULL,
				  "0, the default home, is outside the limits of axis %s: give this axis a home",
				  axis->name);
}

static void check_kind(struct description_file *file, const struct axis_description *described,
		       const struct axis *axis)
{
	if (described->rotary != axis->rotary)
		description_fault(file, described->at, "type",
				  "axis %s cannot be %s: A B C are rotary, X Y Z U V W are linear", axis->name,
				  axis->rotary ? "linear" : "rotary");
	if (axis->rotary && !described->has_location)
		description_fault(file, described->at, NULL,
				  "rotary axis %s needs the attribute 'location', a point on its axis",
				  axis->name);
	if (!axis->rotary && axis->wrap != WRAP_NONE)
		description_fault(file, described->at, "wrap", "axis %s is linear: only a rotary axis can have wrap",
				  axis->name);
	if (!axis->rotary && axis->half_turn)
		description_fault(file, described->at, "half_turn",
				  "axis %s is linear: only a rotary axis can have half_turn", axis->name);
}

static void build_axis(struct description_file *file, const struct axis_description *described,
		       struct machine *machine)
{
	static const char *const names[SLOT_COUNT] = {"X", "Y", "Z", "A", "B", "C", "U", "V", "W"};
	struct axis *axis;

	if (machine_axis(machine, described->slot)) {
		description_fault(file, described->at, "name", "the machine has a second axis %s",
				  names[described->slot]);
		return;
	}
	axis = &machine->axes[machine->axis_count++];
	axis->name = names[described->slot];
	axis->title = described->title;
	axis->slot = described->slot;
	axis->rotary = slot_is_rotary(axis->slot);
	axis->parent = described->parent;
	axis->line = description_place(file, described->at).line;
	axis->checked = described->checked;
	axis->wrap = described->wrap;
	axis->half_turn = described->half_turn;
	axis->direction = build_direction(file, described->at, "axis", described->direction);
	axis->location = described->location;
	axis->limit_min = described->limit_min;
	axis->limit_max = described->limit_max;
	axis->home = described->home.value;
	axis->rate_max = (axis->rotary ? radians(described->rate_max) : described->rate_max) / SECONDS_PER_MINUTE;
	check_kind(file, described, axis);
	if (!(described->rate_max >= RATE_MIN && described->rate_max <= RATE_MAX))
		description_fault(file, described->at, "rate_max",
				  "rate_max=\"%s\" of axis %s is not between 1e-6 and 1e9 %s a minute",
				  description_quote(file, described->at, "rate_max").text, axis->name,
				  axis->rotary ? "degrees" : "mm");
	check_limits(file, described, axis);
}

/* ----------------------------------------------------------------- bodies */

static void build_bodies(struct machine_description *described, struct machine *machine)
{
	const xform zero = xform_identity();

	if (described->body_count > BODIES_MAX) {
		description_fault(&described->file, described->base, NULL,
				  "there are %zu bodies; more than %d are not supported", described->body_count,
				  BODIES_MAX);
		return;
	}
	machine->bodies = arena_alloc(&machine->arena, described->body_count * sizeof(*machine->bodies));
	for (size_t i = 0; i < described->body_count; i++) {
		const struct body_description *from = &described->bodies[i];
		struct body body = {.link = from->link};

		if (!body_build(&described->file, from, &zero, &body))
			continue;
		body_check_name(&described->file, from->at, body.name, machine->bodies, machine->body_count);
		machine->bodies[machine->body_count++] = body;
	}
}

static void build_mounts(struct machine_description *described, struct machine *machine)
{
	struct description_file *file = &described->file;

	for (size_t i = 0; i < described->spindle_count; i++) {
		const struct spindle_description *from = &described->spindles[i];

		if (i > 0)
			description_fault(file, from->at, NULL, "the machine has a second <spindle>");
		machine->spindle = (struct spindle){
			.present = true,
			.link = from->link,
			.location = from->location,
			.direction = build_direction(file, from->at, "spindle", from->direction),
			.checked = from->checked,
		};
	}
	for (size_t i = 0; i < described->workholding_count; i++) {
		const struct workholding_description *from = &described->workholdings[i];

		if (i > 0)
			description_fault(file, from->at, NULL, "the machine has a second <workholding>");
		machine->workholding = (struct workholding){.present = true,
							    .link = from->link,
							    .frame = from->frame,
							    .checked = from->checked};
	}
}

/* ------------------------------------------------------------------ pairs */

static struct pair_name build_pair_name(struct description_file *file, const void *at, const char *attribute,
					const char *name, const struct machine *machine)
{
	const struct axis *axis;

	if (!body_name_is_reserved(name))
		return (struct pair_name){.kind = NAME_BODY, .body = name};
	for (int role = ROLE_FIXTURE; body_roles[role]; role++)
		if (strcmp(name, body_roles[role]) == 0)
			return (struct pair_name){.kind = NAME_ROLE, .role = (enum body_role)role};
	if (strcmp(name, "base") == 0)
		return (struct pair_name){.kind = NAME_LINK, .link = 0};
	axis = machine_axis(machine, slot_of_letter(name[0]));
	if (axis)
		return (struct pair_name){.kind = NAME_LINK, .link = (int)(axis - machine->axes) + 1};
	description_fault(file, at, attribute, "%s=\"%s\" of <pair>: the machine has no axis %s", attribute, name,
			  name);
	return (struct pair_name){.kind = NAME_LINK, .link = 0};
}

static void build_pair(struct description_file *file, const struct pair_description *described,
		       const struct machine *machine, struct pair_rule *rule)
{
	const void *at = described->at;
	const char *reason = described->reason;
	bool clearance = described->clearance.given;

	rule->line = description_place(file, at).line;
	rule->check = described->check;
	rule->clearance = clearance ? described->clearance.value : -1;
	rule->reason = reason;
	rule->a = build_pair_name(file, at, "a", described->a, machine);
	rule->b = build_pair_name(file, at, "b", described->b, machine);
	if (strcmp(described->a, described->b) == 0)
		description_fault(file, at, "b", "<pair> names '%s' twice", description_quote(file, at, "a").text);
	if (clearance && rule->clearance < 0)
		description_fault(file, at, "clearance", "clearance=\"%s\" of <pair> is negative",
				  description_quote(file, at, "clearance").text);
	if (rule->check == PAIR_NEVER && clearance)
		description_fault(file, at, "clearance", "<pair> with check=\"never\" cannot have a clearance");
	if (rule->check == PAIR_NEVER && (!reason || !*reason))
		description_fault(file, at, NULL, "<pair> with check=\"never\" needs a reason=\"...\"");
	if (rule->check == PAIR_DERIVED && !clearance)
		description_fault(file, at, NULL, "<pair> needs a check or a clearance");
}

static void build_pairs(struct machine_description *described, struct machine *machine)
{
	struct description_file *file = &described->file;

	machine->adjacent_within =
	    described->adjacent_within.given ? described->adjacent_within.value : ADJACENT_WITHIN;
	if (described->pair_count > BODIES_MAX) {
		description_fault(file, described->pairs_at, NULL,
				  "there are %zu pairs; more than %d are not supported", described->pair_count,
				  BODIES_MAX);
		return;
	}
	machine->rules = arena_alloc(&machine->arena, described->pair_count * sizeof(*machine->rules));
	if (machine->adjacent_within < 0)
		description_fault(file, described->pairs_at, "adjacent_within",
				  "adjacent_within=\"%s\" of <pairs> is negative",
				  description_quote(file, described->pairs_at, "adjacent_within").text);
	for (size_t i = 0; i < described->pair_count; i++)
		build_pair(file, &described->pairs[i], machine, &machine->rules[machine->rule_count++]);
}

/* The order matters: pairs and places use names of axes, and setups are mounted on the spindle and the workholding. */
struct machine *machine_build(struct machine_description *described, struct diag *diag)
{
	struct machine *machine = mem_zalloc(1, sizeof(*machine));
	struct description_file *file = &described->file;
	bool good;

	machine->arena = described->arena;
	described->arena = (struct arena){0};
	machine->path = arena_strdup(&machine->arena, file->path);
	machine->name = described->name ? described->name : "";
	machine->base_checked = described->base_checked;
	controller_build(described, machine);
	for (size_t i = 0; i < described->axis_count; i++)
		build_axis(file, &described->axes[i], machine);
	build_bodies(described, machine);
	build_mounts(described, machine);
	controller_build_places(described, machine);
	build_pairs(described, machine);
	good = file->faults == 0;
	if (described->setup) {
		machine->setup = setup_build(described->setup, machine, diag);
		good = good && machine->setup;
	}
	if (good)
		return machine;
	machine_free(machine);
	return NULL;
}
