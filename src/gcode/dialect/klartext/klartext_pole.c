#include "gcode/dialect/klartext/klartext_pole.h"

#include <math.h>

#include "base/math/math_functions.h"
#include "base/units.h"
#include "gcode/dialect/klartext/klartext_frame.h"

/* ------------------------------------------------------------------ planes */

/* The first and the second axis of the plane across Z, Y or X. */
static void axes_of_plane(int across, int *a, int *b)
{
	*a = across == SLOT_Z ? SLOT_X : across == SLOT_Y ? SLOT_Z : SLOT_Y;
	*b = across == SLOT_Z ? SLOT_Y : across == SLOT_Y ? SLOT_X : SLOT_Z;
}

double klartext_pole_coordinate(vec3 v, int slot)
{
	return slot == SLOT_X ? v.x : slot == SLOT_Y ? v.y : v.z;
}

void klartext_pole_set_coordinate(vec3 *v, int slot, double value)
{
	*(slot == SLOT_X ? &v->x : slot == SLOT_Y ? &v->y : &v->z) = value;
}

struct plane_point klartext_pole_flat(vec3 v, int across)
{
	int a, b;

	axes_of_plane(across, &a, &b);
	return (struct plane_point){klartext_pole_coordinate(v, a), klartext_pole_coordinate(v, b)};
}

void klartext_pole_put(vec3 *v, int across, struct plane_point point)
{
	int a, b;

	axes_of_plane(across, &a, &b);
	klartext_pole_set_coordinate(v, a, point.a);
	klartext_pole_set_coordinate(v, b, point.b);
}

bool klartext_pole_find(struct interp *interp, int column, struct plane_point *pole)
{
	const struct klartext *klartext = klartext_of(interp);
	int a, b;

	axes_of_plane(klartext->across, &a, &b);
	if (!klartext->has_pole[a] || !klartext->has_pole[b])
		return fault(&interp->at, column, "no CC has given the centre");
	*pole = klartext_pole_flat(klartext->pole, klartext->across);
	return true;
}

/* Degrees: where the tool stands as seen from the pole. */
static double polar_angle(struct plane_point pole, struct plane_point point)
{
	return math_atan2_degrees(point.b - pole.b, point.a - pole.a);
}

bool klartext_pole_point(struct interp *interp, const struct klartext_words *words, const struct klartext_path *path,
			 struct klartext_target *target)
{
	int across = klartext_of(interp)->across, a, b;
	struct plane_point pole, here;
	double radius, angle;
	bool relative;

	axes_of_plane(across, &a, &b);
	if (klartext_words_has(words, a) || klartext_words_has(words, b))
		return fault(&interp->at, words->column[klartext_words_has(words, a) ? a : b],
			     "polar coordinates and %c in one block",
			     AXIS_LETTERS[klartext_words_has(words, a) ? a : b]);
	if (!klartext_pole_find(interp, words->first_column, &pole))
		return false;
	relative = !words->has_radius || words->radius_increment || !words->has_angle || words->angle_increment;
	if (relative && (!klartext_frame_check_increment(interp, a, words->first_column) ||
			 !klartext_frame_check_increment(interp, b, words->first_column)))
		return false;
	here = klartext_pole_flat(path->start, across);
	radius = math_hypot(here.a - pole.a, here.b - pole.b);
	angle = polar_angle(pole, here);
	if (words->has_radius)
		radius = words->radius + (words->radius_increment ? radius : 0);
	if (words->has_angle)
		angle = words->angle + (words->angle_increment ? angle : 0);
	if (radius < 0)
		return fault(&interp->at, words->radius_column, "a polar radius cannot be negative");
	klartext_pole_put(
	    &target->point, across,
	    (struct plane_point){pole.a + radius * math_cos_degrees(angle), pole.b + radius * math_sin_degrees(angle)});
	return true;
}
