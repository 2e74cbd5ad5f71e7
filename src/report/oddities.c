#include "report/oddities.h"

#include <stdlib.h>

#include "base/mem.h"
#include "geom/nesting.h"
#include "geom/topology.h"
#include "report/doubt_text.h"
#include "report/format/format_units.h"
#include "scene/static_query.h"

/* mm: bodies within this distance at home touch: the default tolerance of a check. */
static const double TOUCH = 0.001;

const char *oddity_kind_name(enum oddity_kind kind)
{
	static const char *const names[] = {
		[ODDITY_DRAWN_TWICE] = "drawn-twice", [ODDITY_OPEN_MESH] = "open-mesh", [ODDITY_INVERTED] = "inverted",
		[ODDITY_NESTED] = "nested", [ODDITY_FLIPPED] = "flipped", [ODDITY_DEGENERATE] = "degenerate",
		[ODDITY_OVERLAP] = "overlap", [ODDITY_DOUBT] = "doubt",
	};

	return names[kind];
}

void oddities_release(struct oddities *oddities)
{
	for (size_t i = 0; i < oddities->count; i++)
		strbuf_release(&oddities->items[i].text);
	free(oddities->items);
	*oddities = (struct oddities){0};
}

/* The text of a new oddity, valid until the next one. */
static struct strbuf *add_oddity(struct oddities *oddities, enum oddity_kind kind)
{
	oddities->items = mem_grow(oddities->items, &oddities->capacity, oddities->count + 1, sizeof(*oddities->items));
	oddities->items[oddities->count] = (struct oddity){.kind = kind};
	return &oddities->items[oddities->count++].text;
}

/* The same, beginning with the name of the body. */
static struct strbuf *add_of(struct oddities *oddities, enum oddity_kind kind, const struct body *body)
{
	struct strbuf *text = add_oddity(oddities, kind);

	format_units_add_plain(text, body->name);
	return text;
}

static void add_nesting(struct oddities *out, const struct body *body, const struct mesh *mesh,
			const struct topology *topology)
{
	struct nesting nesting;
	struct strbuf *text;

	nesting_find(&nesting, mesh, topology);
	if (nesting.inverted) {
		text = add_of(out, ODDITY_INVERTED, body);
		strbuf_addf(text, ": ");
		format_units_add_count(text, nesting.inverted, "shell");
		strbuf_addf(text, " drawn inside out (the triangles face inward); treated as solid");
	}
	if (nesting.nested) {
		text = add_of(out, ODDITY_NESTED, body);
		strbuf_addf(text, ": ");
		format_units_add_count(text, nesting.nested, "shell");
		strbuf_addf(text,
			    " inside another one that faces the same way; treated as solid, not as a cavity");
	}
}

static void add_open(struct oddities *out, const struct body *body, const struct topology *topology)
{
	struct strbuf *text = add_of(out, ODDITY_OPEN_MESH, body);

	strbuf_addf(text, ": the mesh is open, ");
	if (topology->open_edges) {
		format_units_add_count(text, topology->open_edges, "edge");
		strbuf_addf(text, " with only one triangle: ");
	}
	strbuf_addf(text, "it has no defined inside");
}

static void add_mesh(struct oddities *out, const struct body *body, const struct mesh *mesh,
		     const struct topology *topology)
{
	struct strbuf *text;

	if (topology->doubled) {
		text = add_of(out, ODDITY_DRAWN_TWICE, body);
		strbuf_addf(text, ": drawn from both sides; ");
		format_units_add_count(text, topology->doubled, "triangle");
		strbuf_addf(text, " ignored that coincide with a triangle of the opposite direction");
	}
	if (topology_is_open(topology))
		add_open(out, body, topology);
	add_nesting(out, body, mesh, topology);
	if (topology->flipped_edges) {
		text = add_of(out, ODDITY_FLIPPED, body);
		strbuf_addf(text, ": neighbouring triangles face opposite ways at ");
		format_units_add_count(text, topology->flipped_edges, "edge");
	}
	if (topology->degenerate) {
		text = add_of(out, ODDITY_DEGENERATE, body);
		strbuf_addf(text, ": ");
		format_units_add_count(text, topology->degenerate, "triangle");
		strbuf_addf(text, " with corners that coincide");
	}
}

static void add_meshes(struct oddities *out, struct scene *scene)
{
	for (size_t i = 0; i < scene->body_count; i++) {
		const struct topology *topology = scene_body_topology(scene, (int)i);

		add_mesh(out, scene->bodies[i].body, &scene->bodies[i].bvh->mesh, topology);
	}
}

static bool is_away(const struct scene *scene, const struct body *body)
{
	return body->tool && (!scene->setup || body->tool != scene->setup->initial_tool);
}

/* Lists overlaps of pairs that can move relative to each other, unless the user has waived the pair. */
static void add_overlaps(struct oddities *out, struct scene *scene, struct diag *diag)
{
	axis_values home = machine_home(scene->machine);

	for (size_t i = 0; i < scene->pair_count; i++) {
		const struct scene_pair *pair = &scene->pairs[i];
		const struct body *a = scene->bodies[pair->a].body, *b = scene->bodies[pair->b].body;
		struct strbuf *text;
		vec3 point;

		if (pair->status == PAIR_RIGID || pair->status == PAIR_WAIVED || pair->status == PAIR_CUTTING ||
		    is_away(scene, a) || is_away(scene, b))
			continue;
		if (!static_query_overlaps(scene, pair, &home, TOUCH, &point, diag))
			continue;
		text = add_of(out, ODDITY_OVERLAP, a);
		strbuf_addf(text, " and ");
		format_units_add_plain(text, b->name);
		strbuf_addf(text, ": touch or overlap at home, near X %.3f Y %.3f Z %.3f (%s)", point.x + 0.0,
			    point.y + 0.0, point.z + 0.0, pair_status_name(pair->status));
	}
}

static void add_doubts(struct oddities *out, const struct scene *scene)
{
	for (size_t i = 0; i < scene->doubts.count; i++)
		doubt_text_add(add_oddity(out, ODDITY_DOUBT), scene, &scene->doubts.items[i]);
}

bool oddities_find(struct oddities *oddities, struct scene *scene, struct diag *diag)
{
	size_t errors = diag->errors;

	add_meshes(oddities, scene);
	add_overlaps(oddities, scene, diag);
	add_doubts(oddities, scene);
	return diag->errors == errors;
}
