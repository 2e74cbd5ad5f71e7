#include "gcode/dialect/sinumerik/sinumerik_pattern.h"

#include <math.h>
#include <string.h>

#include "base/units.h"
#include "gcode/dialect/sinumerik/sinumerik_cycle.h"
#include "gcode/dialect/sinumerik/sinumerik_frame.h"
#include "gcode/dialect/sinumerik/sinumerik_move.h"

/* Of one CYCLE802. */
#define POSITIONS 9

bool sinumerik_pattern_is(const char *name)
{
	return !strcmp(name, "HOLES1") || !strcmp(name, "HOLES2") || !strcmp(name, "CYCLE802");
}

static bool drill_at(struct interp *interp, enum axis_slot a, enum axis_slot b, double at_a, double at_b)
{
	const struct sinumerik_modal *modal = &sinumerik_of(interp)->modal;
	slot_values target = *sinumerik_frame_place(interp);

	target.v[a] = at_a;
	target.v[b] = at_b;
	/* Without a modal cycle it only goes there. */
	if (!sinumerik_move_to(interp, &target, true) || !modal->on)
		return sinumerik_of(interp)->placed;
	return sinumerik_cycle_drill(interp, modal->name, modal->arguments, modal->argument_count, 1);
}

/* HOLES1(SPCA, SPCO, STA1, FDIS, DBH, NUM): a row; the control begins at the end that is nearer to the tool. */
static bool run_row(struct interp *interp, const double *n, enum axis_slot a, enum axis_slot b)
{
	const double scale = interp->state.scale, c = math_cos_degrees(n[2]), s = math_sin_degrees(n[2]), count = n[5];
	const slot_values *place = sinumerik_frame_place(interp);
	const double first = n[3] * scale, last = (n[3] + (count - 1) * n[4]) * scale;
	const double along = (place->v[a] - n[0] * scale) * c + (place->v[b] - n[1] * scale) * s;
	const bool backward = fabs(along - last) < fabs(along - first);

	for (int i = 0; i < (int)count; i++) {
		const double step = backward ? count - 1 - i : i, at = (n[3] + step * n[4]) * scale;

		if (!drill_at(interp, a, b, n[0] * scale + at * c, n[1] * scale + at * s))
			return false;
	}
	return true;
}

/* HOLES2(CPA, CPO, RAD, STA1, INDA, NUM): a circle; INDA 0 divides all of it. */
static bool run_ring(struct interp *interp, const double *n, enum axis_slot a, enum axis_slot b)
{
	const double scale = interp->state.scale, step = fabs(n[4]) > 0 ? n[4] : 360 / n[5];

	for (int i = 0; i < (int)n[5]; i++) {
		const double angle = n[3] + i * step;
		const double x = n[0] + n[2] * math_cos_degrees(angle), y = n[1] + n[2] * math_sin_degrees(angle);

		if (!drill_at(interp, a, b, x * scale, y * scale))
			return false;
	}
	return true;
}

/*
 * CYCLE802(XA, YA, X0, Y0, X1, Y1, ...): up to nine positions, in their order. XA and YA have a digit for each of them,
 * 1 if it is absolute.
 */
static bool run_positions(struct interp *interp, int column, enum axis_slot a, enum axis_slot b)
{
	const struct sinumerik *sinumerik = sinumerik_of(interp);
	const double all_absolute = 111111111, scale = interp->state.scale;

	for (size_t i = 0; i < 2 && i < sinumerik->argument_count; i++) {
		if (fabs(sinumerik->arguments[i] - all_absolute) > 0)
			return fault(
			    &interp->at, column,
			    "CYCLE802 with positions that are not all absolute (its first two arguments must be "
			    "111111111) is not supported yet");
	}
	for (size_t i = 2; i + 1 < sinumerik->argument_count && i < 2 + 2 * POSITIONS; i += 2) {
		const double x = sinumerik->arguments[i], y = sinumerik->arguments[i + 1];

		if (isnan(x) && isnan(y))
			break;
		if (isnan(x) || isnan(y))
			return fault(&interp->at, column, "a position of CYCLE802 has one coordinate only");
		if (!drill_at(interp, a, b, x * scale, y * scale))
			return false;
	}
	return true;
}

bool sinumerik_pattern_run(struct interp *interp, const char *name, int column)
{
	const struct sinumerik *sinumerik = sinumerik_of(interp);
	const int plane = interp->state.plane;
	const enum axis_slot a = plane == G17 ? SLOT_X : plane == G18 ? SLOT_Z : SLOT_Y;
	const enum axis_slot b = plane == G17 ? SLOT_Y : plane == G18 ? SLOT_X : SLOT_Z;
	double n[6];

	if (sinumerik->modal.on && !sinumerik->modal.cycle)
		return fault(&interp->at, column, "%s with a modal subprogram is not supported yet, only with a cycle",
			     name);
	if (name[0] == 'C')
		return run_positions(interp, column, a, b);
	for (size_t i = 0; i < 6; i++)
		n[i] = i < sinumerik->argument_count && !isnan(sinumerik->arguments[i]) ? sinumerik->arguments[i] : 0;
	if (!(n[5] >= 1 && n[5] <= 9999) || floor(n[5]) < n[5])
		return fault(&interp->at, column, "%s needs a number of holes, NUM, from 1 to 9999", name);
	return name[5] == '1' ? run_row(interp, n, a, b) : run_ring(interp, n, a, b);
}
