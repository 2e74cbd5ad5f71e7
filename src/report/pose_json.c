#include "report/pose_json.h"

#include <math.h>

#include "report/format/json.h"

static const char *body_name(const struct scene *scene, int body)
{
	return scene->bodies[body].body->name;
}

static json_t *names_of(const struct scene *scene, const struct scene_pair *pair)
{
	json_t *names = json_array();

	json_push(names, json_text(body_name(scene, pair->a)));
	json_push(names, json_text(body_name(scene, pair->b)));
	return names;
}

/* The pairs in one of two states. */
static json_t *pairs_in(const struct scene *scene, const enum pose_state *states, enum pose_state one,
			enum pose_state other)
{
	json_t *pairs = json_array();

	for (size_t i = 0; i < scene->pair_count; i++) {
		if (states[i] == one || states[i] == other)
			json_push(pairs, names_of(scene, &scene->pairs[i]));
	}
	return pairs;
}

static json_t *nearest_of(const struct scene *scene, const struct pose_clearance *clearance)
{
	const struct scene_pair *pair = &scene->pairs[clearance->pair];
	json_t *object;

	if (!(clearance->distance < INFINITY))
		return json_null();
	object = json_object();
	json_put(object, "a", json_text(body_name(scene, pair->a)));
	json_put(object, "b", json_text(body_name(scene, pair->b)));
	json_put(object, "distance", json_real(clearance->distance));
	json_put(object, "on_a", json_point(clearance->on_a));
	json_put(object, "on_b", json_point(clearance->on_b));
	return object;
}

void pose_json_add(struct strbuf *out, const struct scene *scene, const axis_values *q, int tool,
		   const struct pose_clearance *clearance, const enum pose_state *states)
{
	json_t *object = json_object();
	size_t pairs = 0;

	for (size_t i = 0; i < sizeof(clearance->counts) / sizeof(clearance->counts[0]); i++)
		pairs += clearance->counts[i];
	json_put(object, "kind", json_string("pose"));
	json_put(object, "axes", json_axes(scene->machine, q));
	json_put(object, "tool", json_integer(tool));
	json_put(object, "pairs", json_integer((json_int_t)pairs));
	json_put(object, "nearest", nearest_of(scene, clearance));
	json_put(object, "meets", pairs_in(scene, states, POSE_OVERLAP, POSE_OVERLAP));
	json_put(object, "near", pairs_in(scene, states, POSE_NEAR, POSE_NEAR));
	json_put(object, "unknown", pairs_in(scene, states, POSE_UNKNOWN, POSE_FAILED));
	json_add_line(out, object);
}
