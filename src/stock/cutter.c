#include "stock/cutter.h"

#include <float.h>
#include <math.h>
#include <stdlib.h>

#include "base/mem.h"
#include "base/minmax.h"

/* Steps of the search for the time at which the cube is deepest; each reduces the interval to 0.62 of its length. */
#define SEARCH_STEPS 24

/*
 * The largest number of halvings of the interval in which the cube enters. They end when the cutter moves by at most
 * ENTRY_WAY in the interval.
 */
#define ENTRY_STEPS 15
#define ENTRY_WAY 1e-3	/* mm */

void cutter_init(struct cutter *cutter, const struct tool_solid *solid)
{
	size_t length;

	*cutter = (struct cutter){.piece_count = 0};
	revolved_init(&cutter->whole, solid);
	cutter->pieces = mem_zalloc(cutter->whole.count, sizeof(*cutter->pieces));
	for (size_t i = 0; i < cutter->whole.count; i += length) {
		struct revolved *piece = &cutter->pieces[cutter->piece_count++];

		length = revolved_convex_run(&cutter->whole, i);
		*piece = (struct revolved){.bands = &cutter->whole.bands[i], .count = length};
		for (size_t k = 0; k < length; k++)
			piece->radius = fmax(piece->radius, fmax(piece->bands[k].r_top, piece->bands[k].r_bottom));
	}
}

void cutter_release(struct cutter *cutter)
{
	revolved_release(&cutter->whole);
	free(cutter->pieces);
	*cutter = (struct cutter){.piece_count = 0};
}

static void widen(vec3 *low, vec3 *high, vec3 point, vec3 by)
{
	*low = vec3_min(*low, vec3_sub(point, by));
	*high = vec3_max(*high, vec3_add(point, by));
}

static void bounds_at(const struct cutter *cutter, const struct cutter_place *place, vec3 *low, vec3 *high)
{
	const struct revolved *whole = &cutter->whole;
	const vec3 up = place->up;
	/* The extent of a disc of radius r about the axis along each coordinate. */
	const vec3 reach = {whole->radius * sqrt(larger(1 - up.x * up.x, 0)),
			    whole->radius * sqrt(larger(1 - up.y * up.y, 0)),
			    whole->radius * sqrt(larger(1 - up.z * up.z, 0))};

	widen(low, high, vec3_mad(place->origin, whole->bands[0].top, up), reach);
	widen(low, high, vec3_mad(place->origin, whole->bands[whole->count - 1].bottom, up), reach);
}

void cutter_way_bounds(const struct cutter *cutter, const struct cutter_way *way, vec3 *low, vec3 *high)
{
	*low = (vec3){INFINITY, INFINITY, INFINITY};
	*high = (vec3){-INFINITY, -INFINITY, -INFINITY};
	bounds_at(cutter, &way->from, low, high);
	bounds_at(cutter, &way->to, low, high);
}

struct cutter_place cutter_place_between(const struct cutter_place *from, const struct cutter_place *to, double s)
{
	return (struct cutter_place){vec3_lerp(from->origin, to->origin, s), vec3_unit(vec3_lerp(from->up, to->up, s))};
}

/* The cutter's axis at a time: each point of it is on the line between its positions at the ends. */
static struct cutter_place place_at(const struct cutter_way *way, double s)
{
	return cutter_place_between(&way->from, &way->to, s);
}

static double point_distance(const struct revolved *piece, const struct cutter_place *place, vec3 point)
{
	const vec3 off = vec3_sub(point, place->origin);
	const double z = vec3_dot(off, place->up);

	return revolved_distance(piece, sqrt(larger(vec3_norm2(off) - z * z, 0)), z);
}

/*
 * A lower bound of the depth of the cube's points inside the piece, as a negative distance. A ball about the centre
 * that contains the cube may be tested instead of the corners.
 */
static double cube_distance(const struct revolved *piece, const struct cutter_way *way, const struct cube *cube,
			    double s)
{
	const struct cutter_place place = place_at(way, s);
	double most = -INFINITY;

	for (int corner = 0; corner < 8; corner++) {
		const vec3 sign = {corner & 1 ? 1 : -1, corner & 2 ? 1 : -1, corner & 4 ? 1 : -1};

		most = larger(most, point_distance(piece, &place, vec3_mad(cube->centre, cube->half, sign)));
	}
	return most;
}

/* Is the whole cube at least `depth` mm inside the piece? */
static bool is_cube_inside(const struct revolved *piece, const struct cutter_way *way, const struct cube *cube,
			   double depth, double s)
{
	const struct cutter_place place = place_at(way, s);

	for (int corner = 0; corner < 8; corner++) {
		const vec3 sign = {corner & 1 ? 1 : -1, corner & 2 ? 1 : -1, corner & 4 ? 1 : -1};

		if (point_distance(piece, &place, vec3_mad(cube->centre, cube->half, sign)) > -depth)
			return false;
	}
	return true;
}

/* The golden section: each step of a search reduces the interval to this share. */
static const double golden = 0.6180339887498949;

/*
 * Two times inside an interval, at low + (1 - golden) * length and low + golden * length, and the distances there.
 * Distances change by no more than `change` mm over the whole way.
 */
struct section {
	double low, high, a, b, fa, fb;
	double change;
};

/* Is the distance more than `target` in the whole interval? */
static bool stays_above(const struct section *section, double target)
{
	const double reach = (1 - golden) * (section->high - section->low) * section->change;

	return smaller(section->fa, section->fb) - reach > target;
}

/* Removes the end where the function is larger; returns the new time, and where to store the value at this time. */
static double *narrow(struct section *at, double *time)
{
	if (at->fa <= at->fb) {
		at->high = at->b;
		at->b = at->a;
		at->fb = at->fa;
		*time = at->a = at->high - golden * (at->high - at->low);
		return &at->fa;
	}
	at->low = at->a;
	at->a = at->b;
	at->fa = at->fb;
	*time = at->b = at->low + golden * (at->high - at->low);
	return &at->fb;
}

/* A time at which a convex function has its minimum, approximately; INFINITY: it is above `target` everywhere. */
static double deepest_time(const struct revolved *piece, const struct cutter_way *way, vec3 point, double change,
			   double target)
{
	struct section at = {.high = 1, .a = 1 - golden, .b = golden, .change = change};
	struct cutter_place place = place_at(way, at.a);
	double time, *value;

	at.fa = point_distance(piece, &place, point);
	place = place_at(way, at.b);
	at.fb = point_distance(piece, &place, point);
	for (int i = 0; i < SEARCH_STEPS; i++) {
		if (stays_above(&at, target))
			return INFINITY;
		value = narrow(&at, &time);
		place = place_at(way, time);
		*value = point_distance(piece, &place, point);
	}
	return at.fa <= at.fb ? at.a : at.b;
}

/*
 * The same for the whole cube, whose corners need not be deepest when its centre is. Returns the first time found at
 * which its distance is `target` or less.
 */
static double deep_cube_time(const struct revolved *piece, const struct cutter_way *way, const struct cube *cube,
			     double change, double target)
{
	struct section at = {.high = 1, .a = 1 - golden, .b = golden, .change = change};
	double time, *value;

	at.fa = cube_distance(piece, way, cube, at.a);
	at.fb = cube_distance(piece, way, cube, at.b);
	for (int i = 0; i < SEARCH_STEPS && smaller(at.fa, at.fb) > target; i++) {
		if (stays_above(&at, target))
			return INFINITY;
		value = narrow(&at, &time);
		*value = cube_distance(piece, way, cube, time);
	}
	return at.fa <= at.fb ? at.a : at.b;
}

/* The cube is inside the piece at the time `inside`: returns the first time from which it is, up to then. */
static double entry_time(const struct revolved *piece, const struct cutter_way *way, const struct cube *cube,
			 double depth, double change, double inside)
{
	double outside = 0;

	if (is_cube_inside(piece, way, cube, depth, 0))
		return 0;
	for (int i = 0; i < ENTRY_STEPS && (inside - outside) * change > ENTRY_WAY; i++) {
		const double middle = 0.5 * (outside + inside);

		if (is_cube_inside(piece, way, cube, depth, middle))
			inside = middle;
		else
			outside = middle;
	}
	return inside;
}

/* The time at which the cutter's axis is nearest to a point, as if the cutter did not rotate. */
struct closest {
	double s;	/* the time */
	double distance2;	/* mm^2: of the point from the axis at this time */
};

static struct closest closest_of(const struct cutter_way *way, vec3 point, double latest)
{
	const vec3 from = vec3_sub(point, way->from.origin), to = vec3_sub(point, way->to.origin);
	const vec3 w0 = vec3_mad(from, -vec3_dot(from, way->from.up), way->from.up);
	const vec3 along = vec3_sub(vec3_mad(to, -vec3_dot(to, way->to.up), way->to.up), w0);
	const double length2 = vec3_norm2(along);
	const double s = length2 > 0 ? smaller(larger(-vec3_dot(w0, along) / length2, 0), latest) : 0;

	return (struct closest){s, vec3_norm2(vec3_mad(w0, s, along))};
}

static double nearest_time(const struct cutter_way *way, vec3 point)
{
	return closest_of(way, point, 1).s;
}

/* mm: an upper bound of the change of any point's distance from the cutter over the way. */
static double change_of(const struct cutter *cutter, const struct cutter_way *way)
{
	const struct revolved *whole = &cutter->whole;
	const double length = larger(fabs(whole->bands[0].top), fabs(whole->bands[whole->count - 1].bottom));
	/*
	 * A point moves with the origin and rotates about it: fastest in the middle, where the direction is shortest.
	 */
	const double shortest = larger(0.5 * vec3_norm(vec3_add(way->to.up, way->from.up)), DBL_MIN);
	const double turn = vec3_norm(vec3_sub(way->to.up, way->from.up)) / shortest;

	return vec3_norm(vec3_sub(way->to.origin, way->from.origin)) + turn * (length + whole->radius);
}

/* A piece of the log rotates little; this much does not matter. */
static bool turns(const struct cutter_way *way)
{
	return vec3_dot(way->from.up, way->to.up) < 1 - 1e-12;
}

/* The time at which a point is nearest to the cutter's axis (nearest_time). */
struct near_time {
	double s;
	double gain;	/* mm: the point is at most this much deeper inside a piece at another time */
	double change;	/* mm: change_of */
};

/*
 * In a solid of revolution, a point at a larger radius is never deeper. So if the cutter does not rotate, only its
 * motion along the axis can bring the point deeper than at the smallest radius.
 */
static struct near_time near_time_of(const struct cutter *cutter, const struct cutter_way *way, vec3 point)
{
	const double s = nearest_time(way, point);
	const vec3 moved = vec3_sub(way->to.origin, way->from.origin);
	const double change = change_of(cutter, way);
	const double along = turns(way) ? change : fabs(vec3_dot(moved, way->from.up));

	return (struct near_time){s, larger(s, 1 - s) * along, change};
}

static double piece_removes(const struct revolved *piece, const struct cutter_way *way, const struct cube *cube,
			    double depth, struct near_time near)
{
	/* The ball inside the cube must be inside the piece before the corners can be. */
	const double needed = -(cube->half + depth);
	struct cutter_place place = place_at(way, near.s);
	double s;

	if (cube->half + depth > piece->radius)
		return INFINITY;
	/* This decides most cuts. */
	if (point_distance(piece, &place, cube->centre) - near.gain > needed)
		return INFINITY;
	if (is_cube_inside(piece, way, cube, depth, 1))
		return entry_time(piece, way, cube, depth, near.change, 1);
	if (is_cube_inside(piece, way, cube, depth, near.s))
		return entry_time(piece, way, cube, depth, near.change, near.s);
	s = deepest_time(piece, way, cube->centre, near.change, needed);
	if (isinf(s))
		return INFINITY;
	if (!is_cube_inside(piece, way, cube, depth, s))
		s = deep_cube_time(piece, way, cube, near.change, -depth);
	if (isinf(s) || !is_cube_inside(piece, way, cube, depth, s))
		return INFINITY;
	return entry_time(piece, way, cube, depth, near.change, s);
}

/* The same for the ball around the cube and a cutter of several pieces. */
static double whole_removes(const struct revolved *whole, const struct cutter_way *way, const struct cube *cube,
			    double depth, struct near_time near)
{
	const double needed = -(1.7320508075688773 * cube->half * (1 + DBL_EPSILON) + depth);
	double outside = 0, inside = 1;
	struct cutter_place place = place_at(way, near.s);

	if (-needed > whole->radius || point_distance(whole, &place, cube->centre) - near.gain > needed)
		return INFINITY;
	place = place_at(way, inside);
	/*
	 * In a solid that is not convex the search may miss the deepest position: if a wide cutter has a narrow neck,
	 * all positions below the top of the wide part are equally deep. But at the end of the way the next cut
	 * continues, so try the end first.
	 */
	if (point_distance(whole, &place, cube->centre) > needed) {
		inside = near.s;
		place = place_at(way, inside);
	}
	if (point_distance(whole, &place, cube->centre) > needed) {
		inside = deepest_time(whole, way, cube->centre, near.change, needed);
		if (isinf(inside))
			return INFINITY;
		place = place_at(way, inside);
		if (point_distance(whole, &place, cube->centre) > needed)
			return INFINITY;
	}
	place = place_at(way, 0);
	if (point_distance(whole, &place, cube->centre) <= needed)
		return 0;
	for (int i = 0; i < ENTRY_STEPS; i++) {
		const double middle = 0.5 * (outside + inside);

		place = place_at(way, middle);
		if (point_distance(whole, &place, cube->centre) <= needed)
			inside = middle;
		else
			outside = middle;
	}
	return inside;
}

/*
 * Is the cube farther from the path of the cutter's axis than the cutter's radius, or above or below the cutter all the
 * way?
 */
static bool is_beside(const struct cutter *cutter, const struct cutter_way *way, const struct cube *cube)
{
	const struct revolved *whole = &cutter->whole;
	const vec3 from = vec3_sub(cube->centre, way->from.origin), to = vec3_sub(cube->centre, way->to.origin);
	const double z0 = vec3_dot(from, way->from.up), z1 = vec3_dot(to, way->to.up);
	const vec3 w0 = vec3_mad(from, -z0, way->from.up), w1 = vec3_mad(to, -z1, way->to.up);
	const vec3 along = vec3_sub(w1, w0);
	const double length2 = vec3_norm2(along), room = whole->radius - cube->half;
	const double s = length2 > 0 ? smaller(larger(-vec3_dot(w0, along) / length2, 0), 1) : 0;

	/* This quick test is exact for a cutter that does not rotate. */
	if (turns(way))
		return false;
	if (larger(z0, z1) < whole->bands[whole->count - 1].bottom + cube->half ||
	    smaller(z0, z1) > whole->bands[0].top - cube->half)
		return true;
	return room < 0 || vec3_norm2(vec3_mad(w0, s, along)) > room * room;
}

double cutter_removes(const struct cutter *cutter, const struct cutter_way *way, const struct cube *cube, double depth)
{
	struct near_time near;
	double first = INFINITY;

	if (is_beside(cutter, way, cube))
		return INFINITY;
	near = near_time_of(cutter, way, cube->centre);
	for (size_t i = 0; i < cutter->piece_count; i++)
		first = smaller(first, piece_removes(&cutter->pieces[i], way, cube, depth, near));
	return cutter->piece_count > 1 ? smaller(first, whole_removes(&cutter->whole, way, cube, depth, near)) : first;
}

static bool is_part_inside(const struct revolved *piece, const struct cutter_place *place,
			   const struct cell_part *part, double depth)
{
	for (int i = 0; i < part->count; i++)
		if (point_distance(piece, place, part->points[i]) > -depth)
			return false;
	return true;
}

bool cutter_removes_part(const struct cutter *cutter, const struct cutter_way *way, const struct cell_part *part,
			 double depth, double latest)
{
	const struct closest closest = closest_of(way, part->middle, latest);
	const double radius = cutter->whole.radius;
	struct cutter_place place;

	/* This decides most cuts. If the cutter rotates, the test misses few cuts. */
	if (closest.distance2 > radius * radius)
		return false;
	place = place_at(way, closest.s);
	for (size_t i = 0; i < cutter->piece_count; i++)
		if (is_part_inside(&cutter->pieces[i], &place, part, depth))
			return true;
	return false;
}

/* A part of a way, and mm: an upper bound of the change of a point's distance from the cutter over the whole way. */
struct approach {
	const struct cutter *cutter;
	const struct cutter_way *way;
	vec3 point;
	double distance;
	double change;
};

static bool comes_within(const struct approach *approach, double low, double high)
{
	const double middle = 0.5 * (low + high), reach = 0.5 * (high - low) * approach->change;
	const struct cutter_place place = place_at(approach->way, middle);
	const double distance = point_distance(&approach->cutter->whole, &place, approach->point);

	if (distance - reach > approach->distance)
		return false;
	if (distance <= approach->distance || reach < 0.5 * COMES_WITHIN_SLACK)
		return true;
	return comes_within(approach, low, middle) || comes_within(approach, middle, high);
}

bool cutter_comes_within(const struct cutter *cutter, const struct cutter_way *way, vec3 point, double distance)
{
	const struct approach approach = {cutter, way, point, distance, change_of(cutter, way)};

	return comes_within(&approach, 0, 1);
}
