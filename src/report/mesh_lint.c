#include "report/mesh_lint.h"

#include "geom/nesting.h"
#include "geom/topology.h"
#include "report/doubt_text.h"
#include "report/format/format_units.h"
#include "scene/static_query.h"

/* Bodies this near at home touch: the default tolerance of a check, mm. */
static const double TOUCH = 0.001;

static void add_name(struct strbuf *out, const struct body *body)
{
	strbuf_addf(out, "  ");
	format_units_add_plain(out, body->name);
}

static void add_nesting(struct strbuf *out, const struct body *body, const struct mesh *mesh,
			const struct topology *topology)
{
	struct nesting nesting;

	nesting_find(&nesting, mesh, topology);
	if (nesting.inverted) {
		add_name(out, body);
		strbuf_addf(out, ": ");
		format_units_add_count(out, nesting.inverted, "shell");
		strbuf_addf(out, " drawn inside out (the triangles face inward): taken as solid all the same\n");
	}
	if (nesting.nested) {
		add_name(out, body);
		strbuf_addf(out, ": ");
		format_units_add_count(out, nesting.nested, "shell");
		strbuf_addf(
		    out, " inside another one that faces the same way: taken as solid throughout, not as a cavity\n");
	}
}

static void add_mesh(struct strbuf *out, const struct body *body, const struct mesh *mesh,
		     const struct topology *topology)
{
	if (topology->doubled) {
		add_name(out, body);
		strbuf_addf(out, ": drawn from both sides: ");
		format_units_add_count(out, topology->doubled, "triangle");
		strbuf_addf(out, " left out that another one covers, facing the other way\n");
	}
	if (topology_is_open(topology)) {
		add_name(out, body);
		strbuf_addf(out, ": the mesh is open, ");
		if (topology->open_edges) {
			format_units_add_count(out, topology->open_edges, "edge");
			strbuf_addf(out, " without a partner: ");
		}
		strbuf_addf(out, "what is inside it cannot be known\n");
	}
	add_nesting(out, body, mesh, topology);
	if (topology->flipped_edges) {
		add_name(out, body);
		strbuf_addf(out, ": neighbouring triangles face opposite ways at ");
		format_units_add_count(out, topology->flipped_edges, "edge");
		strbuf_addf(out, "\n");
	}
	if (topology->degenerate) {
		add_name(out, body);
		strbuf_addf(out, ": ");
		format_units_add_count(out, topology->degenerate, "triangle");
		strbuf_addf(out, " with corners that coincide\n");
	}
}

static bool add_meshes(struct strbuf *out, struct scene *scene, struct diag *diag)
{
	for (size_t i = 0; i < scene->body_count; i++) {
		const struct topology *topology = scene_body_topology(scene, (int)i, diag);

		if (!topology)
			return false;
		add_mesh(out, scene->bodies[i].body, &scene->bodies[i].bvh->mesh, topology);
	}
	return true;
}

static bool is_away(const struct scene *scene, const struct body *body)
{
	return body->tool && (!scene->setup || body->tool != scene->setup->initial_tool);
}

/* Lists overlaps of pairs that can move against each other, unless the user has waived the pair. */
static void add_overlaps(struct strbuf *out, struct scene *scene, struct diag *diag)
{
	axis_values home = machine_home(scene->machine);

	for (size_t i = 0; i < scene->pair_count; i++) {
		const struct scene_pair *pair = &scene->pairs[i];
		const struct body *a = scene->bodies[pair->a].body, *b = scene->bodies[pair->b].body;
		vec3 point;

		if (pair->status == PAIR_RIGID || pair->status == PAIR_WAIVED || pair->status == PAIR_CUTTING ||
		    is_away(scene, a) || is_away(scene, b))
			continue;
		if (!static_query_overlaps(scene, pair, &home, TOUCH, &point, diag))
			continue;
		add_name(out, a);
		strbuf_addf(out, " and ");
		format_units_add_plain(out, b->name);
		strbuf_addf(out, ": touch or overlap at home, near X %.3f Y %.3f Z %.3f (%s)\n", point.x + 0.0,
			    point.y + 0.0, point.z + 0.0, pair_status_name(pair->status));
	}
}

static void add_doubts(struct strbuf *out, const struct scene *scene)
{
	for (size_t i = 0; i < scene->doubts.count; i++) {
		strbuf_addf(out, "  ");
		doubt_text_add(out, scene, &scene->doubts.items[i]);
		strbuf_addf(out, "\n");
	}
}

bool mesh_lint_add(struct strbuf *out, struct scene *scene, struct diag *diag)
{
	size_t before, errors = diag->errors;

	strbuf_addf(out, "\noddities\n");
	before = out->length;
	if (!add_meshes(out, scene, diag))
		return false;
	add_overlaps(out, scene, diag);
	add_doubts(out, scene);
	if (out->length == before)
		strbuf_addf(out, "  none\n");
	return diag->errors == errors;
}
