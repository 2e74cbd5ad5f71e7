#include "report/picture/stage.h"

#include <math.h>
#include <stdlib.h>

#include "base/math/math_functions.h"
#include "base/mem.h"
#include "base/same_double.h"
#include "machine/chain.h"

/* ------------------------------------------------------------------ paints */

/* Bright enough that black text and the bodies that matter stand out. */
static const uint32_t darkest[PAINT_CLASSES] = {
	[PAINT_NONE] = 0xf7f9fb, [PAINT_BASE] = 0xaab6c3, [PAINT_MOVING] = 0xa4b8cc, [PAINT_FIXTURE] = 0xb0b8bf,
	[PAINT_PART] = 0xcdb896, [PAINT_TOOL] = 0xb4b4b4, [PAINT_A] = 0x8e0d14, [PAINT_B] = 0xa85a00,
	[PAINT_CONTACT_A] = 0x4d0004, [PAINT_CONTACT_B] = 0x5a2d00, [PAINT_NEAR_A] = 0x1d4f86, [PAINT_NEAR_B] = 0x1a6b4a,
};
static const uint32_t brightest[PAINT_CLASSES] = {
	[PAINT_NONE] = 0xf7f9fb, [PAINT_BASE] = 0xe6ebf0, [PAINT_MOVING] = 0xe0e8f0, [PAINT_FIXTURE] = 0xe8ebee,
	[PAINT_PART] = 0xf4e8d2, [PAINT_TOOL] = 0xececec, [PAINT_A] = 0xff5a58, [PAINT_B] = 0xffb347,
	[PAINT_CONTACT_A] = 0x7d0a10, [PAINT_CONTACT_B] = 0x8f4c00, [PAINT_NEAR_A] = 0x7fb2ea, [PAINT_NEAR_B] = 0x77cfa4,
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

bool stage_is_carried(const struct machine *machine, int link, int by)
{
	while (link > by)
		link = machine->axes[link - 1].parent;
	return link == by;
}

static bool is_moved(const struct stage *stage, int body)
{
	return stage->moved && stage_is_carried(stage->scene->machine, stage->scene->bodies[body].body->link,
						stage->moved);
}

static enum paint_class class_of(const struct stage *stage, int body)
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

/* The light comes from above the eye, a little from the left; unit vector. */
static vec3 light_of(const struct camera *camera)
{
	const vec3 light =
	    vec3_add(vec3_add(camera->toward, vec3_scale(0.55, camera->up)), vec3_scale(-0.35, camera->right));

	return vec3_scale(1 / vec3_norm(light), light);
}

/* Where little matters, few steps of brightness are enough. */
static int level_of(enum paint_class class, double bright)
{
	const int steps = class < PAINT_A ? 3 : PAINT_LEVELS - 1;

	return (int)lround(fmin(fmax(bright, 0), 1) * steps) * (PAINT_LEVELS - 1) / steps;
}

/* Surfaces seen from inside look like those seen from outside. */
static uint8_t paint_of(const struct camera *camera, vec3 light, enum paint_class class, const vec3 p[3])
{
	const vec3 n = vec3_cross(vec3_sub(p[1], p[0]), vec3_sub(p[2], p[0]));
	const double length = vec3_norm(n), towards = vec3_dot(n, camera->toward) < 0 ? -1 : 1;
	const double bright = length > 0 ? towards * vec3_dot(n, light) / length : 0;

	return (uint8_t)((int)class * PAINT_LEVELS + level_of(class, 0.25 + 0.75 * bright));
}

static bool is_there(const struct stage *stage, int body)
{
	const struct scene_body *it = &stage->scene->bodies[body];

	if (stage->alone && !is_moved(stage, body))
		return false;
	return it->bvh && (it->body->tool == 0 || it->body->tool == stage->tool);
}

static const struct mesh *mesh_of(const struct stage *stage, int body)
{
	const struct scene_body *it = &stage->scene->bodies[body];

	return stage->stock && it->body->role == ROLE_STOCK ? stage->stock : &it->bvh->mesh;
}

/* The middle of a body as it stands, and the radius of a ball around it. */
static vec3 middle_of(const struct stage *stage, int body, double *radius)
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
	const vec3 at = camera_project(camera, raster, middle_of(stage, body, &radius));

	radius *= camera->scale * raster->width;
	return at.x + radius >= 0 && at.x - radius <= raster->width && at.y + radius >= 0 &&
	       at.y - radius <= raster->height;
}

/* From the coordinates of a mesh to the raster at once: rows of a matrix, and what is added. */
struct screen {
	vec3 x, y, z, shift;
};

static struct screen screen_of(const struct camera *camera, const struct raster *raster, const xform *pose)
{
	const double scale = camera->scale * raster->width;

	return (struct screen){
		vec3_scale(scale, mat3_apply_transposed(&pose->rotation, camera->right)),
		vec3_scale(-scale, mat3_apply_transposed(&pose->rotation, camera->up)),
		mat3_apply_transposed(&pose->rotation, camera->toward),
		camera_project(camera, raster, pose->translation),
	};
}

static vec3 screen_place(const struct screen *screen, vec3 p)
{
	return vec3_add(screen->shift, (vec3){vec3_dot(screen->x, p), vec3_dot(screen->y, p), vec3_dot(screen->z, p)});
}

static void draw_body(const struct stage *stage, const struct camera *camera, struct raster *raster, int body)
{
	const struct scene_body *it = &stage->scene->bodies[body];
	const xform link = machine_pose(stage->scene->machine, it->body->link, &stage->axes);
	const xform pose = xform_mul(&link, &it->body->placement);
	const struct screen screen = screen_of(camera, raster, &pose);
	const enum paint_class class = class_of(stage, body);
	const struct mesh *mesh = mesh_of(stage, body);
	const vec3 light = light_of(camera);

	for (size_t i = 0; i < mesh->count; i++) {
		vec3 p[3], at[3];

		for (int k = 0; k < 3; k++)
			at[k] = screen_place(&screen, mesh_corner(&mesh->triangles[i], k));
		if (!raster_may_show(raster, at))
			continue;
		for (int k = 0; k < 3; k++)
			p[k] = xform_apply(&pose, mesh_corner(&mesh->triangles[i], k));
		raster_triangle(raster, at, paint_of(camera, light, class, p));
	}
}

/* A triangle of the contact, a little nearer than the body's own at the same place. */
static void draw_contact(const struct camera *camera, struct raster *raster, const vec3 p[3], enum paint_class class)
{
	vec3 at[3];

	for (int k = 0; k < 3; k++) {
		at[k] = camera_project(camera, raster, p[k]);
		at[k].z += 0.05;
	}
	raster_triangle(raster, at, paint_of(camera, light_of(camera), class, p));
}

void stage_draw(const struct stage *stage, const struct camera *camera, struct raster *raster)
{
	for (int i = 0; (size_t)i < stage->scene->body_count; i++) {
		if (is_there(stage, i) && is_in_sight(stage, camera, raster, i))
			draw_body(stage, camera, raster, i);
	}
	for (int side = 0; stage->triangles && side < 2; side++)
		draw_contact(camera, raster, stage->triangles[side], side ? PAINT_CONTACT_B : PAINT_CONTACT_A);
}

/* ----------------------------------------------------------------- camera */

static struct camera look_from(double turn, double rise)
{
	const vec3 toward = {math_cos(rise) * math_cos(turn), math_cos(rise) * math_sin(turn), math_sin(rise)};
	const vec3 right = {-math_sin(turn), math_cos(turn), 0};

	return (struct camera){.right = right, .up = vec3_cross(toward, right), .toward = toward};
}

/* All that is there. */
static void frame_all(const struct stage *stage, struct camera *camera)
{
	vec3 least = {INFINITY, INFINITY, INFINITY}, greatest = {-INFINITY, -INFINITY, -INFINITY};

	for (int i = 0; (size_t)i < stage->scene->body_count; i++) {
		double r;
		vec3 p;

		if (!is_there(stage, i))
			continue;
		p = middle_of(stage, i, &r);
		least = (vec3){fmin(least.x, p.x - r), fmin(least.y, p.y - r), fmin(least.z, p.z - r)};
		greatest = (vec3){fmax(greatest.x, p.x + r), fmax(greatest.y, p.y + r), fmax(greatest.z, p.z + r)};
	}
	camera->centre = vec3_lerp(least, greatest, 0.5);
	camera->scale = 1 / fmax(1, 0.9 * vec3_norm(vec3_sub(greatest, least)));
}

/* About the contact: the smaller body should be seen whole, the larger one as far as it helps. */
static void frame_contact(const struct stage *stage, struct camera *camera)
{
	double a, b;

	middle_of(stage, stage->a, &a);
	middle_of(stage, stage->b, &b);
	camera->centre = stage->point;
	camera->scale = 1 / fmin(fmax(7 * fmin(a, b), 60), 2500);
}

static bool is_of_a(uint8_t paint)
{
	const int class = paint / PAINT_LEVELS;

	return class == PAINT_A || class == PAINT_CONTACT_A || class == PAINT_NEAR_A;
}

static bool is_of_b(uint8_t paint)
{
	const int class = paint / PAINT_LEVELS;

	return class == PAINT_B || class == PAINT_CONTACT_B || class == PAINT_NEAR_B;
}

/* How well a small picture shows the contact: both bodies beside it, and nothing in front of it. */
static double score(const struct raster *raster)
{
	const int middle_x = raster->width / 2, middle_y = raster->height / 2, reach = raster->height / 5;
	double a = 0, b = 0, near_a = 0, near_b = 0;

	for (int y = 0; y < raster->height; y++) {
		for (int x = 0; x < raster->width; x++) {
			const uint8_t paint = raster->paints[y * raster->width + x];
			const bool near = abs(x - middle_x) <= reach && abs(y - middle_y) <= reach;
			const bool is_a = is_of_a(paint), is_b = is_of_b(paint);

			a += is_a;
			b += is_b;
			near_a += near && is_a;
			near_b += near && is_b;
		}
	}
	return 4 * fmin(near_a, near_b) + fmin(a, b) + 0.3 * (near_a + near_b);
}

/* Is the contact in front of whatever else is drawn at its place, give or take a little? */
static bool sees_point(const struct stage *stage, const struct camera *camera, const struct raster *raster)
{
	const vec3 at = camera_project(camera, raster, stage->point);
	const int x = (int)at.x, y = (int)at.y;

	return x >= 0 && y >= 0 && x < raster->width && y < raster->height &&
	       raster->depths[y * raster->width + x] <= at.z + 1.5 / (camera->scale * raster->width);
}

/* The size of a picture that is judged, and never shown. */
enum { DRAFT_WIDTH = 64, DRAFT_HEIGHT = 42 };

/* A triangle in machine coordinates. */
struct draft_triangle {
	vec3 p[3];
	uint8_t paint;
};

/*
 * What is there, as coarse as a draft can show it: corners stand on a grid of a draft's pixels, and triangles that
 * shrink to a line or a point, as most of a fine mesh do, are left out. Neighbours share their corners, so that no gaps
 * open.
 */
struct draft {
	struct draft_triangle *triangles;	/* owned */
	size_t count, capacity;
};

static vec3 snap(vec3 p, double grid)
{
	return (vec3){grid * rint(p.x / grid), grid * rint(p.y / grid), grid * rint(p.z / grid)};
}

static bool same_place(vec3 p, vec3 q)
{
	return same_double(p.x, q.x) && same_double(p.y, q.y) && same_double(p.z, q.z);
}

static void add_to_draft(struct draft *draft, const vec3 p[3], double grid, enum paint_class class)
{
	const struct draft_triangle triangle = {{snap(p[0], grid), snap(p[1], grid), snap(p[2], grid)},
						(uint8_t)(class * PAINT_LEVELS)};
	const vec3 *q = triangle.p;

	if (same_place(q[0], q[1]) || same_place(q[1], q[2]) || same_place(q[2], q[0]))
		return;
	draft->triangles = mem_grow(draft->triangles, &draft->capacity, draft->count + 1, sizeof(*draft->triangles));
	draft->triangles[draft->count++] = triangle;
}

static struct draft draft_of(const struct stage *stage, double grid)
{
	struct draft draft = {0};

	for (int i = 0; (size_t)i < stage->scene->body_count; i++) {
		const struct scene_body *it = &stage->scene->bodies[i];
		const xform link = machine_pose(stage->scene->machine, it->body->link, &stage->axes);
		const xform pose = xform_mul(&link, &it->body->placement);

		for (size_t t = 0; is_there(stage, i) && t < mesh_of(stage, i)->count; t++) {
			vec3 p[3];

			for (int k = 0; k < 3; k++)
				p[k] = xform_apply(&pose, mesh_corner(&mesh_of(stage, i)->triangles[t], k));
			add_to_draft(&draft, p, grid, class_of(stage, i));
		}
	}
	for (int side = 0; stage->triangles && side < 2; side++)
		add_to_draft(&draft, stage->triangles[side], grid, side ? PAINT_CONTACT_B : PAINT_CONTACT_A);
	return draft;
}

static double judge(const struct stage *stage, const struct draft *draft, const struct camera *camera)
{
	struct raster raster;
	const xform here = xform_identity();
	struct screen screen;
	double result;

	raster_init(&raster, DRAFT_WIDTH, DRAFT_HEIGHT);
	screen = screen_of(camera, &raster, &here);
	for (size_t i = 0; i < draft->count; i++) {
		vec3 at[3];

		for (int k = 0; k < 3; k++)
			at[k] = screen_place(&screen, draft->triangles[i].p[k]);
		if (raster_may_show(&raster, at))
			raster_triangle(&raster, at, draft->triangles[i].paint);
	}
	result = score(&raster) * (sees_point(stage, camera, &raster) ? 2 : 1);
	raster_release(&raster);
	return result;
}

#define DEGREE (3.14159265358979323846 / 180)

struct camera camera_usual(void)
{
	return look_from(-60 * DEGREE, 30 * DEGREE);
}

struct camera stage_camera(const struct stage *stage)
{
	struct camera best = camera_usual();
	struct draft draft;
	double most = -1;

	if (stage->a < 0 || stage->b < 0 || !stage->has_point) {
		frame_all(stage, &best);
		return best;
	}
	frame_contact(stage, &best);
	draft = draft_of(stage, 1 / (best.scale * DRAFT_WIDTH));
	for (int rise = 15; rise <= 55; rise += 20) {
		for (int turn = -60; turn < 300; turn += 30) {
			struct camera camera = look_from(turn * DEGREE, rise * DEGREE);
			double good;

			frame_contact(stage, &camera);
			/* A view from above the horizon, not from the top, is what people expect. */
			good = judge(stage, &draft, &camera) * (rise == 35 ? 1.1 : 1);
			if (good > most) {
				most = good;
				best = camera;
			}
		}
	}
	free(draft.triangles);
	return best;
}
