#include "report/machine_json.h"

#include <math.h>
#include <stdlib.h>

#include "base/units.h"
#include "control/dialects.h"
#include "report/axis_words.h"
#include "report/format/format_units.h"
#include "report/format/json.h"
#include "report/machine_report.h"

/* The version of the format: raised by changes that break readers of the old form. */
enum { FORMAT = 1 };

static json_t *begin(const struct scene *scene, const char *kind)
{
	json_t *object = json_object();

	json_put(object, "kind", json_string(kind));
	json_put(object, "format", json_integer(FORMAT));
	json_put(object, "fivecheck", json_string(FIVECHECK_VERSION));
	json_put(object, "machine", json_text(scene->machine->path));
	return object;
}

/* Ends the document and releases it. */
static void add_document(struct strbuf *out, json_t *object)
{
	char *text = json_dumps(object, JSON_INDENT(1) | JSON_REAL_PRECISION(12));

	strbuf_addf(out, "%s\n", text);
	free(text);
	json_decref(object);
}

/* "X", or null for the base. */
static json_t *link_json(const struct machine *machine, int link)
{
	return link ? json_string(machine_link_name(machine, link)) : json_null();
}

static json_t *value_json(const struct axis *axis, double value)
{
	return isinf(value) ? json_null() : json_real(format_units_value(axis->slot, value));
}

static json_t *controller_json(const struct controller *controller)
{
	json_t *object = json_object();

	json_put(object, "dialect", json_string(dialect_names[controller->dialect]));
	json_put(object, "rapid", json_string(machine_report_rapid(controller->rapid)));
	json_put(object, "tcp_zero", json_string(controller->tcp_zero_offset ? "offset" : "machine"));
	json_put(object, "path_tolerance",
		 controller->path_tolerance > 0 ? json_real(controller->path_tolerance) : json_null());
	return object;
}

/* A description of the effect of a positive value. */
static json_t *words_json(const struct machine *machine, const struct axis *axis)
{
	struct strbuf words = {0};
	json_t *string;

	axis_words_add_axis(&words, machine, axis);
	string = json_text(strbuf_text(&words));
	strbuf_release(&words);
	return string;
}

static json_t *axis_json(const struct machine *machine, const struct axis *axis)
{
	static const char *const wraps[] = {"none", "shortest", "sign"};
	json_t *object = json_object();

	json_put(object, "name", json_string(axis->name));
	json_put(object, "title", json_text(axis->title));
	json_put(object, "type", json_string(axis->rotary ? "rotary" : "linear"));
	json_put(object, "on", link_json(machine, axis->parent));
	json_put(object, "direction", json_point(axis->direction));
	json_put(object, "location", axis->rotary ? json_point(axis->location) : json_null());
	json_put(object, "limit_min", value_json(axis, axis->limit_min));
	json_put(object, "limit_max", value_json(axis, axis->limit_max));
	json_put(object, "rate_max", json_real(format_units_value(axis->slot, axis->rate_max) * SECONDS_PER_MINUTE));
	json_put(object, "home", value_json(axis, axis->home));
	json_put(object, "wrap", json_string(wraps[axis->wrap]));
	json_put(object, "positive", words_json(machine, axis));
	json_put(object, "checked", json_text(axis->checked));
	return object;
}

static json_t *body_json(const struct machine *machine, const struct body *body, const struct mesh *mesh)
{
	json_t *object = json_object();
	vec3 least, greatest;

	machine_report_bounds(mesh, &body->placement, &least, &greatest);
	json_put(object, "name", json_text(body->name));
	json_put(object, "role", json_string(machine_report_role(body->role)));
	json_put(object, "on", link_json(machine, body->link));
	json_put(object, "tool", body->tool ? json_integer(body->tool) : json_null());
	json_put(object, "mesh", json_text(body->mesh_path));
	json_put(object, "triangles", json_integer((json_int_t)mesh->count));
	json_put(object, "least", json_point(least));
	json_put(object, "greatest", json_point(greatest));
	return object;
}

static json_t *spindle_json(const struct machine *machine)
{
	json_t *object;

	if (!machine->spindle.present)
		return json_null();
	object = json_object();
	json_put(object, "on", link_json(machine, machine->spindle.link));
	json_put(object, "location", json_point(machine->spindle.location));
	json_put(object, "direction", json_point(machine->spindle.direction));
	return object;
}

static json_t *workholding_json(const struct machine *machine)
{
	json_t *object;

	if (!machine->workholding.present)
		return json_null();
	object = json_object();
	json_put(object, "on", link_json(machine, machine->workholding.link));
	json_put(object, "location", json_point(machine->workholding.frame.translation));
	return object;
}

static json_t *oddities_json(const struct oddities *oddities)
{
	json_t *array = json_array();

	for (size_t i = 0; i < oddities->count; i++) {
		json_t *object = json_object();

		json_put(object, "kind", json_string(oddity_kind_name(oddities->items[i].kind)));
		json_put(object, "text", json_text(strbuf_text(&oddities->items[i].text)));
		json_push(array, object);
	}
	return array;
}

void machine_json_add(struct strbuf *out, struct scene *scene, const struct oddities *oddities)
{
	const struct machine *machine = scene->machine;
	json_t *object = begin(scene, "machine"), *axes = json_array(), *bodies = json_array();

	for (size_t i = 0; i < machine->axis_count; i++)
		json_push(axes, axis_json(machine, &machine->axes[i]));
	for (size_t i = 0; i < scene->body_count; i++) {
		const struct bvh *bvh = scene_body_bvh(scene, (int)i);

		json_push(bodies, body_json(machine, scene->bodies[i].body, &bvh->mesh));
	}
	json_put(object, "name", json_text(machine->name));
	json_put(object, "controller", controller_json(&machine->controller));
	json_put(object, "axes", axes);
	json_put(object, "bodies", bodies);
	json_put(object, "spindle", spindle_json(machine));
	json_put(object, "workholding", workholding_json(machine));
	json_put(object, "oddities", oddities_json(oddities));
	add_document(out, object);
}

void machine_json_add_pairs(struct strbuf *out, const struct scene *scene)
{
	json_t *object = begin(scene, "pairs"), *pairs = json_array();

	for (size_t i = 0; i < scene->pair_count; i++) {
		const struct scene_pair *pair = &scene->pairs[i];
		json_t *row = json_object();

		json_put(row, "a", json_text(scene->bodies[pair->a].body->name));
		json_put(row, "b", json_text(scene->bodies[pair->b].body->name));
		json_put(row, "status", json_string(pair_status_name(pair->status)));
		json_put(row, "clearance", json_real(pair->clearance));
		json_put(row, "reason", json_text(pair->reason));
		json_push(pairs, row);
	}
	json_put(object, "pairs", pairs);
	add_document(out, object);
}
