#include "gcode/execute/box_cover.h"

#include <math.h>
#include <stddef.h>

/* mm: a shorter displacement along a side is neglected; the spread covers it. */
#define SHORT 1e-9
/* The most lines of one part. */
#define MOST 4000
/* The factor by which the allowance is increased until there are few enough lines. */
#define WIDER 1.25

/* A parallelepiped: centre + the sum of the unit vectors, each times at most its half. `sine` is 1 for a box. */
struct part {
	vec3 centre, unit[3];
	double half[3], sine;
};

struct cover {
	vec3 lost;	/* added to each spread */
	double beside;
	long count;
	cover_take take;	/* NULL: the lines are only counted */
	void *context;
};

static vec3 absolute(vec3 v)
{
	return (vec3){fabs(v.x), fabs(v.y), fabs(v.z)};
}

static long pieces(double length, double width)
{
	return length > width ? (long)ceil(length / width) : 1;
}

/* Covers a slab by lines along its longer side: its middle is `at` from the centre along unit i, +- `thick`. */
static bool cover_slab(struct cover *cover, const struct part *part, const double half[3], int i, double at,
		       double thick, double width)
{
	const int one = (i + 1) % 3, other = (i + 2) % 3;
	const int along = half[one] >= half[other] ? one : other, across = along == one ? other : one;
	const long count = pieces(2 * half[across], width);
	const double narrow = half[across] / (double)count;
	struct cover_line line = {.spread = cover->lost};

	cover->count += count;
	line.spread = vec3_mad(line.spread, thick, absolute(part->unit[i]));
	line.spread = vec3_mad(line.spread, narrow, absolute(part->unit[across]));
	for (long n = 0; cover->take && n < count; n++) {
		const double aside = narrow * (double)(2 * n + 1 - count), forth = n % 2 ? -half[along] : half[along];
		const vec3 middle = vec3_mad(vec3_mad(part->centre, at, part->unit[i]), aside, part->unit[across]);

		line.from = vec3_mad(middle, -forth, part->unit[along]);
		line.to = vec3_mad(middle, forth, part->unit[along]);
		if (!cover->take(cover->context, &line))
			return false;
	}
	return true;
}

static int thinnest(const double half[3])
{
	int least = 0;

	for (int i = 1; i < 3; i++)
		least = half[i] < half[least] ? i : least;
	return least;
}

/* Covers the remaining core in layers perpendicular to its thinnest side; the spread of its lines is `reach`. */
static bool cover_core(struct cover *cover, const struct part *part, const double half[3], double width, double reach)
{
	const int i = thinnest(half);
	const long count = pieces(2 * half[i], width);
	const double thick = half[i] / (double)count;

	for (long n = 0; n < count; n++) {
		if (!cover_slab(cover, part, half, i, thick * (double)(2 * n + 1 - count), thick,
				fmax(width, 2 * (reach - thick))))
			return false;
	}
	return true;
}

/* The largest spread of a line that is 2 mm wide and thick. */
static double widest(const struct part *part)
{
	double most = 1;

	for (int i = 0; i < 3; i++)
		most = fmax(most, vec3_norm(vec3_add(absolute(part->unit[i]), absolute(part->unit[(i + 1) % 3]))));
	return most;
}

/*
 * Covers the part in shells, from the outside to the inside. A shell starts at `depth` from the faces, where `half` is
 * smaller by `depth`. A ball of radius depth * sine about each point there is inside the part, because a
 * parallelepiped with edges of 2 * depth contains such a ball. Therefore the spread of the lines may be up to
 * beside + depth * sine, and this determines the thickness of the shell and the width of its lines.
 */
static bool cover_shells(struct cover *cover, const struct part *part)
{
	const double spread = widest(part);
	double half[3] = {part->half[0], part->half[1], part->half[2]}, depth = 0;

	while (cover->take || cover->count <= MOST) {
		const double reach = cover->beside + depth * part->sine, width = 2 * reach / spread;

		if (half[thinnest(half)] <= width)
			return cover_core(cover, part, half, width, reach);
		for (int i = 0; i < 3; i++) {
			const double at = half[i] - width / 2;

			if (!cover_slab(cover, part, half, i, -at, width / 2, width) ||
			    !cover_slab(cover, part, half, i, at, width / 2, width))
				return false;
			half[i] -= width;
		}
		depth += width;
	}
	return true;
}

/* Covers the box at its start; its sides may be oblique. */
static bool cover_part(const struct cover *given, const struct box_way *box)
{
	struct cover cover = *given;
	struct part part = {.centre = box->start};
	long count;

	for (int i = 0; i < 3; i++) {
		part.half[i] = vec3_norm(box->half[i]);
		part.unit[i] = part.half[i] > 0 ? vec3_scale(1 / part.half[i], box->half[i]) : (vec3){0, 0, 0};
	}
	part.sine = fmin(fabs(vec3_dot(part.unit[0], vec3_cross(part.unit[1], part.unit[2]))), 1);
	cover.take = NULL;
	do {
		cover.count = 0;
		cover_shells(&cover, &part);
		count = cover.count;
		cover.beside *= count > MOST ? WIDER : 1;
	} while (count > MOST);
	cover.take = given->take;
	return cover_shells(&cover, &part);
}

/* Divides the way into parts along the sides; `rest` has parts that are too short and the part along no side. */
static int divide(const struct box_way *box, double part[3], vec3 *rest)
{
	int count = 0;

	*rest = box->way;
	for (int i = 0; i < 3; i++) {
		const double half = vec3_norm(box->half[i]);

		part[i] = half > 0 ? vec3_dot(box->way, box->half[i]) / half : 0;
		if (fabs(part[i]) <= SHORT)
			part[i] = 0;
		else
			*rest = vec3_mad(*rest, -part[i] / half, box->half[i]);
		count += fabs(part[i]) > 0;
	}
	return count;
}

/* A way along one side gives a longer box. A side without thickness is replaced by the way. */
static bool cover_prism(const struct cover *cover, const struct box_way *box, int side)
{
	const double half = vec3_norm(box->half[side]), way = vec3_norm(box->way);
	struct box_way prism = *box;

	prism.start = vec3_mad(box->start, 0.5, box->way);
	prism.half[side] = half > 0 ? vec3_scale(1 + way / 2 / half, box->half[side]) : vec3_scale(0.5, box->way);
	return cover_part(cover, &prism);
}

/*
 * A way along several sides: a place that the box sweeps is in the box at its start, or a leading face has swept it;
 * so it is in the prism of that face and the way.
 */
static bool cover_diagonal(const struct cover *cover, const struct box_way *box, const double part[3])
{
	if (!cover_part(cover, box))
		return false;
	for (int i = 0; i < 3; i++) {
		struct box_way face = *box;

		face.start = vec3_mad(vec3_mad(box->start, part[i] > 0 ? 1 : -1, box->half[i]), 0.5, box->way);
		face.half[i] = vec3_scale(0.5, box->way);
		if (fabs(part[i]) > 0 && !cover_part(cover, &face))
			return false;
	}
	return true;
}

bool box_cover(const struct box_way *box, double beside, cover_take take, void *context)
{
	struct cover cover = {.beside = beside, .take = take, .context = context};
	struct box_way along = *box;
	double part[3];
	vec3 rest;
	const int count = divide(box, part, &rest);

	if (vec3_norm(rest) > SHORT) {
		for (int i = 0; i < 3; i++) {
			if (!(vec3_norm(box->half[i]) > 0))
				return cover_prism(&cover, box, i);
		}
	}
	cover.lost = absolute(rest);
	along.way = vec3_sub(box->way, rest);
	if (count == 0)
		return cover_part(&cover, box);
	for (int i = 0; i < 3; i++) {
		if (count == 1 && fabs(part[i]) > 0)
			return cover_prism(&cover, &along, i);
	}
	return cover_diagonal(&cover, &along, part);
}
