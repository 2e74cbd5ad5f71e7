#include "report/machine_report.h"

#include <math.h>

#include "base/units.h"
#include "control/dialects.h"
#include "machine/chain.h"
#include "report/axis_words.h"
#include "report/format/format_units.h"

struct machine_report {
	struct strbuf *out;
	struct scene *scene;
};

const char *machine_report_role(enum body_role role)
{
	return role == ROLE_MACHINE ? "body" : body_roles[role];
}

static void add_indent(struct strbuf *out, int depth)
{
	strbuf_addf(out, "%*s", 2 * depth, "");
}

static void add_direction(struct strbuf *out, vec3 v)
{
	strbuf_addf(out, "%.6g %.6g %.6g", v.x + 0.0, v.y + 0.0, v.z + 0.0);
}

const char *machine_report_rapid(enum rapid rapid)
{
	static const char *const names[] = {"linear", "dogleg", "any"};

	return names[rapid];
}

static void add_controller(struct strbuf *out, const struct controller *controller)
{
	strbuf_addf(out, "controller: %s, rapids %s%s, TCP's rotary zero %s", dialect_names[controller->dialect],
		    machine_report_rapid(controller->rapid),
		    controller->rapid == RAPID_ANY ? " (anywhere in the box of the move)" : "",
		    controller->tcp_zero_offset ? "the work offset's" : "the machine's");
	if (controller->path_tolerance > 0)
		strbuf_addf(out, ", path tolerance %.10g", controller->path_tolerance);
	strbuf_addf(out, "\n");
}

static void add_travel(struct strbuf *out, const struct axis *axis)
{
	const char *unit = format_units_unit(axis->slot);

	if (isinf(axis->limit_min) && isinf(axis->limit_max)) {
		strbuf_addf(out, "unlimited");
		return;
	}
	if (isinf(axis->limit_min))
		strbuf_addf(out, "unlimited");
	else
		strbuf_addf(out, "%.10g", format_units_value(axis->slot, axis->limit_min));
	if (isinf(axis->limit_max))
		strbuf_addf(out, " to unlimited");
	else
		strbuf_addf(out, " to %.10g", format_units_value(axis->slot, axis->limit_max));
	strbuf_addf(out, " %s", unit);
}

static void add_axis(struct strbuf *out, const struct axis *axis, int depth)
{
	static const char *const wraps[] = {"", ", wraps the shortest way", ", wraps by sign"};

	add_indent(out, depth);
	strbuf_addf(out, "%s", axis->name);
	if (axis->title) {
		strbuf_addf(out, " \"");
		format_units_add_plain(out, axis->title);
		strbuf_addf(out, "\"");
	}
	strbuf_addf(out, ": %s ", axis->rotary ? "rotary about" : "linear along");
	add_direction(out, axis->direction);
	if (axis->rotary) {
		strbuf_addf(out, " through ");
		add_direction(out, axis->location);
	}
	strbuf_addf(out, ", travel ");
	add_travel(out, axis);
	strbuf_addf(out, ", %.10g %s/min, home %.10g%s\n",
		    format_units_value(axis->slot, axis->rate_max) * SECONDS_PER_MINUTE, format_units_unit(axis->slot),
		    format_units_value(axis->slot, axis->home), wraps[axis->wrap]);
}

/* From all corners: the bounds of a rotated box would be too large. */
void machine_report_bounds(const struct mesh *mesh, const xform *placement, vec3 *least, vec3 *greatest)
{
	*least = (vec3){INFINITY, INFINITY, INFINITY};
	*greatest = vec3_scale(-1, *least);
	for (size_t i = 0; i < mesh->count; i++) {
		for (int k = 0; k < 3; k++) {
			vec3 corner = xform_apply(placement, mesh_corner(&mesh->triangles[i], k));

			*least = vec3_min(*least, corner);
			*greatest = vec3_max(*greatest, corner);
		}
	}
}

/* Three decimals; a number that rounds to zero has no sign. */
static void add_interval(struct strbuf *out, char axis, double least, double greatest)
{
	strbuf_addf(out, ", %c %.3f to %.3f", axis, fabs(least) < 0.0005 ? 0.0 : least,
		    fabs(greatest) < 0.0005 ? 0.0 : greatest);
}

static void add_body(const struct machine_report *tree, int index, int depth)
{
	const struct body *body = tree->scene->bodies[index].body;
	const struct bvh *bvh = scene_body_bvh(tree->scene, index);
	vec3 least, greatest;

	machine_report_bounds(&bvh->mesh, &body->placement, &least, &greatest);
	add_indent(tree->out, depth);
	strbuf_addf(tree->out, "%s ", machine_report_role(body->role));
	format_units_add_plain(tree->out, body->name);
	strbuf_addf(tree->out, ": ");
	format_units_add_count(tree->out, bvh->mesh.count, "triangle");
	add_interval(tree->out, 'X', least.x, greatest.x);
	add_interval(tree->out, 'Y', least.y, greatest.y);
	add_interval(tree->out, 'Z', least.z, greatest.z);
	strbuf_addf(tree->out, "\n");
}

/*
 * Appends a link's bodies, spindle and workholding, then the links that it carries; the recursion is as deep as the
 * axes.
 */
static void add_link(const struct machine_report *tree, int link, int depth)
{
	const struct machine *machine = tree->scene->machine;

	for (size_t i = 0; i < tree->scene->body_count; i++) {
		if (tree->scene->bodies[i].body->link == link)
			add_body(tree, (int)i, depth);
	}
	if (machine->spindle.present && machine->spindle.link == link) {
		add_indent(tree->out, depth);
		strbuf_addf(tree->out, "spindle at ");
		add_direction(tree->out, machine->spindle.location);
		strbuf_addf(tree->out, ", tool along ");
		add_direction(tree->out, machine->spindle.direction);
		strbuf_addf(tree->out, "\n");
	}
	if (machine->workholding.present && machine->workholding.link == link) {
		add_indent(tree->out, depth);
		strbuf_addf(tree->out, "workholding at ");
		add_direction(tree->out, machine->workholding.frame.translation);
		strbuf_addf(tree->out, "\n");
	}
	for (size_t i = 0; i < machine->axis_count; i++) {
		if (machine->axes[i].parent != link)
			continue;
		add_axis(tree->out, &machine->axes[i], depth);
		add_link(tree, (int)i + 1, depth + 1);
	}
}

static void add_table(struct strbuf *out, const struct machine *machine)
{
	strbuf_addf(out, "\nthe axis of a row carries the axes marked + (with everything on them)\n   ");
	for (size_t i = 0; i < machine->axis_count; i++)
		strbuf_addf(out, "  %s", machine->axes[i].name);
	strbuf_addf(out, "\n");
	for (size_t i = 0; i < machine->axis_count; i++) {
		strbuf_addf(out, "  %s", machine->axes[i].name);
		for (size_t j = 0; j < machine->axis_count; j++)
			strbuf_addf(out, "  %s",
				    i != j && machine_link_is_on(machine, (int)j + 1, (int)i + 1) ? "+" : ".");
		strbuf_addf(out, "\n");
	}
}

void machine_report_add(struct strbuf *out, struct scene *scene)
{
	const struct machine_report tree = {out, scene};
	const struct machine *machine = scene->machine;

	strbuf_addf(out, "machine: ");
	format_units_add_plain(out, machine->name);
	strbuf_addf(out, "%s(%s)\n", *machine->name ? " " : "", machine->path);
	add_controller(out, &machine->controller);
	strbuf_addf(out, "\nbase\n");
	add_link(&tree, 0, 1);
	add_table(out, machine);
	axis_words_add(out, machine);
}

void machine_report_add_oddities(struct strbuf *out, const struct oddities *oddities)
{
	strbuf_addf(out, "\noddities\n");
	for (size_t i = 0; i < oddities->count; i++)
		strbuf_addf(out, "  %s\n", strbuf_text(&oddities->items[i].text));
	if (!oddities->count)
		strbuf_addf(out, "  none\n");
}
