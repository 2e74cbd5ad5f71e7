#include "scene/placement_check.h"

#include <math.h>
#include <string.h>

#include "base/math/math_functions.h"
#include "base/units.h"

/* mm: two placements are the same if they move no point farther apart than this. */
static const double ONE_PLACE = 1e-3;
/* Degrees: angles in radians are written with at least three digits. */
static const double ANGLE_OFF = 0.002;

static bool is_judged(const struct scene *scene, size_t body)
{
	const struct scene_body *b = &scene->bodies[body];

	return b->bvh && !b->body->checked &&
	       (b->body->role == ROLE_MACHINE || b->body->role == ROLE_FIXTURE || b->body->role == ROLE_PART);
}

static bool are_one_mesh(const struct mesh *a, const struct mesh *b)
{
	return a->count == b->count && !memcmp(a->triangles, b->triangles, a->count * sizeof(*a->triangles));
}

/*
 * Do both placements put the corners of the box around the mesh in the same places? Then this is so for the whole box.
 */
static bool are_in_one_place(const struct scene_body *a, const struct scene_body *b)
{
	for (int corner = 0; corner < 8; corner++) {
		const vec3 half = a->bvh->half;
		const vec3 off = {corner & 1 ? half.x : -half.x, corner & 2 ? half.y : -half.y,
				  corner & 4 ? half.z : -half.z};
		const vec3 p = vec3_add(a->bvh->origin, off);

		if (vec3_norm(vec3_sub(xform_apply(&a->body->placement, p), xform_apply(&b->body->placement, p))) >
		    ONE_PLACE)
			return false;
	}
	return true;
}

static void check_twice(const struct scene *scene, struct doubts *doubts)
{
	for (size_t i = 0; i < scene->body_count; i++) {
		for (size_t k = i + 1; k < scene->body_count && is_judged(scene, i); k++) {
			const struct scene_body *a = &scene->bodies[i], *b = &scene->bodies[k];

			if (is_judged(scene, k) && are_one_mesh(&a->bvh->mesh, &b->bvh->mesh) && are_in_one_place(a, b))
				doubts_add(doubts, &(struct doubt){.kind = DOUBT_TWICE, .body = (int)i,
								   .against = (int)k});
		}
	}
}

/* The angle of a rotation, in degrees. */
static double angle_of(const mat3 *r)
{
	const vec3 twice_sine = {r->y.z - r->z.y, r->z.x - r->x.z, r->x.y - r->y.x};

	return degrees(math_atan2(vec3_norm(twice_sine), r->x.x + r->y.y + r->z.z - 1));
}

/*
 * The rotation of a body relative to its workholding: fixtures and parts rotate with it, and then by their own angle.
 */
static double own_angle(const struct scene *scene, const struct body *body)
{
	const xform none = xform_identity(), back = xform_inverse(&scene->machine->workholding.frame);
	const xform own = xform_mul(body->role == ROLE_MACHINE ? &none : &back, &body->placement);

	return angle_of(&own.rotation);
}

/* 45, 90, 135 and 180 degrees are 0.785 to 3.142 radians, and a whole turn is 6.283. */
static bool looks_like_radians(double angle)
{
	const double eighths = angle / (PI / 4), nearest = floor(eighths + 0.5);

	return nearest >= 1 && nearest <= 8 && fabs(eighths - nearest) * (PI / 4) < ANGLE_OFF;
}

static void check_rotations(const struct scene *scene, struct doubts *doubts)
{
	const struct workholding *workholding = &scene->machine->workholding;
	const double turned = angle_of(&workholding->frame.rotation);

	for (size_t i = 0; i < scene->body_count; i++) {
		const double angle = own_angle(scene, scene->bodies[i].body);

		if (is_judged(scene, i) && looks_like_radians(angle))
			doubts_add(doubts, &(struct doubt){.kind = DOUBT_ROTATION, .body = (int)i, .value = angle});
	}
	if (workholding->present && !workholding->checked && looks_like_radians(turned))
		doubts_add(doubts, &(struct doubt){.kind = DOUBT_WORKHOLDING_ROTATION, .value = turned});
}

void placement_check(const struct scene *scene, struct doubts *doubts)
{
	check_twice(scene, doubts);
	check_rotations(scene, doubts);
}
