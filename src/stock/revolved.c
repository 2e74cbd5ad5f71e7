#include "stock/revolved.h"

#include <math.h>
#include <stdlib.h>

#include "base/mem.h"
#include "base/minmax.h"

static void add_band(struct revolved *revolved, const struct revolved_band *band)
{
	if (!(band->top > band->bottom))
		return;
	revolved->bands[revolved->count++] = *band;
	revolved->radius = fmax(revolved->radius, fmax(band->r_top, band->r_bottom));
}

/* Replaces the lower end of the last band, a cylinder, by the tip. */
static void add_tip(struct revolved *revolved, const struct tool_solid *solid, double bottom)
{
	const double r = solid->sections[solid->count - 1].diameter_end / 2;
	struct revolved_band tip = {.bottom = bottom, .r_top = r};
	struct revolved_band *last = &revolved->bands[revolved->count - 1];

	tip.top = smaller(bottom + tool_solid_tip_height(solid), last->top);
	tip.round = solid->tip == TIP_BALL || solid->tip == TIP_BULL;
	if (solid->tip == TIP_BULL)
		tip.r_bottom = larger(r - solid->corner, 0);
	last->bottom = tip.top;
	if (!(last->top > last->bottom))
		revolved->count--;
	add_band(revolved, &tip);
}

void revolved_init(struct revolved *revolved, const struct tool_solid *solid)
{
	double z = solid->top;

	*revolved = (struct revolved){.bands = mem_zalloc(solid->count + 1, sizeof(*revolved->bands))};
	for (size_t i = 0; i < solid->count; i++) {
		const struct tool_section *s = &solid->sections[i];

		add_band(revolved,
			 &(struct revolved_band){z, z - s->length, s->diameter / 2, s->diameter_end / 2, false});
		z -= s->length;
	}
	if (solid->tip != TIP_FLAT && revolved->count)
		add_tip(revolved, solid, z);
}

bool revolved_widens_upward(const struct revolved *revolved)
{
	for (size_t i = 0; i < revolved->count; i++) {
		const struct revolved_band *band = &revolved->bands[i];

		if (band->r_top < band->r_bottom || (i > 0 && band[-1].r_bottom < band->r_top))
			return false;
	}
	return true;
}

void revolved_init_stretched(struct revolved *stretched, const struct revolved *revolved, double length)
{
	const struct revolved_band *first = &revolved->bands[0];

	*stretched = (struct revolved){.bands = mem_zalloc(revolved->count + 1, sizeof(*stretched->bands))};
	add_band(stretched,
		 &(struct revolved_band){first->top + length, first->top, first->r_top, first->r_top, false});
	for (size_t i = 0; i < revolved->count; i++)
		add_band(stretched, &revolved->bands[i]);
}

void revolved_release(struct revolved *revolved)
{
	free(revolved->bands);
	*revolved = (struct revolved){0};
}

/* The point of the outline that is nearest to a point. */
struct nearest {
	double r, z;	/* the point */
	double at_r, at_z;
	double distance2;	/* mm^2 */
};

static void offer(struct nearest *nearest, double r, double z)
{
	const double dr = nearest->r - r, dz = nearest->z - z, distance2 = dr * dr + dz * dz;

	if (!(distance2 < nearest->distance2))
		return;
	nearest->at_r = r;
	nearest->at_z = z;
	nearest->distance2 = distance2;
}

static void offer_line(struct nearest *nearest, const struct revolved_band *band)
{
	const double along_r = band->r_bottom - band->r_top, along_z = band->bottom - band->top;
	const double off_r = nearest->r - band->r_top, off_z = nearest->z - band->top;
	const double s = (off_r * along_r + off_z * along_z) / (along_r * along_r + along_z * along_z);
	const double at = smaller(larger(s, 0), 1);

	offer(nearest, band->r_top + at * along_r, band->top + at * along_z);
}

static void offer_arc(struct nearest *nearest, const struct revolved_band *band)
{
	const double radius = band->top - band->bottom, dr = nearest->r - band->r_bottom, dz = nearest->z - band->top;
	const double length = sqrt(dr * dr + dz * dz);

	if (dr >= 0 && dz <= 0 && length > 0) {
		offer(nearest, band->r_bottom + dr * (radius / length), band->top + dz * (radius / length));
		return;
	}
	offer(nearest, band->r_top, band->top);
	offer(nearest, band->r_bottom, band->bottom);
}

/* Tries the level line from r0 to r1. */
static void offer_level(struct nearest *nearest, double r0, double r1, double height)
{
	offer(nearest, smaller(larger(nearest->r, smaller(r0, r1)), larger(r0, r1)), height);
}

static double radius_at(const struct revolved_band *band, double z)
{
	if (band->round) {
		const double radius = band->top - band->bottom, dz = z - band->top;

		return band->r_bottom + sqrt(larger(radius * radius - dz * dz, 0));
	}
	return band->r_top + (band->r_bottom - band->r_top) * (band->top - z) / (band->top - band->bottom);
}

double revolved_nearest(const struct revolved *revolved, double r, double z, double *out_r, double *out_z)
{
	const struct revolved_band *first = &revolved->bands[0], *last = &revolved->bands[revolved->count - 1];
	struct nearest nearest = {.r = r, .z = z, .distance2 = INFINITY};
	bool inside = false;
	double distance;

	offer_level(&nearest, 0, first->r_top, first->top);
	offer_level(&nearest, 0, last->r_bottom, last->bottom);
	for (size_t i = 0; i < revolved->count; i++) {
		const struct revolved_band *band = &revolved->bands[i];

		(band->round ? offer_arc : offer_line)(&nearest, band);
		if (i > 0)
			offer_level(&nearest, band[-1].r_bottom, band->r_top, band->top);
		inside = inside || (z <= band->top && z >= band->bottom && r <= radius_at(band, z));
	}
	distance = sqrt(nearest.distance2);
	*out_r = inside ? nearest.at_r - r : r - nearest.at_r;
	*out_z = inside ? nearest.at_z - z : z - nearest.at_z;
	return inside ? -distance : distance;
}

double revolved_distance(const struct revolved *revolved, double r, double z)
{
	double out_r, out_z;

	return revolved_nearest(revolved, r, z, &out_r, &out_z);
}

/* The growth of the radius per mm downward. */
static double growth(const struct revolved_band *band)
{
	return band->round ? 0 : (band->r_bottom - band->r_top) / (band->top - band->bottom);
}

size_t revolved_convex_run(const struct revolved *revolved, size_t first)
{
	size_t end = first + 1;

	while (end < revolved->count) {
		const struct revolved_band *above = &revolved->bands[end - 1], *band = &revolved->bands[end];

		if (above->round || above->r_bottom > band->r_top || above->r_bottom < band->r_top ||
		    growth(band) > growth(above))
			break;
		end++;
	}
	return end - first;
}
