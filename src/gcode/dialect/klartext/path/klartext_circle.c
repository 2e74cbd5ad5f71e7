#include "gcode/dialect/klartext/path/klartext_circle.h"

#include <math.h>

#include "base/math/math_functions.h"
#include "base/same_double.h"
#include "base/units.h"
#include "gcode/dialect/klartext/frames/klartext_frame.h"
#include "gcode/dialect/klartext/path/klartext_path.h"
#include "gcode/dialect/klartext/path/klartext_pole.h"
#include "gcode/dialect/klartext/text/klartext_lexis.h"
#include "gcode/execute/arc.h"
#include "geom/tolerance.h"

/*
 * mm: the largest difference between the radii at the start and at the end of a circle (iTNC 530 user's manual,
 * "Circular path C around circle center CC": input tolerance up to 0.016 mm).
 */
#define RADIUS_TOLERANCE 0.016

/* mm: a smaller radius counts as 0. */
#define RADIUS_LEAST 1e-6

/* ------------------------------------------------------------------ planes */

static vec3 normal_of(int across)
{
	vec3 normal = {0, 0, 0};

	klartext_pole_set_coordinate(&normal, across, 1);
	return normal;
}

static bool check_direction(struct interp *interp, const struct klartext_words *words, const char *what)
{
	return words->direction ||
	       fault(&interp->at, words->first_column, "%s needs its direction of rotation, DR+ or DR-", what);
}

/* Refuses a coordinate of the axis across the plane. Only a helix moves this axis. False: reported. */
static bool check_across(struct interp *interp, const struct klartext_words *words, int across, const char *what)
{
	if (!klartext_words_has(words, across))
		return true;
	return fault(&interp->at, words->column[across],
		     "%c does not belong to the plane of this %s; a helix is written as CP", AXIS_LETTERS[across],
		     what);
}

/* --------------------------------------------------------------------- CC */

/*
 * CC with one coordinate keeps the others. The kept coordinates of the active plane must not have changed their place
 * since. False: reported.
 */
static bool check_kept(struct interp *interp, const struct klartext_words *words)
{
	const unsigned plane = 1U << SLOT_X | 1U << SLOT_Y | 1U << SLOT_Z;
	const unsigned kept = plane & ~words->axes & ~(1U << klartext_of(interp)->pole.across);

	return (words->axes & (words->axes - 1)) || klartext_pole_check(interp, kept, words->first_column);
}

/*
 * iTNC 530 user's manual, "Circle center CC": coordinates that are left out keep their values; CC alone takes the
 * present position as the centre; I values count from the present position. Two coordinates select the plane. Three
 * coordinates select the plane of the tool axis (TNC 407 user's manual, "Circles in the main planes") if the circle
 * lies in it.
 */
bool klartext_circle_pole(struct lexer *lexer)
{
	struct interp *interp = lexer->context;
	struct klartext_pole *pole = &klartext_of(interp)->pole;
	const unsigned plane = 1U << SLOT_X | 1U << SLOT_Y | 1U << SLOT_Z;
	vec3 here = klartext_frame_point(interp);
	struct klartext_words words;

	if (!klartext_words_read(lexer, &words))
		return false;
	if (words.has_radius || words.has_angle)
		return fault(lexer->at, words.first_column, "CC in polar coordinates is not supported");
	if (words.axes & ~plane || words.m_count || words.feed || words.has_size || words.direction || words.comp)
		return fault(lexer->at, words.first_column, "CC has coordinates of X, Y and Z alone");
	if (!words.axes) {
		if (!klartext_frame_check_increment(interp, SLOT_X, words.first_column) ||
		    !klartext_frame_check_increment(interp, SLOT_Y, words.first_column))
			return false;
		pole->point = here;
		pole->across = SLOT_Z;
		pole->has[SLOT_X] = pole->has[SLOT_Y] = true;
		pole->spatial = false;
		pole->place = klartext_frame_place_of(interp, pole->point);
		return true;
	}
	if (!check_kept(interp, &words))
		return false;
	pole->spatial = words.axes == plane;
	for (int slot = SLOT_X; slot <= SLOT_Z; slot++) {
		bool increment = words.increments & 1U << slot;
		double from = increment ? klartext_pole_coordinate(here, slot) : 0;

		if (increment && !klartext_frame_check_increment(interp, slot, words.column[slot]))
			return false;
		if (klartext_words_has(&words, slot)) {
			klartext_pole_set_coordinate(&pole->point, slot, words.value[slot] + from);
			pole->has[slot] = true;
		}
	}
	if (words.axes == plane)
		pole->across = SLOT_Z;
	else if (klartext_words_has(&words, SLOT_Z))
		pole->across = klartext_words_has(&words, SLOT_X)   ? SLOT_Y
			       : klartext_words_has(&words, SLOT_Y) ? SLOT_X
								    : pole->across;
	else if (klartext_words_has(&words, SLOT_X) && klartext_words_has(&words, SLOT_Y))
		pole->across = SLOT_Z;
	pole->place = klartext_frame_place_of(interp, pole->point);
	return true;
}

/* ------------------------------------------------------------------ C, CR */

static bool fill_arc(struct interp *interp, struct klartext_path *path, vec3 end, struct plane_point centre, int across,
		     int direction, int column)
{
	struct plane_point start_point = klartext_pole_flat(path->start, across),
			   end_point = klartext_pole_flat(end, across);
	double r0 = math_hypot(start_point.a - centre.a, start_point.b - centre.b);
	double r1 = math_hypot(end_point.a - centre.a, end_point.b - centre.b);

	if (r0 < RADIUS_LEAST || r1 < RADIUS_LEAST)
		return fault(&interp->at, column, "a circle of radius 0: %.6g mm at its start, %.6g mm at its end", r0,
			     r1);
	if (fabs(r0 - r1) > RADIUS_TOLERANCE)
		return fault(&interp->at, column,
			     "the radius of the circle is %.6g mm at its start and %.6g mm at its end", r0, r1);
	path->arc = true;
	path->centre = path->start;
	klartext_pole_put(&path->centre, across, centre);
	path->normal = normal_of(across);
	path->sweep = arc_sweep(start_point, end_point, centre, direction < 0, 1, SAME_POINT / r0);
	return true;
}

/* Does a circle from start to end about the pole lie in the plane across this axis? */
static bool fits(const struct klartext *klartext, const struct klartext_path *path, vec3 end, int across)
{
	const struct plane_point centre = klartext_pole_flat(klartext->pole.point, across);
	const struct plane_point from = klartext_pole_flat(path->start, across), to = klartext_pole_flat(end, across);
	const double r0 = math_hypot(from.a - centre.a, from.b - centre.b),
		     r1 = math_hypot(to.a - centre.a, to.b - centre.b);

	return r0 > RADIUS_TOLERANCE && r1 > RADIUS_TOLERANCE && fabs(r0 - r1) <= RADIUS_TOLERANCE &&
	       fabs(klartext_pole_coordinate(path->start, across) - klartext_pole_coordinate(end, across)) <=
		   RADIUS_TOLERANCE;
}

/*
 * Bounds a circle whose plane is not certain: it lies in a cube about the pole in any plane. Finds how far the cube
 * reaches from the straight line.
 */
static void bound_circle(const struct klartext *klartext, struct klartext_path *path, vec3 end)
{
	const double radius = vec3_norm(vec3_sub(path->start, klartext->pole.point)) + RADIUS_TOLERANCE;

	path->open = true;
	for (int slot = SLOT_X; slot <= SLOT_Z; slot++) {
		const double from = klartext_pole_coordinate(path->start, slot),
			     to = klartext_pole_coordinate(end, slot),
			     pole = klartext_pole_coordinate(klartext->pole.point, slot);

		path->half[slot] = fmax(pole + radius - fmin(from, to), fmax(from, to) - (pole - radius));
	}
}

/*
 * Finds the plane of a circle whose pole has X, Y and Z and that does not lie in the plane of the tool axis. If the
 * circle lies in one other plane, that plane is taken (the control may also refuse the circle). If it lies in both, the
 * path is bounded. False: it lies in no plane.
 */
static bool find_plane(const struct klartext *klartext, struct klartext_path *path, vec3 end, int *across)
{
	const bool along_x = fits(klartext, path, end, SLOT_X), along_y = fits(klartext, path, end, SLOT_Y);

	if (along_x && along_y)
		bound_circle(klartext, path, end);
	*across = along_x ? SLOT_X : SLOT_Y;
	return along_x || along_y;
}

bool klartext_circle_fill(struct interp *interp, struct klartext_path *path, vec3 end, vec3 centre, int direction,
			  int column)
{
	return fill_arc(interp, path, end, klartext_pole_flat(centre, SLOT_Z), SLOT_Z, direction, column);
}

static bool shape_about_pole(struct interp *interp, const struct klartext_words *words, struct klartext_target *target,
			     struct klartext_path *path)
{
	const struct klartext *klartext = klartext_of(interp);
	bool whole = klartext->pole.has[SLOT_X] && klartext->pole.has[SLOT_Y] && klartext->pole.has[SLOT_Z];
	int across = klartext->pole.across;
	struct plane_point centre;

	if (!check_direction(interp, words, "C") || !klartext_pole_find(interp, words->first_column, &centre))
		return false;
	if (whole && across == SLOT_Z && (klartext->pole.spatial || klartext_words_has(words, SLOT_Z)) &&
	    !fits(klartext, path, target->point, SLOT_Z)) {
		if (!find_plane(klartext, path, target->point, &across))
			return fault(
			    &interp->at, words->first_column,
			    "the circle about this CC lies in none of the planes XY, YZ and ZX: its radii differ, or "
			    "it leaves the plane; a helix is written as CP");
		centre = klartext_pole_flat(klartext->pole.point, across);
	} else if (!klartext->pole.spatial && !check_across(interp, words, across, "circle")) {
		return false;
	}
	return path->open ||
	       fill_arc(interp, path, target->point, centre, across, words->direction, words->first_column);
}

bool klartext_circle_about_pole(struct lexer *lexer)
{
	return klartext_path_run(lexer, shape_about_pole);
}

/* "Circular path CR with defined radius": R > 0 turns less than half a turn, R < 0 more. */
static bool shape_by_radius(struct interp *interp, const struct klartext_words *words, struct klartext_target *target,
			    struct klartext_path *path)
{
	static const struct arc_tolerance tolerance = {RADIUS_TOLERANCE, RADIUS_TOLERANCE};
	struct plane_point centre = {0, 0};

	if (!check_direction(interp, words, "CR") || !check_across(interp, words, SLOT_Z, "circle"))
		return false;
	if (!words->has_size || same_double(words->size, 0))
		return fault(&interp->at, words->first_column, "CR needs its radius in R");
	switch (arc_find_centre(klartext_pole_flat(path->start, SLOT_Z), klartext_pole_flat(target->point, SLOT_Z),
				words->size, words->direction < 0, &tolerance, &centre)) {
	case ARC_NO_CHORD:
		return fault(&interp->at, words->first_column,
			     "a circle by its radius cannot end where it starts; use CC and C");
	case ARC_RADIUS_TOO_SMALL:
		return fault(&interp->at, words->size_column,
			     "a radius of %.6g mm does not reach from the start of the circle to its end",
			     fabs(words->size));
	default:
		return fill_arc(interp, path, target->point, centre, SLOT_Z, words->direction, words->first_column);
	}
}

bool klartext_circle_by_radius(struct lexer *lexer)
{
	return klartext_path_run(lexer, shape_by_radius);
}

/* ---------------------------------------------------------------------- CT */

/*
 * The circle that starts in direction t and ends at e. Its centre lies on the normal at the start and has the same
 * distance from the start and the end. With n = z x t and d = e - start: centre = start + n d.d / (2 n.d).
 */
static bool fill_tangential(struct interp *interp, const struct klartext_words *words,
			    const struct klartext_target *target, struct klartext_path *path)
{
	const vec3 z = {0, 0, 1};
	vec3 direction, way = vec3_sub(target->point, path->start), across;
	struct plane_point centre;
	double side;

	if (!check_across(interp, words, SLOT_Z, "circle"))
		return false;
	if (!klartext_move_end_direction(&klartext_of(interp)->last, &direction) || fabs(direction.z) > SAME_POINT)
		return fault(&interp->at, words->first_column,
			     "CT needs a path block before it that moves in the plane, to start in its direction");
	way.z = 0;
	across = vec3_cross(z, direction);
	side = vec3_dot(across, way);
	/* The end lies straight ahead: the path is a line. */
	if (fabs(side) <= SAME_POINT && vec3_dot(direction, way) > 0)
		return true;
	if (fabs(side) <= SAME_POINT)
		return fault(&interp->at, words->first_column,
			     "the end of CT lies behind its start: no circle leads there");
	across = vec3_scale(vec3_norm2(way) / (2 * side), across);
	centre = (struct plane_point){path->start.x + across.x, path->start.y + across.y};
	return fill_arc(interp, path, target->point, centre, SLOT_Z, side > 0 ? 1 : -1, words->first_column);
}

static bool shape_tangential(struct interp *interp, const struct klartext_words *words, struct klartext_target *target,
			     struct klartext_path *path)
{
	return fill_tangential(interp, words, target, path);
}

bool klartext_circle_tangential(struct lexer *lexer)
{
	return klartext_path_run(lexer, shape_tangential);
}

/* ------------------------------------------------------------------- polar */

static bool shape_polar_line(struct interp *interp, const struct klartext_words *words, struct klartext_target *target,
			     struct klartext_path *path)
{
	return klartext_pole_point(interp, words, path, target);
}

bool klartext_circle_polar_line(struct lexer *lexer)
{
	return klartext_path_run(lexer, shape_polar_line);
}

/*
 * "Circular path CP around pole CC", "Helical interpolation": PA is the polar angle of the end; IPA is the angle of the
 * turn, which may be more than 360 degrees; IZ is the height of a helix. IPA and DR have the same sign.
 */
static bool shape_polar(struct interp *interp, const struct klartext_words *words, struct klartext_target *target,
			struct klartext_path *path)
{
	int across = klartext_of(interp)->pole.across;
	struct plane_point centre;

	if (!check_direction(interp, words, "CP") || !klartext_pole_find(interp, words->first_column, &centre))
		return false;
	if (words->has_radius)
		return fault(&interp->at, words->radius_column,
			     "CP keeps the distance from the pole; PR does not belong to it");
	if (!words->has_angle)
		return fault(&interp->at, words->first_column, "CP needs PA or IPA");
	if (words->angle_increment && words->angle * words->direction < 0)
		return fault(&interp->at, words->angle_column, "the signs of IPA and DR differ");
	if (!klartext_pole_point(interp, words, path, target) ||
	    !fill_arc(interp, path, target->point, centre, across, words->direction, words->first_column))
		return false;
	if (words->angle_increment)
		path->sweep = radians(words->angle);
	return !same_double(path->sweep, 0) || fault(&interp->at, words->angle_column, "a circle of 0 degrees");
}

bool klartext_circle_polar(struct lexer *lexer)
{
	return klartext_path_run(lexer, shape_polar);
}

static bool shape_tangential_polar(struct interp *interp, const struct klartext_words *words,
				   struct klartext_target *target, struct klartext_path *path)
{
	return klartext_pole_point(interp, words, path, target) && fill_tangential(interp, words, target, path);
}

bool klartext_circle_tangential_polar(struct lexer *lexer)
{
	return klartext_path_run(lexer, shape_tangential_polar);
}
