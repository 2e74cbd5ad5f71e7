#include "gcode/dialect/klartext/cycles/klartext_parameter.h"

#include <math.h>
#include <string.h>

#include "base/same_double.h"
#include "base/units.h"

/* ------------------------------------------------------------------- words */

bool klartext_parameter_find(const struct klartext_call_of *call, int q, double *value)
{
	char name[12] = "Q";
	int digits = q >= 100 ? 3 : q >= 10 ? 2 : 1;

	for (int i = digits; i > 0; i--, q /= 10)
		name[i] = (char)('0' + q % 10);
	name[digits + 1] = '\0';
	for (int i = call->cycle->count; i-- > 0;) {
		const struct klartext_cycle_word *word = &call->cycle->words[i];

		if (word->given && !strcmp(word->name, name)) {
			*value = word->value;
			return true;
		}
	}
	return false;
}

/* Finds a parameter that the cycle must have. False: reported. */
bool klartext_parameter_need(const struct klartext_call_of *call, int q, double *value)
{
	return klartext_parameter_find(call, q, value) ||
	       fault(&call->interp->at, call->column, "CYCL DEF %d lacks Q%d", call->cycle->number, q);
}

double klartext_parameter_or(const struct klartext_call_of *call, int q, double otherwise)
{
	double value;

	return klartext_parameter_find(call, q, &value) ? value : otherwise;
}

/* A length, in mm. */
bool klartext_parameter_length(const struct klartext_call_of *call, int q, double *value)
{
	if (!klartext_parameter_need(call, q, value))
		return false;
	*value *= call->interp->state.scale;
	return true;
}

double klartext_parameter_length_or(const struct klartext_call_of *call, int q, double otherwise)
{
	double value;

	return klartext_parameter_find(call, q, &value) ? value * call->interp->state.scale : otherwise;
}

/* Converts F, in mm/min or in tenths of an inch a minute, to mm/s. */
double klartext_parameter_per_second(const struct klartext_call_of *call, double feed)
{
	double scale = call->interp->state.scale;

	return feed * (scale > 1 ? scale / 10 : 1) / SECONDS_PER_MINUTE;
}

double klartext_parameter_part(const struct klartext_call_of *call, int part)
{
	for (int i = 0; i < call->cycle->count; i++) {
		if (call->cycle->words[i].part == part && call->cycle->words[i].given)
			return call->cycle->words[i].value;
	}
	return 0;
}

/* ------------------------------------------------------------------- feeds */

/*
 * A feed such as Q206. For 0 and for the feed of TOOL CALL (FAUTO) any feed that keeps the time finite serves, because
 * the path does not depend on it.
 */
bool klartext_parameter_feed(const struct klartext_call_of *call, int q, double *feed)
{
	double value;

	if (!klartext_parameter_need(call, q, &value))
		return false;
	if (value < 0)
		return fault(&call->interp->at, call->column, "Q%d of CYCL DEF %d: a feed rate cannot be negative", q,
			     call->cycle->number);
	*feed = klartext_parameter_per_second(call, value);
	return true;
}

bool klartext_parameter_heights(const struct klartext_call_of *call, struct klartext_heights *heights)
{
	double clearance, surface, depth, second;

	if (!klartext_parameter_length(call, 200, &clearance) || !klartext_parameter_length(call, 201, &depth) ||
	    !klartext_parameter_length(call, 203, &surface) || !klartext_parameter_length(call, 204, &second))
		return false;
	if (clearance < 0 || second < 0)
		return fault(&call->interp->at, call->column, "a set-up clearance (Q200, Q204) cannot be negative");
	if (depth > 0)
		return fault(&call->interp->at, call->column,
			     "Q201=%g: what a depth above the surface does depends on a machine parameter", depth);
	*heights = (struct klartext_heights){.start = surface + clearance,
					     .bottom = surface + depth,
					     .clear = surface + fmax(second, clearance),
					     .clearance = clearance,
					     .nothing = same_double(depth, 0)};
	return true;
}
