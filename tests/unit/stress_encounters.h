/* stress_encounters.h - encounters of two bodies whose first contact is known. */
#ifndef FIVECHECK_TESTS_STRESS_ENCOUNTERS_H
#define FIVECHECK_TESTS_STRESS_ENCOUNTERS_H

#include "stress_case.h"

#define GAP 0x1p-28	/* 4e-9 mm */

static const struct joint along_x = {SLOT_X, false, {1, 0, 0}, {0, 0, 0}};
static const struct joint along_z = {SLOT_Z, false, {0, 0, 1}, {0, 0, 0}};
static const struct joint about_z = {SLOT_C, true, {0, 0, 1}, {0, 0, 0}};
static const struct joint about_x = {SLOT_A, true, {1, 0, 0}, {0, 0, 0}};

static inline void add_joint(struct stress_case *c, const struct joint *joint, double from, double to)
{
	c->chain.joints[c->chain.count++] = *joint;
	c->chord.q0.v[joint->slot] = from;
	c->chord.q1.v[joint->slot] = to;
}

static inline void add_box(struct mesh *mesh, vec3 half, vec3 centre)
{
	struct mesh box = {0};
	xform place = xform_identity();

	place.translation = centre;
	solid_box(&box, half);
	solid_place(&box, &place);
	for (size_t i = 0; i < box.count; i++)
		solid_add(mesh, mesh_corner(&box.triangles[i], 0), mesh_corner(&box.triangles[i], 1),
			  mesh_corner(&box.triangles[i], 2));
	mesh_release(&box);
}

/* Two triangles, b sliding along X from `from` to `to`. */
static struct stress_case sliding(tri a, tri b, double from, double to, double tolerance)
{
	struct stress_case c = stress_case(tolerance);

	solid_add(&c.a, a.p[0], a.p[1], a.p[2]);
	solid_add(&c.b, b.p[0], b.p[1], b.p[2]);
	add_joint(&c, &along_x, from, to);
	c.slack = 1.01 * tolerance / fabs(to - from) + 1e-12;
	return c;
}

static struct stress_case coplanar_overlap(void)
{
	struct stress_case c = sliding((tri){{{0, -4, 0}, {0, 4, 0}, {8, 0, 0}}},
				       (tri){{{0, -1, 0}, {0, 1, 0}, {-4, 0, 0}}}, -16, 16, 1e-3);

	c.first = 0.5;
	return c;
}

static struct stress_case coplanar_gap(void)
{
	return sliding((tri){{{-8, 0, 0}, {8, 0, 0}, {0, 8, 0}}}, (tri){{{-1, -GAP, 0}, {1, -GAP, 0}, {0, -4, 0}}}, -16,
		       16, GAP / 4);
}

static struct stress_case shared_edge_departing(void)
{
	struct stress_case c =
	    sliding((tri){{{0, -4, 0}, {0, 4, 0}, {-8, 0, 0}}}, (tri){{{0, -4, 0}, {0, 4, 0}, {8, 0, 3}}}, 0, 16, 1e-3);

	c.first = 0;
	return c;
}

static struct stress_case shared_corner_departing(void)
{
	struct stress_case c =
	    sliding((tri){{{0, 0, 0}, {-4, 4, 1}, {-8, 0, 0}}}, (tri){{{0, 0, 0}, {5, 4, 0}, {8, 0, 3}}}, 0, 16, 1e-3);

	c.first = 0;
	return c;
}

static struct stress_case corner_reaches_face_at_the_end(void)
{
	struct stress_case c =
	    sliding((tri){{{0, -4, -4}, {0, 4, -4}, {0, 0, 4}}}, (tri){{{0, 0, 0}, {5, 4, 0}, {8, 0, 3}}}, 16, 0, 1e-3);

	c.first = 1;
	return c;
}

/* An edge along Y meets one along Z. */
static struct stress_case edges_meet(void)
{
	struct stress_case c =
	    sliding((tri){{{0, -4, 0}, {0, 4, 0}, {-8, 0, 0}}}, (tri){{{0, 0, -4}, {0, 0, 4}, {8, 0, 0}}}, 8, -8, 1e-6);

	c.first = 0.5;
	return c;
}

static struct stress_case edges_miss(void)
{
	return sliding((tri){{{-8, 0, 0}, {8, 0, 0}, {0, 0, -4}}}, (tri){{{0, -4, GAP}, {0, 4, GAP}, {0, 0, 4}}}, -16,
		       16, GAP / 4);
}

static struct stress_case parallel_edges_miss(void)
{
	return sliding((tri){{{-8, 0, 0}, {8, 0, 0}, {0, 0, -4}}}, (tri){{{-4, 0, GAP}, {4, 0, GAP}, {0, 0, 4}}}, -16,
		       16, GAP / 4);
}

static struct stress_case edges_at_a_hundred_millionth(void)
{
	return sliding((tri){{{-1, 0, 0}, {1, 0, 0}, {0, 0, -1}}}, (tri){{{-1, -1e-8, GAP}, {1, 1e-8, GAP}, {0, 0, 1}}},
		       -2, 2, GAP / 4);
}

static struct stress_case slivers_meet(void)
{
	struct stress_case c = sliding((tri){{{0, -8192, 0}, {0, 8192, 0}, {-0x1p-14, 0, 0}}},
				       (tri){{{0, 0, -8192}, {0, 0, 8192}, {0x1p-14, 0, 0}}}, 8, -8, 1e-6);

	c.first = 0.5;
	return c;
}

static struct stress_case slivers_pass(void)
{
	return sliding((tri){{{-8192, 0, 0}, {8192, 0, 0}, {0, -0x1p-14, 0}}},
		       (tri){{{-8192, 0.01, 0}, {8192, 0.01, 0}, {0, 0.01 + 0x1p-14, 0}}}, -8, 8, 1e-3);
}

static struct stress_case collinear_corners_meet(void)
{
	struct stress_case c =
	    sliding((tri){{{0, -4, -4}, {0, 4, -4}, {0, 0, 4}}}, (tri){{{0, 0, 0}, {4, 0, 0}, {2, 0, 0}}}, 8, -8, 1e-6);

	c.first = 0.5;
	return c;
}

static struct stress_case point_meets_face(void)
{
	struct stress_case c =
	    sliding((tri){{{0, -4, -4}, {0, 4, -4}, {0, 0, 4}}}, (tri){{{0, 1, 0}, {0, 1, 0}, {0, 1, 0}}}, 8, -8, 1e-6);

	c.first = 0.5;
	return c;
}

static struct stress_case denormals_and_minus_zero(void)
{
	struct stress_case c = sliding((tri){{{-0.0, -4, -4}, {1e-45, 4, -4}, {0, -0.0, 4}}},
				       (tri){{{1e-45, -0.0, 1e-45}, {5, 4, -0.0}, {8, 0, 3}}}, 8, -8, 1e-6);

	c.first = 0.5;
	return c;
}

static struct stress_case identical_at_rest(void)
{
	struct stress_case c = stress_case(1e-3);

	add_box(&c.a, (vec3){1, 2, 3}, (vec3){0, 0, 0});
	add_box(&c.b, (vec3){1, 2, 3}, (vec3){0, 0, 0});
	add_joint(&c, &along_x, 0, 0);
	c.first = 0;
	return c;
}

static struct stress_case thin_wall(void)
{
	struct stress_case c = stress_case(1e-5);

	add_box(&c.a, (vec3){0x1p-12, 50, 50}, (vec3){0, 0, 0});
	add_box(&c.b, (vec3){0x1p-12, 0x1p-12, 0x1p-12}, (vec3){0, 0, 0});
	add_joint(&c, &along_x, -100, 100);
	c.first = (100 - 0x1p-11) / 200;
	c.slack = 1.01e-5 / 200;
	return c;
}

static struct stress_case slide_at_ten_micrometres(void)
{
	struct stress_case c = stress_case(1e-3);

	add_box(&c.a, (vec3){4096, 50, 5}, (vec3){0, 0, -5});
	add_box(&c.b, (vec3){20, 10, 5}, (vec3){0, 0, 5});
	c.place_b.translation.z = 0.01;
	add_joint(&c, &along_x, -4000, 4000);
	return c;
}

/* Along the same plate, but one of its ends is 0.02 mm lower than the other: met on the way. */
static struct stress_case slide_that_sinks(void)
{
	struct stress_case c = slide_at_ten_micrometres();

	add_joint(&c, &along_z, 0, -0.02);
	c.tolerance = 1e-6;
	c.first = 0.5;
	/* Nearly tangential: e on the way down is 8 m * e / 0.02 mm of way. */
	c.slack = 1.01e-6 / 0.02;
	return c;
}

static struct stress_case halt(double gap, double clearance, double first)
{
	struct stress_case c = stress_case(0x1p-10);

	add_box(&c.a, (vec3){4, 4, 4}, (vec3){-4, 0, 0});
	add_box(&c.b, (vec3){4, 4, 4}, (vec3){4, 0, 0});
	add_joint(&c, &along_x, 16, gap);
	c.clearance = clearance;
	c.first = first;
	c.slack = 1.01 * 0x1p-10 / 16;
	return c;
}

static struct stress_case ends_at_the_clearance(void)
{
	return halt(0.5, 0.5, 1);
}

static struct stress_case ends_an_ulp_inside(void)
{
	return halt(0.5 - 0x1p-54, 0.5, 1);
}

static struct stress_case ends_an_ulp_beyond_the_tolerance(void)
{
	return halt(nextafter(0.5 + 0x1p-10, 1), 0.5, NEVER);
}

static struct stress_case ends_twice_the_tolerance_away(void)
{
	return halt(0x1p-9, 0, NEVER);
}

/* A point at 64 mm on a table that turns from `from` to `to` degrees, and a wall that it reaches at `at`. */
static struct stress_case turn(double from, double to, double wall, double tolerance, double at)
{
	struct stress_case c = stress_case(tolerance);

	add_box(&c.a, (vec3){8, 128, 8}, (vec3){8, 0, 0});
	solid_add(&c.b, (vec3){64, 0, -1}, (vec3){64, 0, 1}, (vec3){60, 0, 0});
	c.place_a.translation.x = wall;
	add_joint(&c, &about_z, radians(from), radians(to));
	c.first = at < -1e6 ? NEVER : (at - from) / (to - from);
	/* The wall is met at a slope of sin(at); then what is within e of it comes earlier by that much. */
	c.slack = at < -1e6 ? 0 : 1.1 * tolerance / (64 * fabs(sin(radians(at))) * radians(to - from)) + 1e-12;
	return c;
}

/* The gap at both ends is the bulge of the turn over its chord plus or minus 1e-6: k itself decides. */
static struct stress_case dip_within(void)
{
	return turn(-4, 4, 64 - 1e-6, 1e-8, -degrees(acos((64 - 1e-6) / 64)));
}

static struct stress_case dip_beyond(void)
{
	return turn(-4, 4, 64 + 1e-6, 1e-7, -INFINITY);
}

static struct stress_case half_a_turn(void)
{
	return turn(-90, 90, 64 - 0x1p-4, 1e-4, -degrees(acos((64 - 0x1p-4) / 64)));
}

static struct stress_case a_whole_turn(void)
{
	return turn(-350, 10, 64 - 0x1p-4, 1e-4, -degrees(acos((64 - 0x1p-4) / 64)));
}

static struct stress_case a_whole_turn_past(void)
{
	return turn(-350, 10, 64 + 0x1p-4, 1e-3, -INFINITY);
}

static struct stress_case hundred_thousand_degrees(void)
{
	return turn(10, 100010, 64 - 0x1p-4, 1e-4, 360 - degrees(acos((64 - 0x1p-4) / 64)));
}

static struct stress_case hundred_thousand_degrees_past(void)
{
	return turn(0, 100000, 64 + 0x1p-4, 1e-3, -INFINITY);
}

/* Two rotary axes at once, the tool's point near where they are singular: it stays where it is, however they turn. */
static struct stress_case singular_pose(void)
{
	struct stress_case c = stress_case(1e-3);

	solid_add(&c.b, (vec3){0, 0, 0}, (vec3){0, 0, 64}, (vec3){0, 0, 32});
	add_box(&c.a, (vec3){8, 8, 1}, (vec3){0, 0, 66});
	add_joint(&c, &about_z, radians(-180), radians(180));
	add_joint(&c, &about_x, radians(-1e-4), radians(1e-4));
	return c;
}

typedef struct stress_case stress_case_fn(void);

struct stress_row {
	const char *name;
	stress_case_fn *make;
	bool fine;	/* finer than the rounding of coordinates at 2^20 mm */
};

#define ROW(name, fine) {#name, name, fine}

static const struct stress_row rows[] = {
	ROW(coplanar_overlap, false), ROW(coplanar_gap, true), ROW(shared_edge_departing, false),
	ROW(shared_corner_departing, false), ROW(corner_reaches_face_at_the_end, false), ROW(edges_meet, true),
	ROW(edges_miss, true), ROW(parallel_edges_miss, true), ROW(edges_at_a_hundred_millionth, true),
	ROW(slivers_meet, true), ROW(slivers_pass, false), ROW(collinear_corners_meet, true),
	ROW(point_meets_face, true), ROW(denormals_and_minus_zero, true), ROW(identical_at_rest, false),
	ROW(thin_wall, false), ROW(slide_at_ten_micrometres, false), ROW(slide_that_sinks, true),
	ROW(ends_at_the_clearance, false), ROW(ends_an_ulp_inside, false), ROW(ends_an_ulp_beyond_the_tolerance, true),
	ROW(ends_twice_the_tolerance_away, false), ROW(dip_within, true), ROW(dip_beyond, true),
	ROW(half_a_turn, false), ROW(a_whole_turn, false), ROW(a_whole_turn_past, false),
	ROW(hundred_thousand_degrees, false), ROW(hundred_thousand_degrees_past, false), ROW(singular_pose, false),
};

enum { ROWS = sizeof(rows) / sizeof(rows[0]) };

#endif
