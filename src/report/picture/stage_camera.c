#include "report/picture/stage_camera.h"

#include <math.h>
#include <stdlib.h>

#include "base/math/math_functions.h"
#include "base/mem.h"
#include "base/minmax.h"
#include "base/same_double.h"

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

		if (!stage_shows(stage, i))
			continue;
		p = stage_middle(stage, i, &r);
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

	stage_middle(stage, stage->a, &a);
	stage_middle(stage, stage->b, &b);
	camera->centre = stage->point;
	camera->scale = 1 / fmin(fmax(10 * fmin(a, b), 100), 2500);
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
	double radius;	/* mm: of a ball around the first corner that holds all of it */
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
	struct draft_triangle triangle = {.p = {snap(p[0], grid), snap(p[1], grid), snap(p[2], grid)},
					  .paint = (uint8_t)(class * PAINT_LEVELS)};
	const vec3 *q = triangle.p;

	if (same_place(q[0], q[1]) || same_place(q[1], q[2]) || same_place(q[2], q[0]))
		return;
	triangle.radius = larger(vec3_norm(vec3_sub(q[1], q[0])), vec3_norm(vec3_sub(q[2], q[0])));
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

		for (size_t t = 0; stage_shows(stage, i) && t < stage_mesh(stage, i)->count; t++) {
			vec3 p[3];

			for (int k = 0; k < 3; k++)
				p[k] = xform_apply(&pose, mesh_corner(&stage_mesh(stage, i)->triangles[t], k));
			add_to_draft(&draft, p, grid, stage_class(stage, i));
		}
	}
	for (int side = 0; stage->triangles && side < 2; side++)
		add_to_draft(&draft, stage->triangles[side], grid, side ? PAINT_CONTACT_B : PAINT_CONTACT_A);
	return draft;
}

/* May the triangle be in the picture? Most are beside it. */
static bool is_framed(const struct camera *camera, const struct draft_triangle *triangle)
{
	const vec3 way = vec3_sub(triangle->p[0], camera->centre);
	const double half = 0.51 / camera->scale;

	return fabs(vec3_dot(camera->right, way)) <= half + triangle->radius &&
	       fabs(vec3_dot(camera->up, way)) <= half * DRAFT_HEIGHT / DRAFT_WIDTH + triangle->radius;
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

		if (!is_framed(camera, &draft->triangles[i]))
			continue;
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

/*
 * People expect a view from the front, and from above the horizon, but not from the top. There a block shows its top
 * and two sides.
 */
static double familiar(int turn, int rise)
{
	return (rise == 35 ? 1.2 : 1) * (turn <= 0 ? 1.1 : 1) * (turn % 90 ? 1.15 : 1);
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
		for (int turn = -150; turn < 210; turn += 30) {
			struct camera camera = look_from(turn * DEGREE, rise * DEGREE);
			double good;

			frame_contact(stage, &camera);
			good = judge(stage, &draft, &camera) * familiar(turn, rise);
			if (good > most) {
				most = good;
				best = camera;
			}
		}
	}
	free(draft.triangles);
	return best;
}
