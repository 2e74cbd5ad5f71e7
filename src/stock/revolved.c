#include "stock/revolved.h"

#include <math.h>
#include <stdlib.h>

#include "base/math/math_functions.h"
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
	add_band(stretched, &(struct revolved_band){first->top + length, first->top, first->r_top, first->r_top, false});
	for (size_t i = 0; i < revolved->count; i++)
		add_band(stretched, &revolved->bands[i]);
}

void revolved_release(struct revolved *revolved)
{
	free(revolved->bands);
	*revolved = (struct revolved){0};
}

static double to_line(const struct revolved_band *band, double r, double z)
{
	const double along_r = band->r_bottom - band->r_top, along_z = band->bottom - band->top;
	const double off_r = r - band->r_top, off_z = z - band->top;
	const double s = (off_r * along_r + off_z * along_z) / (along_r * along_r + along_z * along_z);
	const double at = smaller(larger(s, 0), 1);
	const double dr = off_r - at * along_r, dz = off_z - at * along_z;

	return sqrt(dr * dr + dz * dz);
}

static double to_arc(const struct revolved_band *band, double r, double z)
{
	const double radius = band->top - band->bottom, dr = r - band->r_bottom, dz = z - band->top;

	if (dr >= 0 && dz <= 0)
		return fabs(sqrt(dr * dr + dz * dz) - radius);
	return smaller(math_hypot(r - band->r_top, dz), math_hypot(dr, z - band->bottom));
}

/* To the level line from r0 to r1 at `height`. */
static double to_level(double r0, double r1, double height, double r, double z)
{
	const double least = smaller(r0, r1), most = larger(r0, r1);
	const double dr = r < least ? least - r : r > most ? r - most : 0, dz = z - height;

	return sqrt(dr * dr + dz * dz);
}

static double radius_at(const struct revolved_band *band, double z)
{
	if (band->round) {
		const double radius = band->top - band->bottom, dz = z - band->top;

		return band->r_bottom + sqrt(larger(radius * radius - dz * dz, 0));
	}
	return band->r_top + (band->r_bottom - band->r_top) * (band->top - z) / (band->top - band->bottom);
}

double revolved_distance(const struct revolved *revolved, double r, double z)
{
	const struct revolved_band *first = &revolved->bands[0], *last = &revolved->bands[revolved->count - 1];
	double least = smaller(to_level(0, first->r_top, first->top, r, z),
			       to_level(0, last->r_bottom, last->bottom, r, z));
	bool inside = false;

	for (size_t i = 0; i < revolved->count; i++) {
		const struct revolved_band *band = &revolved->bands[i];

		least = smaller(least, band->round ? to_arc(band, r, z) : to_line(band, r, z));
		if (i > 0)
			least = smaller(least, to_level(band[-1].r_bottom, band->r_top, band->top, r, z));
		inside = inside || (z <= band->top && z >= band->bottom && r <= radius_at(band, z));
	}
	return inside ? -least : least;
}

/* The change of the radius for each mm downwards. */
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
