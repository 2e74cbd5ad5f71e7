#include "cli/scan/any_machine.h"

#include <math.h>

#include "gcode/interp.h"
#include "gcode/kinematics.h"
#include "geom/tolerance.h"
#include "geom/xform.h"

static bool count_blocks(void *context, const struct canon_event *event)
{
	long *blocks = context;

	*blocks += event->kind == CANON_BLOCK;
	return true;
}

/* A machine that can do everything that is requested; its answers appear in no report. */
static bool switch_tcp(void *context, const struct kinematics_tcp *tcp, struct srcloc loc, axis_values *position)
{
	(void)context;
	(void)tcp;
	(void)loc;
	(void)position;
	return true;
}

static bool orient(void *context, struct srcloc loc, struct kinematics_orientation *orientation)
{
	(void)context;
	(void)loc;
	(void)orientation;
	return true;
}

static bool orientations(void *context, struct srcloc loc, const struct kinematics_orientation *orientation,
			 struct kinematics_solutions *solutions)
{
	(void)context;
	(void)loc;
	*solutions = (struct kinematics_solutions){.count = 1, .primary = SLOT_A};
	solutions->items[0].rotary = orientation->rotary;
	solutions->items[0].within_limits = true;
	/* On most machines an upright tool points along C: the machine file must say what the control then does. */
	solutions->items[0].free[SLOT_C] =
	    fabs(orientation->direction.x) + fabs(orientation->direction.y) <= DIRECTION_REACHED;
	return true;
}

static bool direction(void *context, struct srcloc loc, const axis_values *rotary_zero, const axis_values *rotary,
		      vec3 *found)
{
	(void)context;
	(void)loc;
	(void)rotary_zero;
	(void)rotary;
	*found = (vec3){0, 0, 1};
	return true;
}

static bool find_turn(void *context, struct srcloc loc, struct kinematics_turn *found)
{
	(void)context;
	(void)loc;
	found->turn = mat3_turn((vec3){0, 0, 1}, found->rotary.v[SLOT_C] - found->rotary_zero.v[SLOT_C]);
	found->tool = (vec3){0, 0, 1};
	return true;
}

static bool great_circle(void *context, struct srcloc loc, struct kinematics_great_circle *piece)
{
	(void)context;
	(void)loc;
	for (int slot = 0; slot < SLOT_COUNT; slot++)
		piece->beside[slot] = 0;
	return true;
}

static bool retract(void *context, struct srcloc loc, struct kinematics_retract *move)
{
	(void)context;
	(void)loc;
	(void)move;
	return true;
}

static bool table_point(void *context, struct srcloc loc, axis_values *place)
{
	(void)context;
	(void)loc;
	(void)place;
	return true;
}

bool any_machine_read(const struct gcode_config *config, FILE *in, const char *name, struct diag *diag)
{
	static const struct kinematics kinematics = {
	    .tcp = switch_tcp, .orient = orient, .orientations = orientations, .direction = direction,
	    .turn = find_turn, .great_circle = great_circle, .retract = retract, .table_point = table_point};
	long blocks = 0;
	const struct canon_sink sink = {&blocks, count_blocks};
	struct interp *interp;
	bool good;

	rewind(in);
	interp = interp_new(config, &kinematics, &sink, diag);
	good = interp_run(interp, in, name);
	interp_free(interp);
	if (good && !blocks)
		diag_error(diag, (struct srcloc){name, 0, 0}, INTERP_NO_BLOCK);
	return good && blocks > 0;
}
