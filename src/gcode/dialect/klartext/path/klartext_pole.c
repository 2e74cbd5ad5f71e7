#include "gcode/dialect/klartext/path/klartext_pole.h"

#include <math.h>

#include "base/math/math_functions.h"
#include "base/units.h"
#include "gcode/dialect/klartext/frames/klartext_frame.h"
#include "geom/tolerance.h"

/* mm: the distance between the tool and the point of PR and PA if coordinates have three decimals. */
#define RADIUS_SAME 0.002

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

/* Coordinates may change after CC. Does this coordinate of the pole still mean the same place? */
static bool stands(const struct interp *interp, int slot)
{
	const struct klartext_pole *pole = &klartext_of(interp)->pole;
	const vec3 now = klartext_frame_point_at(interp, pole->place);

	return fabs(klartext_pole_coordinate(now, slot) - klartext_pole_coordinate(pole->point, slot)) <=
	       SAME_COORDINATE;
}

bool klartext_pole_check(struct interp *interp, unsigned axes, int column)
{
	if (!klartext_frame_check_shift(interp, axes, column))
		return false;
	for (int slot = SLOT_X; slot <= SLOT_Z; slot++) {
		if (axes & 1U << slot && klartext_of(interp)->pole.has[slot] && !stands(interp, slot))
			return fault(
			    &interp->at, column,
			    "%c of CC was given before a change of coordinates: whether the centre has moved with "
			    "them is not known here; write CC again, with all its coordinates",
			    AXIS_LETTERS[slot]);
	}
	return true;
}

bool klartext_pole_find(struct interp *interp, int column, struct plane_point *pole)
{
	const struct klartext *klartext = klartext_of(interp);
	int a, b;

	axes_of_plane(klartext->pole.across, &a, &b);
	if (!klartext->pole.has[a] || !klartext->pole.has[b])
		return fault(&interp->at, column, "no CC has given the centre");
	*pole = klartext_pole_flat(klartext->pole.point, klartext->pole.across);
	return klartext_pole_check(
	    interp, klartext->pole.spatial ? 1U << SLOT_X | 1U << SLOT_Y | 1U << SLOT_Z : 1U << a | 1U << b, column);
}

/* The direction from the pole to the point, in degrees. */
static double polar_angle(struct plane_point pole, struct plane_point point)
{
	return math_atan2_degrees(point.b - pole.b, point.a - pole.a);
}

/*
 * The manuals do not say whether an increment, or a value that is left out, counts from the last PR and PA or from the
 * position of the tool as seen from the pole. False: the two differ, which was reported.
 */
static bool check_last(struct interp *interp, const struct klartext_words *words, double radius, double angle)
{
	const struct klartext_pole *pole = &klartext_of(interp)->pole;
	const bool by_radius = !words->has_radius || words->radius_increment,
		   by_angle = !words->has_angle || words->angle_increment;

	if (!pole->polar.given ||
	    ((!by_radius || fabs(pole->polar.radius - radius) <= RADIUS_SAME) &&
	     (!by_angle || radians(fabs(remainder(pole->polar.angle - angle, 360))) * radius <= RADIUS_SAME)))
		return true;
	return fault(
	    &interp->at, words->first_column,
	    "the tool has moved, or CC has changed, since the last PR and PA: from where %s counts is not known "
	    "here; write PR and PA as absolute values",
	    by_angle ? "PA" : "PR");
}

bool klartext_pole_point(struct interp *interp, const struct klartext_words *words, const struct klartext_path *path,
			 struct klartext_target *target)
{
	int across = klartext_of(interp)->pole.across, a, b;
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
	/* Only CP has a direction of rotation, and CP begins at the position of the tool. */
	if (!words->direction && !check_last(interp, words, radius, angle))
		return false;
	if (words->has_radius)
		radius = words->radius + (words->radius_increment ? radius : 0);
	if (words->has_angle)
		angle = words->angle + (words->angle_increment ? angle : 0);
	if (radius < 0)
		return fault(&interp->at, words->radius_column, "a polar radius cannot be negative");
	klartext_of(interp)->pole.polar.given = true;
	klartext_of(interp)->pole.polar.radius = radius;
	klartext_of(interp)->pole.polar.angle = angle;
	klartext_pole_put(
	    &target->point, across,
	    (struct plane_point){pole.a + radius * math_cos_degrees(angle), pole.b + radius * math_sin_degrees(angle)});
	return true;
}
