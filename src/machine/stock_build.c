#include "machine/stock_build.h"

#include <float.h>

#include "geom/tolerance.h"
#include "machine/body_build.h"
#include "machine/tool_solid.h"

/* A corner of a box that stands on the origin, selected by the bits of its number. */
static vec3 box_corner(vec3 size, int number)
{
	return (vec3){number & 1 ? size.x / 2 : -size.x / 2, number & 2 ? size.y / 2 : -size.y / 2,
		      number & 4 ? size.z : 0};
}

static void make_box(vec3 size, struct arena *arena, struct mesh *mesh)
{
	static const int faces[12][3] = {{0, 2, 3}, {0, 3, 1}, {4, 5, 7}, {4, 7, 6}, {0, 1, 5}, {0, 5, 4},
					 {2, 6, 7}, {2, 7, 3}, {0, 4, 6}, {0, 6, 2}, {1, 3, 7}, {1, 7, 5}};

	*mesh = (struct mesh){.count = 12, .rounding = (double)FLT_EPSILON * vec3_norm(size)};
	mesh->triangles = arena_alloc(arena, mesh->count * sizeof(*mesh->triangles));
	for (int i = 0; i < 12; i++) {
		for (int k = 0; k < 3; k++) {
			const vec3 p = box_corner(size, faces[i][k]);
			float *v = mesh->triangles[i].v[k];

			v[0] = (float)p.x;
			v[1] = (float)p.y;
			v[2] = (float)p.z;
		}
	}
}

static void make_cylinder(vec3 size, struct arena *arena, struct mesh *mesh)
{
	const struct tool_section section = {size.z, size.x, size.x};
	const struct tool_solid solid = {.sections = &section, .count = 1, .top = size.z, .tip = TIP_FLAT};

	tool_solid_mesh(&solid, arena, mesh);
}

/* The triangles of a box or a cylinder enclose it as those of a tool do, so the limits of its size are the same. */
static bool has_size(struct description_file *file, const struct body_description *described)
{
	const vec3 size = described->size;
	const bool box = described->shape == STOCK_BOX;
	const double least = fmin(size.x, box ? fmin(size.y, size.z) : size.z);
	const double most = fmax(size.x, fmax(size.y, size.z));

	if (least >= TOOL_SECTION_MIN && most <= TOOL_SIZE_MAX)
		return true;
	description_fault(file, described->at, box ? "box" : "cylinder",
			  "%s=\"%s\" of <stock>: each dimension must be between %g and %g mm",
			  box ? "box" : "cylinder",
			  description_quote(file, described->at, box ? "box" : "cylinder").text, TOOL_SECTION_MIN,
			  TOOL_SIZE_MAX);
	return false;
}

void stock_build(struct description_file *file, const struct body_description *described, struct setup *setup,
		 struct body *body)
{
	struct mesh *mesh;

	body->rapid_allowance = body_build_depth(file, described->at, "stock", "rapid_allowance",
						 described->rapid_allowance, STOCK_RAPID_ALLOWANCE);
	body->uncertainty = body_build_depth(file, described->at, "stock", "uncertainty", described->uncertainty, 0);
	body->excess = body_build_depth(file, described->at, "stock", "excess", described->excess, 0);
	if (described->shape == STOCK_MESH || !has_size(file, described))
		return;
	mesh = arena_alloc(&setup->arena, sizeof(*mesh));
	if (described->shape == STOCK_BOX)
		make_box(described->size, &setup->arena, mesh);
	else
		make_cylinder(described->size, &setup->arena, mesh);
	/* The triangles of a cylinder enclose it. */
	if (described->shape == STOCK_CYLINDER && body->excess < TOOL_SOLID_DEVIATION)
		body->excess = TOOL_SOLID_DEVIATION;
	body->mesh_path = NULL;
	body->scale = 1;
	body->solid = mesh;
}
