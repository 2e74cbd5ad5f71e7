#include "gcode/dialect/sinumerik/path/sinumerik_soft_path.h"

#include <math.h>

#include "base/same_double.h"
#include "gcode/dialect/sinumerik/words/sinumerik_codes.h"
#include "gcode/execute/cutter_comp/cutter_comp.h"
#include "geom/tolerance.h"

bool sinumerik_soft_path_departs(int code)
{
	return code == SINUMERIK_G(148) || code == SINUMERIK_G(248) || code == SINUMERIK_G(348);
}

/*
 * 840D sl, basic functions W1, "Soft approach and retraction": G141 is left of the contour and G142 right of it. G140
 * is the side of G41 or G42, also for a tool of radius 0; with G40 it is G143, the side on which the other end of the
 * motion lies. 1: left, -1: right, 0: reported.
 */
static int find_side(struct interp *interp, const struct sinumerik_soft_words *words, struct plane_point contour,
		     struct plane_point along, const struct plane_point *outside)
{
	const struct sinumerik_comp *comp = &sinumerik_of(interp)->comp;
	double aside;

	if (comp->soft_side == SINUMERIK_G(141) || comp->soft_side == SINUMERIK_G(142))
		return comp->soft_side == SINUMERIK_G(141) ? 1 : -1;
	if (comp->soft_side != SINUMERIK_G(143) && (comp->selected == G41 || comp->selected == G42))
		return comp->selected == G41 ? 1 : -1;
	if (!outside) {
		fault_report(&interp->at, words->column,
			     "G%d with G143, or with G140 and G40, needs its end in the plane: on which side of the "
			     "contour it lies depends on this end",
			     words->code / 10);
		return 0;
	}
	aside = along.a * (outside->b - contour.b) - along.b * (outside->a - contour.a);
	if (fabs(aside) < SAME_POINT) {
		fault_report(&interp->at, words->column,
			     "G%d with G143, or with G140 and G40, from a point on the tangent of the contour: on "
			     "which side of the contour it lies is not known; write G141 or G142",
			     words->code / 10);
		return 0;
	}
	return aside > 0 ? 1 : -1;
}

static bool find_line(struct interp *interp, const struct sinumerik_soft_words *words, struct plane_point contour,
		      struct plane_point along, struct sinumerik_soft_path *path)
{
	const bool compensates = cutter_comp_is_on(interp);
	const double length = words->size + (compensates ? interp->comp.radius : 0);

	if (compensates && !same_double(sinumerik_of(interp)->comp.allowance, 0))
		return fault(&interp->at, words->column,
			     "G%d with OFFN is not supported: whether its line is longer by OFFN is not documented; "
			     "write G%d",
			     words->code / 10, words->code / 10 + 100);
	if (!(length > SAME_POINT))
		return fault(&interp->at, words->column,
			     "G%d needs DISR that is more than 0, or with tool radius compensation more than minus the "
			     "radius",
			     words->code / 10);
	*path = (struct sinumerik_soft_path){
	    .end = plane_along(contour, sinumerik_soft_path_departs(words->code) ? length : -length, along)};
	return true;
}

/* DISR is the radius of the path of the tool's centre; the programmed circle has another one under compensation. */
static bool find_circle(struct interp *interp, const struct sinumerik_soft_words *words, struct plane_point contour,
			struct plane_point along, int side, struct sinumerik_soft_path *path)
{
	const bool half = words->code == SINUMERIK_G(347) || words->code == SINUMERIK_G(348);
	const double wider = cutter_comp_is_on(interp) ? side * interp->comp.side * interp->comp.radius : 0;
	const double radius = words->size + wider, turned = sinumerik_soft_path_departs(words->code) ? radius : -radius;
	const struct plane_point left = {-along.b, along.a};

	if (!(words->size > SAME_POINT))
		return fault(&interp->at, words->column, "G%d needs DISR that is more than 0", words->code / 10);
	if (!(radius > SAME_POINT))
		return fault(&interp->at, words->column,
			     "DISR of G%d, on the side of the contour where the tool is not, must be more than the "
			     "tool's radius, %.6g mm",
			     words->code / 10, interp->comp.radius);
	path->is_arc = true;
	path->clockwise = side < 0;
	path->centre = plane_along(contour, side * radius, left);
	path->end = half ? plane_along(contour, 2 * side * radius, left) : plane_along(path->centre, turned, along);
	return true;
}

bool sinumerik_soft_path_find(struct interp *interp, const struct sinumerik_soft_words *words,
			      struct plane_point contour, struct plane_point along, const struct plane_point *outside,
			      struct sinumerik_soft_path *path)
{
	int side;

	if (words->code == SINUMERIK_G(147) || words->code == SINUMERIK_G(148))
		return find_line(interp, words, contour, along, path);
	side = find_side(interp, words, contour, along, outside);
	return side != 0 && find_circle(interp, words, contour, along, side, path);
}
