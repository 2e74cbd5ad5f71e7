#include "report/picture/stage.h"

#include <math.h>
#include <stdlib.h>

#include "base/math/math_functions.h"
#include "base/mem.h"
#include "machine/chain.h"

/* ------------------------------------------------------------------ paints */

/* Bright enough for black text and the important bodies to stand out. */
static const uint32_t darkest[PAINT_CLASSES] = {
	[PAINT_NONE] = 0xf7f9fb, [PAINT_BASE] = 0xaab6c3, [PAINT_MOVING] = 0xa4b8cc, [PAINT_FIXTURE] = 0xb0b8bf,
	[PAINT_PART] = 0xcdb896, [PAINT_TOOL] = 0xb4b4b4, [PAINT_A] = 0x8e0d14, [PAINT_B] = 0xa85a00,
	[PAINT_CONTACT_A] = 0x4d0004, [PAINT_CONTACT_B] = 0x5a2d00,
	[PAINT_NEAR_A] = 0x1d4f86, [PAINT_NEAR_B] = 0x1a6b4a,
};
static const uint32_t brightest[PAINT_CLASSES] = {
	[PAINT_NONE] = 0xf7f9fb, [PAINT_BASE] = 0xe6ebf0, [PAINT_MOVING] = 0xe0e8f0, [PAINT_FIXTURE] = 0xe8ebee,
	[PAINT_PART] = 0xf4e8d2, [PAINT_TOOL] = 0xececec, [PAINT_A] = 0xff5a58, [PAINT_B] = 0xffb347,
	[PAINT_CONTACT_A] = 0x7d0a10, [PAINT_CONTACT_B] = 0x8f4c00,
	[PAINT_NEAR_A] = 0x7fb2ea, [PAINT_NEAR_B] = 0x77cfa4,
};

uint32_t paint_colour(uint8_t paint)
{
	const uint32_t low = darkest[paint / PAINT_LEVELS], high = brightest[paint / PAINT_LEVELS];
	const uint32_t level = paint % PAINT_LEVELS;
	uint32_t colour = 0;

	for (int shift = 0; shift < 24; shift += 8) {
		const uint32_t from = low >> shift & 255, to = high >> shift & 255;

		colour |= (from * (PAINT_LEVELS - 1 - level) + to * level) / (PAINT_LEVELS - 1) << shift;
	}
	return colour;
}

enum paint_class stage_class_a(const struct stage *stage)
{
	return stage->alarming ? PAINT_A : PAINT_NEAR_A;
}

enum paint_class stage_class_b(const struct stage *stage)
{
	return stage->alarming ? PAINT_B : PAINT_NEAR_B;
}

static bool is_moved(const struct stage *stage, int body)
{
	return stage->moved && machine_link_is_on(stage->scene->machine, stage->scene->bodies[body].body->link,
						  stage->moved);
}

enum paint_class stage_class(const struct stage *stage, int body)
{
	const struct body *it = stage->scene->bodies[body].body;

	if (body == stage->a || is_moved(stage, body))
		return stage_class_a(stage);
	if (body == stage->b)
		return stage_class_b(stage);
	switch (it->role) {
	case ROLE_MACHINE:
		return it->link ? PAINT_MOVING : PAINT_BASE;
	case ROLE_FIXTURE:
		return PAINT_FIXTURE;
	case ROLE_PART:
	case ROLE_STOCK:
		return PAINT_PART;
	case ROLE_HOLDER:
	case ROLE_SHANK:
	case ROLE_CUTTER:
		break;
	}
	return PAINT_TOOL;
}

/* ---------------------------------------------------------------- drawing */

vec3 camera_project(const struct camera *camera, const struct raster *raster, vec3 p)
{
	const vec3 off = vec3_sub(p, camera->centre);
	const double scale = camera->scale * raster->width;

	return (vec3){0.5 * raster->width + scale * vec3_dot(off, camera->right),
		      0.5 * raster->height - scale * vec3_dot(off, camera->up), vec3_dot(off, camera->toward)};
}

/* Unit vectors toward the lights: a strong one above the eye, from the left, and a weak one from the right. */
struct lights {
	vec3 strong, weak;
};

static vec3 light_from(const struct camera *camera, double right, double up)
{
	const vec3 light =
	    vec3_add(vec3_add(camera->toward, vec3_scale(up, camera->up)), vec3_scale(right, camera->right));

	return vec3_scale(1 / vec3_norm(light), light);
}

static struct lights lights_of(const struct camera *camera)
{
	return (struct lights){light_from(camera, -0.55, 0.9), light_from(camera, 1.2, 0)};
}

/* Unimportant bodies need few steps of brightness. */
static int level_of(enum paint_class class, double bright)
{
	const int steps = class < PAINT_A ? 3 : PAINT_LEVELS - 1;

	return (int)lround(fmin(fmax(bright, 0), 1) * steps) * (PAINT_LEVELS - 1) / steps;
}

/* Surfaces seen from inside look like those seen from outside. */
static uint8_t paint_of(const struct camera *camera, const struct lights *lights, enum paint_class class,
			const vec3 p[3])
{
	const vec3 n = vec3_cross(vec3_sub(p[1], p[0]), vec3_sub(p[2], p[0]));
	const double length = vec3_norm(n), towards = vec3_dot(n, camera->toward) < 0 ? -1 : 1;
	const double strong = length > 0 ? fmax(towards * vec3_dot(n, lights->strong) / length, 0) : 0;
	const double weak = length > 0 ? fmax(towards * vec3_dot(n, lights->weak) / length, 0) : 0;

	return (uint8_t)((int)class * PAINT_LEVELS + level_of(class, 0.1 + 0.75 * strong + 0.2 * weak));
}

bool stage_shows(const struct stage *stage, int body)
{
	const struct scene_body *it = &stage->scene->bodies[body];

	if (stage->alone && !is_moved(stage, body))
		return false;
	return it->bvh && (it->body->tool == 0 || it->body->tool == stage->tool);
}

const struct mesh *stage_mesh(const struct stage *stage, int body)
{
	const struct scene_body *it = &stage->scene->bodies[body];

	return stage->stock && it->body->role == ROLE_STOCK ? stage->stock : &it->bvh->mesh;
}

vec3 stage_middle(const struct stage *stage, int body, double *radius)
{
	const struct scene_body *it = &stage->scene->bodies[body];
	const xform link = machine_pose(stage->scene->machine, it->body->link, &stage->axes);
	const xform pose = xform_mul(&link, &it->body->placement);

	*radius = it->bvh->radius;
	return xform_apply(&pose, it->bvh->origin);
}

static bool is_in_sight(const struct stage *stage, const struct camera *camera, const struct raster *raster, int body)
{
	double radius;
	const vec3 at = camera_project(camera, raster, stage_middle(stage, body, &radius));

	radius *= camera->scale * raster->width;
	return at.x + radius >= 0 && at.x - radius <= raster->width && at.y + radius >= 0 &&
	       at.y - radius <= raster->height;
}

struct screen screen_of(const struct camera *camera, const struct raster *raster, const xform *pose)
{
	const double scale = camera->scale * raster->width;

	return (struct screen){
		vec3_scale(scale, mat3_apply_transposed(&pose->rotation, camera->right)),
		vec3_scale(-scale, mat3_apply_transposed(&pose->rotation, camera->up)),
		mat3_apply_transposed(&pose->rotation, camera->toward),
		camera_project(camera, raster, pose->translation),
	};
}

static void draw_body(const struct stage *stage, const struct camera *camera, struct raster *raster, int body)
{
	const struct scene_body *it = &stage->scene->bodies[body];
	const xform link = machine_pose(stage->scene->machine, it->body->link, &stage->axes);
	const xform pose = xform_mul(&link, &it->body->placement);
	const struct screen screen = screen_of(camera, raster, &pose);
	const enum paint_class class = stage_class(stage, body);
	const struct mesh *mesh = stage_mesh(stage, body);
	const struct lights lights = lights_of(camera);

	for (size_t i = 0; i < mesh->count; i++) {
		vec3 p[3], at[3];

		for (int k = 0; k < 3; k++)
			at[k] = screen_place(&screen, mesh_corner(&mesh->triangles[i], k));
		if (!raster_may_show(raster, at))
			continue;
		for (int k = 0; k < 3; k++)
			p[k] = xform_apply(&pose, mesh_corner(&mesh->triangles[i], k));
		raster_triangle(raster, at, paint_of(camera, &lights, class, p));
	}
}

/* A triangle of the contact, slightly nearer than the body's own triangle at the same place. */
static void draw_contact(const struct camera *camera, struct raster *raster, const vec3 p[3], enum paint_class class)
{
	const struct lights lights = lights_of(camera);
	vec3 at[3];

	for (int k = 0; k < 3; k++) {
		at[k] = camera_project(camera, raster, p[k]);
		at[k].z += 0.05;
	}
	raster_triangle(raster, at, paint_of(camera, &lights, class, p));
}

void stage_draw(const struct stage *stage, const struct camera *camera, struct raster *raster)
{
	for (int i = 0; (size_t)i < stage->scene->body_count; i++) {
		if (stage_shows(stage, i) && is_in_sight(stage, camera, raster, i))
			draw_body(stage, camera, raster, i);
	}
	for (int side = 0; stage->triangles && side < 2; side++)
		draw_contact(camera, raster, stage->triangles[side], side ? PAINT_CONTACT_B : PAINT_CONTACT_A);
}
