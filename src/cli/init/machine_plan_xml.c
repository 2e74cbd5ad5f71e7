#include "cli/init/machine_plan_xml.h"

#include "base/math/math_functions.h"
#include "base/xml_text.h"
#include "control/dialects.h"
#include "machine/machine.h"

/* Typical rates of a machining centre. Only times depend on them: with rapid="dogleg" the user gives the rates. */
#define LINEAR_RATE 30000.0	/* mm/min */
#define LINEAR_RATE_INCH 1200.0
#define ROTARY_RATE 7200.0	/* degrees/min */

static void indent(struct strbuf *out, int depth)
{
	strbuf_addf(out, "%*s", 2 * depth, "");
}

static void add_text(struct strbuf *out, const char *attribute, const char *text)
{
	if (text)
		xml_text_attribute(out, attribute, text);
}

static void add_number(struct strbuf *out, const char *attribute, double value)
{
	strbuf_addf(out, " %s=\"%.12g\"", attribute, value);
}

static void add_vector(struct strbuf *out, const char *attribute, vec3 v)
{
	strbuf_addf(out, " %s=\"%.12g %.12g %.12g\"", attribute, v.x, v.y, v.z);
}

/*
 * The direction in which the axis moves the bodies that it carries: along or about its own coordinate axis; a table
 * opposite to the tool.
 */
static vec3 direction_of(const struct machine_plan *plan, int slot)
{
	double sense = machine_plan_turns_table(plan, slot) ? -1 : 1;
	int k = slot_is_rotary(slot) ? slot - SLOT_A : slot - SLOT_X;

	if (plan->axes[slot].has_direction)
		return plan->axes[slot].direction;
	if (plan->axes[slot].has_inclination) {
		double across = sense * math_sin_degrees(plan->axes[slot].inclination);

		return (vec3){k == 0 ? across : 0, k == 1 ? across : 0,
			      sense * math_cos_degrees(plan->axes[slot].inclination) + 0.0}; /* 0, not -0, at 90 */
	}
	/* Halfway between its own coordinate axis and Z, like usual nutating heads and tables. */
	if (slot == machine_plan_tilted(plan))
		return (vec3){k == 0 ? sense : 0, k == 1 ? sense : 0, sense};
	return (vec3){k == 0 ? sense : 0, k == 1 ? sense : 0, k == 2 ? sense : 0};
}

static double rate_of(const struct machine_plan *plan, int slot)
{
	if (plan->axes[slot].has_rate)
		return plan->axes[slot].rate;
	if (slot_is_rotary(slot))
		return ROTARY_RATE;
	return plan->inch ? LINEAR_RATE_INCH : LINEAR_RATE;
}

static void add_bodies(struct strbuf *out, const struct machine_plan *plan, int slot, int depth)
{
	for (size_t i = 0; i < plan->body_count; i++) {
		if (plan->bodies[i].slot != slot)
			continue;
		indent(out, depth);
		strbuf_addf(out, "<body");
		add_text(out, "name", plan->bodies[i].name);
		add_text(out, "mesh", plan->bodies[i].path);
		strbuf_addf(out, "/>\n");
	}
}

/* The motion to check at the machine. */
static void add_jog(struct strbuf *out, const struct machine_plan *plan, int slot, int depth)
{
	const char *what = machine_plan_turns_table(plan, slot) ? "table" : "head";
	vec3 d = direction_of(plan, slot);

	indent(out, depth);
	strbuf_addf(out, "<!-- TODO Jog %c+: the %s must %s %.12g %.12g %.12g%s; if not, change the signs. -->\n",
		    AXIS_LETTERS[slot], what, slot_is_rotary(slot) ? "turn about" : "move along", d.x, d.y, d.z,
		    slot_is_rotary(slot) ? ", right-handed" : "");
}

static void add_axis(struct strbuf *out, const struct machine_plan *plan, int slot, int depth)
{
	const struct machine_plan_axis *axis = &plan->axes[slot];
	bool rotary = slot_is_rotary(slot);

	add_jog(out, plan, slot, depth);
	if (rotary && slot == machine_plan_tilted(plan) && !axis->has_direction &&
	    !axis->has_inclination) {
		indent(out, depth);
		strbuf_addf(out,
			    "<!-- TODO The axis is assumed to be at 45 degrees between %c and Z: verify it. -->\n",
			    AXIS_LETTERS[slot - SLOT_A + SLOT_X]);
	}
	indent(out, depth);
	strbuf_addf(out, "<axis name=\"%c\"", AXIS_LETTERS[slot]);
	add_text(out, "title", axis->title);
	add_text(out, "type", rotary ? "rotary" : "linear");
	add_vector(out, "direction", direction_of(plan, slot));
	if (rotary || axis->has_location)
		add_vector(out, "location", axis->location);
	if (axis->has_min)
		add_number(out, "limit_min", axis->min);
	if (axis->has_max)
		add_number(out, "limit_max", axis->max);
	add_number(out, "rate_max", rate_of(plan, slot));
	if (axis->has_home)
		add_number(out, "home", axis->home);
	strbuf_addf(out, ">\n");
	add_bodies(out, plan, slot, depth + 1);
}

/* The spindle or the workholding, at the end of a chain. */
static void add_end(struct strbuf *out, const struct machine_plan *plan, const struct machine_plan_chain *chain,
		    int depth)
{
	if (chain == &plan->head) {
		indent(out, depth);
		strbuf_addf(out, "<!-- The gauge point, and the direction from there to the tip of a tool. -->\n");
		indent(out, depth);
		strbuf_addf(out, "<spindle");
		add_vector(out, "location", plan->spindle);
		add_vector(out, "direction", plan->spindle_direction);
	} else {
		indent(out, depth);
		strbuf_addf(out, "<!-- %sThe origin of the fixtures and parts of a setup%s. -->\n",
			    plan->has_workholding ? "" : "TODO ",
			    plan->has_workholding ? "" : ": often the middle of the table");
		indent(out, depth);
		strbuf_addf(out, "<workholding");
		add_vector(out, "location", plan->workholding);
	}
	strbuf_addf(out, "/>\n");
}

static void add_chain(struct strbuf *out, const struct machine_plan *plan, const struct machine_plan_chain *chain)
{
	int depth = 2;

	for (size_t i = 0; i < chain->count; i++)
		add_axis(out, plan, chain->slots[i], depth++);
	add_end(out, plan, chain, depth);
	while (depth > 2) {
		indent(out, --depth);
		strbuf_addf(out, "</axis>\n");
	}
}

/* Does every axis have a given rate? */
static bool has_rates(const struct machine_plan *plan)
{
	for (int slot = 0; slot < SLOT_COUNT; slot++) {
		if (machine_plan_has_axis(plan, slot) && !plan->axes[slot].has_rate)
			return false;
	}
	return true;
}

static void add_tool_change(struct strbuf *out, const struct machine_plan *plan)
{
	strbuf_addf(out, ">\n    <tool_change");
	for (int slot = 0; slot < SLOT_COUNT; slot++) {
		const char name[] = {AXIS_LETTERS[slot], '\0'};

		if (plan->axes[slot].has_change)
			add_number(out, name, plan->axes[slot].change);
	}
	strbuf_addf(out, "/>\n");
}

static void add_controller(struct strbuf *out, const struct machine_plan *plan)
{
	strbuf_addf(out,
		    "  <!-- TODO The dialect of the programs, and how the control moves in G0. rapid: linear; dogleg\n"
		    "       (each axis at its own rate); any (not known: every path from start to end is checked).");
	if (dialect_rows[plan->dialect].has_parameters)
		strbuf_addf(
		    out, "\n       The parameters of the control say what M6 and G43 move, and how it starts.\n"
			 "       The check asks for them if a program needs them: <tool_change Z=\"0\"/>,\n"
			 "       length_offset_moves, least_input, power_on_units, power_on_distance,\n"
			 "       power_on_plane.");
	strbuf_addf(out, " -->\n  <controller");
	add_text(out, "dialect", dialect_names[plan->dialect]);
	add_text(out, "rapid", machine_plan_rapids[plan->rapid]);
	for (size_t i = 0; i < plan->answer_count; i++)
		add_text(out, plan->answers[i].name, plan->answers[i].value);
	if (plan->has_tool_change)
		add_tool_change(out, plan);
	strbuf_addf(out, plan->has_tool_change ? "  </controller>\n" : "/>\n");
}

static void add_head(struct strbuf *out, const struct machine_plan *plan)
{
	strbuf_addf(out, "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n"
			 "<!--\n"
			 "  A %s machine, written by fivecheck init. man 5 fivecheck-machine explains\n"
			 "  each element; man 7 fivecheck is the tutorial from the CAD assembly to the first verdict.\n"
			 "  TODO marks what you have to verify.\n"
			 "-->\n", machine_plan_families[plan->family]);
	strbuf_addf(out, "<machine version=\"1\"");
	add_text(out, "name", plan->name);
	add_text(out, "units", machine_plan_units[plan->inch]);
	strbuf_addf(out, ">\n");
	add_controller(out, plan);
}

void machine_plan_xml_write(struct strbuf *out, const struct machine_plan *plan)
{
	add_head(out, plan);
	strbuf_addf(
	    out,
	    "  <base>\n"
	    "    <!-- TODO The bodies. Draw the assembly with every axis at 0, and export each piece that\n"
	    "         moves as one as an STL file, in machine coordinates and %s. Put the bodies that an axis\n"
	    "         carries inside its <axis>. Rename, add and delete <body> lines as your machine needs. -->\n",
	    plan->inch ? "inches" : "mm");
	add_bodies(out, plan, -1, 2);
	if (!has_rates(plan))
		strbuf_addf(out,
			    "    <!-- TODO Every rate_max of %g (%s per minute) or %g (degrees per minute) is a\n"
			    "         guess; times depend on it. -->\n",
			    plan->inch ? LINEAR_RATE_INCH : LINEAR_RATE, machine_plan_units[plan->inch], ROTARY_RATE);
	strbuf_addf(out, "    <!-- From the base to the spindle. -->\n");
	add_chain(out, plan, &plan->head);
	strbuf_addf(out, "    <!-- From the base to the work. -->\n");
	add_chain(out, plan, &plan->table);
	strbuf_addf(out,
		    "  </base>\n"
		    "  <!-- fivecheck derives the pairs to check: the option list-pairs prints them. Give only\n"
		    "       exceptions here:\n"
		    "  <pairs>\n"
		    "    <pair a=\"Z\" b=\"base\" clearance=\"2\"/>\n"
		    "    <pair a=\"head\" b=\"bed\" check=\"never\" reason=\"the bellows yields\"/>\n"
		    "  </pairs> -->\n"
		    "</machine>\n");
}

void machine_plan_xml_chains(struct strbuf *out, const struct machine_plan *plan)
{
	strbuf_addf(out, "base");
	for (size_t i = 0; i < plan->head.count; i++)
		strbuf_addf(out, " > %c", AXIS_LETTERS[plan->head.slots[i]]);
	strbuf_addf(out, " > spindle; base");
	for (size_t i = 0; i < plan->table.count; i++)
		strbuf_addf(out, " > %c", AXIS_LETTERS[plan->table.slots[i]]);
	strbuf_addf(out, " > workholding");
}
