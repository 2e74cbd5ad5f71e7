#include "gcode/dialect/sinumerik/builder/sinumerik_builder.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "base/minmax.h"
#include "gcode/dialect/sinumerik/builder/sinumerik_cycle_refused.h"
#include "gcode/dialect/sinumerik/frames/sinumerik_frame.h"
#include "gcode/dialect/sinumerik/frames/sinumerik_open_place.h"
#include "gcode/execute/moves_around.h"
#include "gcode/execute/rotated_frame.h"

/* Auxiliary functions with larger numbers are treated as H, whose numbers have no limit. */
#define H_MAX 99999999.0

/* L9 and L009 are different programs: L009 is a name, and has no number. */
long sinumerik_builder_number(const char *name)
{
	const bool numbered = name[0] == 'L' && name[1] && name[1] != '0' &&
			      name[1 + strspn(name + 1, "0123456789")] == '\0';

	return numbered ? strtol(name + 1, NULL, 10) : 0;
}

/* "Measuring cycles": CYCLE961 to CYCLE998. */
static bool measures(const char *name)
{
	const size_t digits = !strncmp(name, "CYCLE", 5) ? strspn(name + 5, "0123456789") : 0;

	return digits == 3 && !name[8] && strcmp(name, "CYCLE960") > 0;
}

/*
 * After a milling cycle of Siemens the tool is above the milled region, and not where it was before the call.
 * action="around" cannot express this.
 */
static bool ends_elsewhere(const char *name)
{
	return sinumerik_cycle_refused(name) && !measures(name);
}

/* NULL: the machine file does not define it. */
static const struct builder_macro *find(const struct interp *interp, const char *name)
{
	const struct controller *controller = &interp->config->controller;
	const long number = sinumerik_builder_number(name);

	for (size_t i = 0; i < controller->macro_count && !ends_elsewhere(name); i++) {
		const struct builder_macro *macro = &controller->macros[i];

		if (macro->name ? !strcmp(macro->name, name) : number > 0 && macro->program == number)
			return macro;
	}
	return NULL;
}

bool sinumerik_builder_is_known(const struct interp *interp, const char *name)
{
	return find(interp, name) != NULL;
}

bool sinumerik_builder_does_nothing(const struct interp *interp, const char *name)
{
	const struct builder_macro *macro = find(interp, name);

	return macro && macro->action == MACRO_NONE;
}

/*
 * In rotated coordinates the program may move along their axes or along those of the machine: both boxes are covered.
 */
static bool go_around(struct interp *interp, const double around[3], int column)
{
	const vec3 x = rotated_frame_direction(&interp->state, (vec3){around[0], 0, 0});
	const vec3 y = rotated_frame_direction(&interp->state, (vec3){0, around[1], 0});
	const vec3 z = rotated_frame_direction(&interp->state, (vec3){0, 0, around[2]});
	const double both[3] = {larger(around[0], fabs(x.x) + fabs(y.x) + fabs(z.x)),
				larger(around[1], fabs(x.y) + fabs(y.y) + fabs(z.y)),
				larger(around[2], fabs(x.z) + fabs(y.z) + fabs(z.z))};

	return moves_around_go(interp, both, column);
}

bool sinumerik_builder_take_auxiliary(struct interp *interp, double value, int column)
{
	const bool whole = value >= 0 && value <= H_MAX && !(floor(value) < value);
	char name[16];

	if (whole)
		snprintf(name, sizeof(name), "H%.0f", value);
	else
		snprintf(name, sizeof(name), "H");
	if (sinumerik_builder_does_nothing(interp, name))
		return true;
	return fault(&interp->at, column,
		     "H%.9g: an auxiliary function of the machine's maker; if it moves no axis, set <macro "
		     "program=\"%s\" action=\"none\"/> in the machine file's <controller>",
		     value, name);
}

bool sinumerik_builder_refuse(struct interp *interp, const char *name, const char *what, int column)
{
	if (measures(name))
		return fault(&interp->at, column,
			     "%s: where a probe stops is not known before the program runs; if it stays near its "
			     "place, set <macro program=\"%s\" action=\"around\" X=\"\" Y=\"\" Z=\"\"/> in the "
			     "machine file's <controller> to say how far it moves",
			     name, name);
	return fault(&interp->at, column, "%s: %s is not supported; lines and circles (G1, G2, G3) can say its "
					  "moves",
		     name, what);
}

bool sinumerik_builder_run(struct interp *interp, const char *name, int column)
{
	const struct builder_macro *macro = find(interp, name);

	/* These cycles write offsets and tool data. */
	if (measures(name))
		caution(&interp->at, column,
			"%s: work offsets and tools count as the setup has them, whatever it measures", name);
	if (macro->action == MACRO_NONE)
		return true;
	if (macro->action == MACRO_MOVE)
		return fault(&interp->at, column,
			     "%s: <macro action=\"move\"/> is not supported in this dialect, only \"none\" and "
			     "\"around\"",
			     name);
	if (interp->state.tcp != TCP_OFF || interp->comp.side != 0 || !sinumerik_of(interp)->frames.even ||
	    (interp->state.frame.on && interp->state.frame.distorts))
		return fault(&interp->at, column,
			     "%s moves around its place while TRAORI or CYCLE800 is in force, coordinates are scaled "
			     "or the radius is compensated: that is not followed",
			     name);
	if (!sinumerik_open_place_check(interp, column, name) || !go_around(interp, macro->around, column))
		return false;
	sinumerik_frame_moved(interp);
	return true;
}
