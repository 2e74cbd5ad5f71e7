#include "gcode/dialect/sinumerik/cycles/sinumerik_argument.h"

#include <math.h>

#include "gcode/dialect/sinumerik/path/sinumerik_target.h"

/* mm: two depths that differ by less are equal. */
#define SAME_DEPTH 1e-6

/* _AMODE, units: the depth is given by DP or DPR (0), relative (1), or absolute (2). */
enum { DEPTH_BY_BOTH, DEPTH_RELATIVE, DEPTH_ABSOLUTE };

bool sinumerik_argument_given(const struct sinumerik_arguments *arguments, size_t i)
{
	return i < arguments->count && !isnan(arguments->values[i]);
}

double sinumerik_argument_or(const struct sinumerik_arguments *arguments, size_t i, double otherwise)
{
	return sinumerik_argument_given(arguments, i) ? arguments->values[i] : otherwise;
}

bool sinumerik_argument_counts(const struct sinumerik_arguments *arguments, size_t i)
{
	return fabs(sinumerik_argument_or(arguments, i, 0)) > 0;
}

double sinumerik_argument_length(const struct sinumerik_arguments *arguments, size_t i)
{
	return sinumerik_argument_or(arguments, i, 0) * arguments->interp->state.scale;
}

int sinumerik_argument_digit(const struct sinumerik_arguments *arguments, size_t i, int place)
{
	double number = fabs(trunc(sinumerik_argument_or(arguments, i, 0)));

	for (; place > 0; place--)
		number = floor(number / 10);
	return (int)fmod(number, 10);
}

/* _DMODE, units: the plane that the cycle selects; 0 is the active plane. */
bool sinumerik_argument_plane(const struct sinumerik_arguments *a, size_t display)
{
	static const int planes[] = {G17, G18, G19};
	const int plane = sinumerik_argument_digit(a, display, 0);

	if (plane > 3)
		return fault(&a->interp->at, a->column, "the units of _DMODE of %s must be 0 to 3, not %d", a->cycle,
			     plane);
	return plane == 0 || planes[plane - 1] == a->interp->state.plane ||
	       fault(&a->interp->at, a->column,
		     "_DMODE of %s works in the plane of G%d, and G%d is in force; select G%d before it", a->cycle,
		     planes[plane - 1] / 10, a->interp->state.plane / 10, planes[plane - 1] / 10);
}

/*
 * 840D sl, CYCLE81, "DPR": if DP and DPR are both given, DPR is used, and the control shows a message if they differ.
 * 0 counts as not given.
 */
static bool find_bottom(const struct sinumerik_arguments *a, const struct sinumerik_modes *modes,
			struct sinumerik_heights *heights)
{
	const int by = modes->alternative ? sinumerik_argument_digit(a, modes->alternative, 0) : DEPTH_BY_BOTH;
	const size_t relative = modes->has_relative ? SINUMERIK_DPR : SINUMERIK_DP;

	if (by > DEPTH_ABSOLUTE)
		return fault(&a->interp->at, a->column, "the units of _AMODE of %s must be 0, 1 or 2, not %d", a->cycle,
			     by);
	if (by == DEPTH_RELATIVE || (by == DEPTH_BY_BOTH && modes->has_relative &&
				     sinumerik_argument_counts(a, SINUMERIK_DPR))) {
		if (!sinumerik_argument_counts(a, relative))
			return fault(&a->interp->at, a->column, "_AMODE of %s needs the depth %s, which is not given",
				     a->cycle, modes->has_relative ? "DPR" : "DP");
		heights->bottom = heights->reference - fabs(sinumerik_argument_length(a, relative));
		return true;
	}
	if (!sinumerik_argument_given(a, SINUMERIK_DP))
		return fault(&a->interp->at, a->column, "%s needs RTP, RFP and %s", a->cycle,
			     modes->has_relative ? "one of DP and DPR" : "DP");
	heights->bottom = sinumerik_argument_length(a, SINUMERIK_DP);
	return true;
}

bool sinumerik_argument_heights(const struct sinumerik_arguments *a, const struct sinumerik_modes *modes,
				struct sinumerik_heights *heights)
{
	struct sinumerik_heights found;

	if (!sinumerik_target_check_cycle(a->interp, a->column))
		return false;
	if (!sinumerik_argument_given(a, SINUMERIK_RTP) || !sinumerik_argument_given(a, SINUMERIK_RFP))
		return fault(&a->interp->at, a->column, "%s needs RTP, RFP and %s", a->cycle,
			     modes->has_relative ? "one of DP and DPR" : "DP");
	found.clear = sinumerik_argument_length(a, SINUMERIK_RTP);
	found.reference = sinumerik_argument_length(a, SINUMERIK_RFP);
	found.safe = found.reference + fabs(sinumerik_argument_length(a, SINUMERIK_SDIS));
	if ((modes->display && !sinumerik_argument_plane(a, modes->display)) || !find_bottom(a, modes, &found))
		return false;
	if (found.clear < found.reference || found.bottom > found.reference)
		return fault(
		    &a->interp->at, a->column,
		    "the return plane RTP must not lie below the reference plane RFP, and the depth not above it "
		    "(the control's alarm 61101): RTP %.9g, RFP %.9g, depth %.9g mm",
		    found.clear, found.reference, found.bottom);
	if (found.reference - found.bottom <= SAME_DEPTH)
		return fault(&a->interp->at, a->column,
			     "the depth of %s is its reference plane RFP: the control does nothing, or goes to RTP, by "
			     "its version; leave the call out",
			     a->cycle);
	*heights = found;
	return true;
}
