#include "motion/motion_kinematics.h"

#include "motion/great_circle.h"
#include "motion/orient.h"
#include "motion/retract.h"
#include "motion/table_point.h"

static bool switch_tcp(void *context, const struct kinematics_tcp *state, struct srcloc loc, axis_values *position)
{
	struct canon_to_spans *converter = context;

	if (state->on && !tcp_init(&converter->tcp, converter->machine, state, loc, converter->diag))
		return false;
	converter->tcp.state.on = state->on;
	converter->controller =
	    state->on ? tcp_from_machine(&converter->tcp, &converter->position) : converter->position;
	converter->controller_guided = state->on;
	*position = converter->controller;
	return true;
}

static bool orient(void *context, struct srcloc loc, struct kinematics_orientation *orientation)
{
	struct canon_to_spans *converter = context;

	return orient_tool(converter->machine, loc, converter->diag, orientation);
}

static bool orientations(void *context, struct srcloc loc, const struct kinematics_orientation *orientation,
			 struct kinematics_solutions *solutions)
{
	struct canon_to_spans *converter = context;

	return orient_solutions(converter->machine, loc, converter->diag, orientation, solutions);
}

/* In machine positions, whatever the program's positions mean now. */
static bool direction(void *context, struct srcloc loc, const axis_values *rotary_zero, const axis_values *rotary,
		      vec3 *found)
{
	struct canon_to_spans *converter = context;

	return great_circle_direction(converter->machine, loc, converter->diag, rotary_zero, rotary, found);
}

static bool find_turn(void *context, struct srcloc loc, struct kinematics_turn *found)
{
	struct canon_to_spans *converter = context;
	const struct kinematics_tcp state = {.on = true, .rotary_zero = found->rotary_zero};
	struct tcp tcp;

	if (!tcp_init(&tcp, converter->machine, &state, loc, converter->diag))
		return false;
	tcp_turn(&tcp, found);
	return true;
}

static bool great_circle(void *context, struct srcloc loc, struct kinematics_great_circle *piece)
{
	struct canon_to_spans *converter = context;

	return great_circle_piece(converter->machine, loc, converter->diag, piece);
}

static bool retract(void *context, struct srcloc loc, struct kinematics_retract *way)
{
	struct canon_to_spans *converter = context;
	const struct tcp *tcp = &converter->tcp;
	struct kinematics_retract machine = *way;

	machine.position = tcp->state.on ? tcp_to_machine(tcp, &way->position) : way->position;
	if (!retract_along_tool(converter->machine, loc, converter->diag, &machine))
		return false;
	way->position = tcp->state.on ? tcp_from_machine(tcp, &machine.position) : machine.position;
	return true;
}

static bool table_point(void *context, struct srcloc loc, axis_values *place)
{
	struct canon_to_spans *converter = context;

	return table_point_find(converter->machine, loc, converter->diag, place);
}

struct kinematics motion_kinematics(struct canon_to_spans *converter)
{
	return (struct kinematics){
	    .context = converter, .tcp = switch_tcp, .orient = orient, .orientations = orientations,
	    .direction = direction, .turn = find_turn, .great_circle = great_circle, .retract = retract,
	    .table_point = table_point};
}
