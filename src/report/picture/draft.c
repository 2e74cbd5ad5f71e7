#include "report/picture/draft.h"

#include <math.h>
#include <stdlib.h>

#include "base/math/math_functions.h"
#include "base/mem.h"
#include "base/minmax.h"
#include "base/same_double.h"
#include "base/units.h"
#include "machine/motion_bound.h"

enum { WIDTH = 64, HEIGHT = 42, CLUSTER = 16 };

const int draft_rises[DRAFT_RISES] = {35, 15, 55};

/* A triangle in machine coordinates. */
struct draft_triangle {
	vec3 p[3];
	uint8_t paint;
};

/* --------------------------------------------------------------- triangles */

static vec3 snap(vec3 p, double grid)
{
	return (vec3){grid * rint(p.x / grid), grid * rint(p.y / grid), grid * rint(p.z / grid)};
}

static void add_triangle(struct draft *draft, const vec3 p[3], uint8_t paint)
{
	const double grid = draft->grid;
	struct draft_triangle triangle = {.p = {snap(p[0], grid), snap(p[1], grid), snap(p[2], grid)}, .paint = paint};
	const vec3 *q = triangle.p;

	if (same_vec3(q[0], q[1]) || same_vec3(q[1], q[2]) || same_vec3(q[2], q[0]))
		return;
	draft->triangles = mem_grow(draft->triangles, &draft->capacity, draft->count + 1, sizeof(*draft->triangles));
	draft->triangles[draft->count++] = triangle;
}

/* A ball around the points, of which there is at least one. */
static struct ball ball_around(const vec3 *points, size_t count)
{
	vec3 least = {INFINITY, INFINITY, INFINITY}, greatest = {-INFINITY, -INFINITY, -INFINITY};

	for (size_t i = 0; i < count; i++) {
		const vec3 p = points[i];

		least = (vec3){smaller(least.x, p.x), smaller(least.y, p.y), smaller(least.z, p.z)};
		greatest = (vec3){larger(greatest.x, p.x), larger(greatest.y, p.y), larger(greatest.z, p.z)};
	}
	return (struct ball){vec3_lerp(least, greatest, 0.5), vec3_norm(vec3_sub(greatest, least)) / 2};
}

/* -------------------------------------------------------------- visibility */

/*
 * The region that any of the cameras can see: around a ray from the stage's point at one of the heights, in any
 * horizontal direction.
 */
struct sight {
	vec3 point;
	double radius;	/* mm, of a picture's corner from its middle */
	double cosine[DRAFT_RISES], sine[DRAFT_RISES];	/* of the heights */
};

static struct sight sight_of(const struct stage *stage, double scale)
{
	struct sight sight = {.point = stage->point, .radius = 0.51 / scale * math_hypot(1, (double)HEIGHT / WIDTH)};

	for (int i = 0; i < DRAFT_RISES; i++) {
		sight.cosine[i] = math_cos(radians(draft_rises[i]));
		sight.sine[i] = math_sin(radians(draft_rises[i]));
	}
	return sight;
}

/* Can the content of the ball be in a picture? `behind`: also behind the point, where it can hide nothing. */
static bool is_in_sight(const struct sight *sight, const struct ball *ball, bool behind)
{
	const vec3 way = vec3_sub(ball->centre, sight->point);
	const double beside = sqrt(way.x * way.x + way.y * way.y), reach = sight->radius + ball->radius;

	for (int i = 0; i < DRAFT_RISES; i++) {
		const double c = sight->cosine[i], s = sight->sine[i];

		if (fabs(way.z * c - beside * s) <= reach && beside * c + way.z * s >= -reach)
			return true;
		/* The camera is on the other side. */
		if (behind && fabs(way.z * c + beside * s) <= reach)
			return true;
	}
	return false;
}

/* Adds the triangles of a body that may be visible. */
static void add_body(struct draft *draft, const struct stage *stage, const struct sight *sight, int body)
{
	const struct scene_body *it = &stage->scene->bodies[body];
	const struct mesh *mesh = stage_mesh(stage, body);
	const xform link = machine_pose(stage->scene->machine, it->body->link, &stage->axes);
	const xform pose = xform_mul(&link, &it->body->placement);
	const uint8_t paint = (uint8_t)(stage_class(stage, body) * PAINT_LEVELS);
	const bool behind = body == stage->a || body == stage->b;

	for (size_t from = 0; from < mesh->count; from += CLUSTER) {
		const size_t count = mesh->count - from < CLUSTER ? mesh->count - from : CLUSTER;
		vec3 corners[3 * CLUSTER];
		struct ball ball;

		for (size_t i = 0; i < 3 * count; i++)
			corners[i] = xform_apply(&pose, mesh_corner(&mesh->triangles[from + i / 3], (int)(i % 3)));
		ball = ball_around(corners, 3 * count);
		for (size_t i = 0; i < count && is_in_sight(sight, &ball, behind); i++)
			add_triangle(draft, corners + 3 * i, paint);
	}
}

static void add_balls(struct draft *draft)
{
	draft->balls = mem_alloc((draft->count / CLUSTER + 1) * sizeof(*draft->balls));
	for (size_t from = 0; from < draft->count; from += CLUSTER) {
		vec3 corners[3 * CLUSTER];
		size_t count = 0;

		for (size_t i = from; i < draft->count && i < from + CLUSTER; i++) {
			for (int k = 0; k < 3; k++)
				corners[count++] = draft->triangles[i].p[k];
		}
		draft->balls[from / CLUSTER] = ball_around(corners, count);
	}
}

/* -------------------------------------------------------------------- face */

void draft_init(struct draft *draft, const struct stage *stage, double scale)
{
	const struct sight sight = sight_of(stage, scale);

	*draft = (struct draft){.width = WIDTH, .height = HEIGHT, .grid = 1 / (scale * WIDTH)};
	for (int i = 0; (size_t)i < stage->scene->body_count; i++) {
		if (stage_shows(stage, i))
			add_body(draft, stage, &sight, i);
	}
	for (int side = 0; stage->triangles && side < 2; side++)
		add_triangle(draft, stage->triangles[side],
			     (side ? PAINT_CONTACT_B : PAINT_CONTACT_A) * PAINT_LEVELS);
	add_balls(draft);
}

void draft_init_coarser(struct draft *draft, const struct draft *fine, int times)
{
	*draft = (struct draft){
	    .width = fine->width / times, .height = fine->height / times, .grid = times * fine->grid,
	};
	for (size_t i = 0; i < fine->count; i++)
		add_triangle(draft, fine->triangles[i].p, fine->triangles[i].paint);
	add_balls(draft);
}

void draft_release(struct draft *draft)
{
	free(draft->triangles);
	free(draft->balls);
	*draft = (struct draft){0};
}

/* Can the content of the ball be in the picture? Most is beside it. */
static bool is_framed(const struct camera *camera, const struct draft *draft, const struct ball *ball)
{
	const vec3 way = vec3_sub(ball->centre, camera->centre);
	const double half = 0.51 / camera->scale;

	return fabs(vec3_dot(camera->right, way)) <= half + ball->radius &&
	       fabs(vec3_dot(camera->up, way)) <= half * draft->height / draft->width + ball->radius;
}

void draft_draw(const struct draft *draft, const struct camera *camera, struct raster *raster)
{
	const xform here = xform_identity();
	const struct screen screen = screen_of(camera, raster, &here);

	for (size_t i = 0; i < draft->count; i++) {
		vec3 at[3];

		if (i % CLUSTER == 0 && !is_framed(camera, draft, &draft->balls[i / CLUSTER])) {
			i += CLUSTER - 1;
			continue;
		}
		for (int k = 0; k < 3; k++)
			at[k] = screen_place(&screen, draft->triangles[i].p[k]);
		if (raster_may_show(raster, at))
			raster_triangle(raster, at, draft->triangles[i].paint);
	}
}
