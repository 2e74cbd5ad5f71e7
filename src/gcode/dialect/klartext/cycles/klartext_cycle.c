#include "gcode/dialect/klartext/cycles/klartext_cycle.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "base/math/math_functions.h"
#include "base/same_double.h"
#include "base/units.h"
#include "gcode/dialect/klartext/cycles/klartext_contour.h"
#include "gcode/dialect/klartext/cycles/klartext_hole.h"
#include "gcode/dialect/klartext/cycles/klartext_parameter.h"
#include "gcode/dialect/klartext/cycles/klartext_pocket.h"
#include "gcode/dialect/klartext/flow/klartext_builder_cycle.h"
#include "gcode/dialect/klartext/flow/klartext_flow.h"
#include "gcode/dialect/klartext/frames/klartext_frame.h"
#include "gcode/dialect/klartext/frames/klartext_preset.h"
#include "gcode/dialect/klartext/moves/klartext_comp.h"
#include "gcode/dialect/klartext/planes/klartext_orient.h"
#include "gcode/dialect/klartext/values/klartext_value.h"
#include "gcode/execute/motion_commands.h"
#include "gcode/execute/tool_table.h"

/* A larger number of pecks is a typing mistake, and the program would seem to hang. */
#define PECKS_MAX 100000

/* The feed of a tap: the pitch times the spindle speed. */
static double tap_feed(const struct klartext_call_of *call, double pitch)
{
	const struct state *state = &call->interp->state;

	return motion_commands_thread_feed(call->interp, call->column,
					   fabs(pitch) * state->scale * state->speed / SECONDS_PER_MINUTE);
}

/* ------------------------------------------------------------------ heights */

static bool find_heights(const struct klartext_call_of *call, struct klartext_hole *hole)
{
	struct klartext_heights heights;

	if (!klartext_parameter_heights(call, &heights))
		return false;
	hole->start = heights.start;
	hole->bottom = heights.bottom;
	hole->clear = heights.clear;
	hole->clearance = heights.clearance;
	hole->nothing = heights.nothing;
	return true;
}

/*
 * The height of the tool's point below the place where the tool has this diameter; parameter Q<q> needs it. False:
 * reported.
 */
static bool find_point_height(const struct klartext_call_of *call, int q, double diameter, double *height)
{
	const struct interp *interp = call->interp;
	const struct tool *tool = tool_table_find(&interp->tools, interp->state.tool);

	if (!tool || !(tool->point_angle > 0))
		return fault(&interp->at, call->column,
			     "Q%d=1 needs the point angle of the tool: give the tool of the setup a <cutter> with "
			     "tip=\"cone\" and its angle, or write Q%d=0 and the depth of the tip in Q201",
			     q, q);
	*height = diameter / 2 / math_tan(tool->point_angle / 2);
	return true;
}

/*
 * "CENTERING (Cycle 240)": Q343=1 selects the diameter Q344 in place of the depth Q201. Q344 has the sign of a depth.
 */
static bool centre_by_diameter(const struct klartext_call_of *call, struct klartext_hole *hole)
{
	double diameter, depth;

	if (!klartext_parameter_length(call, 344, &diameter))
		return false;
	if (diameter > 0)
		return fault(&call->interp->at, call->column,
			     "Q344=%g: what a depth above the surface does depends on a machine parameter; a diameter "
			     "below it is negative",
			     diameter);
	if (!find_point_height(call, 343, -diameter, &depth))
		return false;
	hole->bottom = hole->start - hole->clearance - depth;
	hole->nothing = same_double(depth, 0);
	return true;
}

/* "DEPTH REFERENCE": with Q395=1 the full diameter reaches the depth, and the tip goes deeper. */
static bool go_by_full_diameter(const struct klartext_call_of *call, struct klartext_hole *hole)
{
	const struct interp *interp = call->interp;
	const struct tool *tool = tool_table_find(&interp->tools, interp->state.tool);
	double height;

	if (same_double(klartext_parameter_or(call, 395, 0), 0))
		return true;
	if (!find_point_height(call, 395, tool ? tool->diameter : 0, &height))
		return false;
	hole->bottom -= height;
	return true;
}

/* Q202: the first peck; Q212: how much smaller each further peck is; Q205: the smallest peck. */
static bool find_pecks(const struct klartext_call_of *call, struct klartext_hole *hole)
{
	double depth = hole->start - hole->bottom;

	if (!klartext_parameter_length(call, 202, &hole->peck))
		return false;
	if (hole->peck < 0)
		return fault(&call->interp->at, call->column, "Q202: a peck cannot be negative");
	hole->less = fmax(0, klartext_parameter_length_or(call, 212, 0));
	hole->least = fmax(0, klartext_parameter_length_or(call, 205, 0));
	/* 0: the control divides the depth itself; the tool stays on this line in any case. */
	if (!(hole->peck > 0))
		hole->peck = depth;
	if (depth / hole->peck > PECKS_MAX)
		return fault(&call->interp->at, call->column, "Q202: more than %d pecks", PECKS_MAX);
	if (hole->less > 0 && !(hole->least > 0))
		hole->least = hole->peck / 100;
	return true;
}

static bool find_dwell(const struct klartext_call_of *call, int q, double *seconds)
{
	*seconds = klartext_parameter_or(call, q, 0);
	return *seconds >= 0 || fault(&call->interp->at, call->column, "Q%d: a dwell cannot be negative", q);
}

/* -------------------------------------------------------------- the cycles */

/* 200, 203, 205, 240: drilling, with pecks. */
static bool drill(const struct klartext_call_of *call, struct klartext_hole *hole)
{
	int number = call->cycle->number;

	if (!klartext_parameter_feed(call, 206, &hole->feed) || !find_dwell(call, 211, &hole->dwell))
		return false;
	if (number == 240) {
		return same_double(klartext_parameter_or(call, 343, 0), 0) || centre_by_diameter(call, hole);
	}
	if (!find_pecks(call, hole))
		return false;
	hole->chip_breaks = number == 203 ? (int)fmin(PECKS_MAX, fmax(0, klartext_parameter_or(call, 213, 0))) : 0;
	hole->break_way = klartext_parameter_length_or(call, 256, 0);
	if (number == 205)
		hole->start = fmax(hole->bottom, hole->start + fmin(0, klartext_parameter_length_or(call, 379, 0)));
	return true;
}

/*
 * 201: down, then up at the feed Q208, or at the feed of the way down if Q208 is 0. 202: the same, with a shift aside
 * at the bottom.
 */
static bool ream(const struct klartext_call_of *call, struct klartext_hole *hole)
{
	double direction = klartext_parameter_or(call, 214, 0);

	if (!klartext_parameter_feed(call, 206, &hole->feed) || !find_dwell(call, 211, &hole->dwell))
		return false;
	hole->out = klartext_parameter_per_second(call, fmax(0, klartext_parameter_or(call, 208, 0)));
	hole->out = hole->out > 0 ? hole->out : hole->feed;
	if (call->cycle->number != 202 || same_double(direction, 0))
		return true;
	if (!(direction >= 1 && direction <= 4) || !same_double(floor(direction), direction))
		return fault(&call->interp->at, call->column, "Q214 is a whole number from 0 to 4");
	/* "BORING (Cycle 202)": 0.2 mm in X-, Y-, X+ or Y+. */
	hole->aside_x = same_double(direction, 1) ? -0.2 : same_double(direction, 3) ? 0.2 : 0;
	hole->aside_y = same_double(direction, 2) ? -0.2 : same_double(direction, 4) ? 0.2 : 0;
	return true;
}

/* 206: tapping with a floating holder; 207, 209: without one. The tool leaves the hole at the feed. */
static bool tap(const struct klartext_call_of *call, struct klartext_hole *hole)
{
	double pitch;

	hole->turns = true;
	if (!find_dwell(call, 211, &hole->dwell))
		return false;
	if (call->cycle->number == 206) {
		if (!klartext_parameter_feed(call, 206, &hole->feed))
			return false;
	} else {
		if (!klartext_parameter_need(call, 239, &pitch))
			return false;
		hole->feed = tap_feed(call, pitch);
	}
	hole->out = hole->feed;
	return true;
}

/* 241: single-lip deep-hole drilling: to the starting point at Q253, to the bottom, back at Q208. */
static bool drill_deep(const struct klartext_call_of *call, struct klartext_hole *hole)
{
	if (!klartext_parameter_feed(call, 206, &hole->feed) || !find_dwell(call, 211, &hole->dwell))
		return false;
	hole->out = klartext_parameter_per_second(call, fmax(0, klartext_parameter_or(call, 208, 0)));
	hole->out = hole->out > 0 ? hole->out : hole->feed;
	return true;
}

static bool by_q(const struct klartext_call_of *call)
{
	static const struct {
		int number;
		bool (*find)(const struct klartext_call_of *call, struct klartext_hole *hole);
	} cycles[] = {{200, drill}, {201, ream}, {202, ream}, {203, drill}, {205, drill},
		      {206, tap},   {207, tap},	 {209, tap},  {240, drill}, {241, drill_deep}};
	struct klartext_hole hole = {0};

	if (klartext_contour_is(call->cycle->number))
		return klartext_contour_make(call);
	if (klartext_pocket_is(call->cycle->number))
		return klartext_pocket_make(call);
	if (!find_heights(call, &hole) || !go_by_full_diameter(call, &hole))
		return false;
	for (size_t i = 0; i < sizeof(cycles) / sizeof(cycles[0]); i++) {
		if (cycles[i].number == call->cycle->number)
			return cycles[i].find(call, &hole) && klartext_hole_make(call->interp, &hole, call->column);
	}
	return fault(&call->interp->at, call->column, "CYCL DEF %d is not supported", call->cycle->number);
}

/*
 * TNC 415/425 user's manual, "PECKING (Cycle 1)", "TAPPING (Cycle 2)", "RIGID TAPPING (Cycle 17)": the cycle is called
 * with the tool at the set-up clearance above the surface, and the tool returns there. Lines of cycle 1: set-up, depth,
 * peck, dwell, F; of cycle 2: set-up, depth, dwell, F; of cycle 17: set-up, depth, pitch.
 */
static bool by_parts(const struct klartext_call_of *call)
{
	struct interp *interp = call->interp;
	int number = call->cycle->number;
	double scale = interp->state.scale, set_up = klartext_parameter_part(call, 1) * scale,
	       depth = klartext_parameter_part(call, 2) * scale;
	struct klartext_hole hole = {.start = klartext_frame_point(interp).z, .clearance = fabs(set_up)};

	/* On the oldest controls every value has the sign of the direction of work. */
	const bool all_down = set_up < 0 && depth < 0;

	if (set_up < 0 && !all_down)
		return fault(&interp->at, call->column, "the set-up clearance of CYCL DEF %d cannot be negative",
			     number);
	if (depth > 0)
		return fault(&interp->at, call->column, "the depth of CYCL DEF %d is above the surface", number);
	hole.clear = hole.start;
	hole.bottom = hole.start - fabs(set_up) + depth;
	hole.nothing = same_double(depth, 0);
	hole.dwell = fmax(0, klartext_parameter_part(call, number == 1 ? 4 : 3));
	hole.feed = klartext_parameter_per_second(call, klartext_parameter_part(call, number == 1 ? 5 : 4));
	if (number == 1) {
		hole.peck = klartext_parameter_part(call, 3) * scale * (all_down ? -1 : 1);
		if (hole.peck < 0 || (hole.start - hole.bottom) / hole.peck > PECKS_MAX)
			hole.peck = 0;
		return klartext_hole_make(interp, &hole, call->column);
	}
	hole.turns = true;
	if (number == 17) {
		hole.dwell = 0;
		hole.feed = tap_feed(call, klartext_parameter_part(call, 3));
	}
	hole.out = hole.feed;
	return klartext_hole_make(interp, &hole, call->column);
}

/* --------------------------------------------------------------------- calls */

/*
 * CYCL DEF assigns the parameters of the cycle, and the program may change them later. The manuals do not say whether
 * the call uses the changed values. The parameters in `but` are not checked.
 */
static bool check_values(struct interp *interp, int column, const struct klartext_cycle *cycle, const char *const *but)
{
	for (int i = 0; cycle->by_q && i < cycle->count; i++) {
		const struct klartext_cycle_word *word = &cycle->words[i];
		const char *const *left_out = but;
		double value;

		while (*left_out && strcmp(*left_out, word->name) != 0)
			left_out++;
		if (*left_out || !word->given)
			continue;
		if (!klartext_q_get(klartext_of(interp), (int)strtol(word->name + 1, NULL, 10), &value) ||
		    !same_double(value, word->value))
			return fault(
			    &interp->at, column,
			    "%s has been changed since CYCL DEF %d: whether the call takes its new value is not "
			    "known here; define the cycle anew",
			    word->name, cycle->number);
	}
	return true;
}

bool klartext_cycle_check_values(struct interp *interp, int column, bool heights)
{
	/* Dwells do not change the path; the pattern gives the heights. */
	static const char *const all[] = {"Q210", "Q211", NULL};
	static const char *const but_heights[] = {"Q200", "Q203", "Q204", "Q210", "Q211", NULL};

	const struct klartext *klartext = klartext_of(interp);

	if (klartext_contour_is(klartext->cycles.active.number) &&
	    !check_values(interp, column, &klartext->contour.data, all))
		return false;
	return check_values(interp, column, &klartext->cycles.active, heights ? all : but_heights);
}

bool klartext_cycle_call(struct interp *interp, int column)
{
	return klartext_cycle_check_values(interp, column, true) && klartext_cycle_carry_out(interp, column);
}

void klartext_cycle_set(struct klartext_cycle *cycle, const char *name, double value)
{
	for (int i = 0; i < cycle->count; i++) {
		if (!strcmp(cycle->words[i].name, name)) {
			cycle->words[i].value = value;
			return;
		}
	}
	if (cycle->count == KLARTEXT_CYCLE_WORDS)
		return;
	cycle->words[cycle->count] = (struct klartext_cycle_word){.value = value, .given = true};
	snprintf(cycle->words[cycle->count].name, sizeof(cycle->words[0].name), "%s", name);
	cycle->count++;
}

bool klartext_cycle_call_shifted(struct interp *interp, int column, double shift)
{
	struct klartext_cycles *cycles = &klartext_of(interp)->cycles;
	const struct klartext_cycle defined = cycles->active;
	const struct klartext_call_of call = {.interp = interp, .cycle = &defined, .column = column};
	double surface;
	bool good;

	if (!klartext_cycle_check_values(interp, column, true))
		return false;
	if (same_double(shift, 0))
		return klartext_cycle_carry_out(interp, column);
	if (!defined.by_q || !klartext_parameter_find(&call, 203, &surface))
		return fault(&interp->at, column,
			     "a Z other than 0 in CYCL CALL POS shifts the cycle: of a cycle without Q203 that is "
			     "not supported");
	klartext_cycle_set(&cycles->active, "Q203", surface + shift / interp->state.scale);
	good = klartext_cycle_carry_out(interp, column);
	cycles->active = defined;
	return good;
}

/*
 * "PROGRAM CALL (Cycle 12)": calls the program, which runs from the next line on. M89 is refused because M-functions at
 * the end of a block would take effect before the program, and because every move of the program would call it again.
 */
static bool call_program(struct interp *interp, int column)
{
	const char *name = klartext_of(interp)->cycles.program;

	if (klartext_of(interp)->cycles.modal)
		return fault(&interp->at, column,
			     "M89 with CYCL DEF 12 (a program after every move) is not supported; write M99 into each "
			     "block that calls the program");
	return name[0] != '\0' ? klartext_flow_call_program(interp, name, column)
			       : fault(&interp->at, column, "CYCL DEF 12 has not named a program");
}

/* A cycle works along Z. The manuals do not say what the control does if M128 has turned the tool away from Z. */
static bool check_along_z(struct interp *interp, int column)
{
	bool along = true;

	if (interp->state.tcp == TCP_BY_MCODE && !klartext_orient_along_z(interp, column, &along))
		return false;
	return along ||
	       fault(&interp->at, column,
		     "a cycle while M128 is in force and the tool does not lie along Z is not supported; write "
		     "PLANE in place of M128");
}

bool klartext_cycle_carry_out(struct interp *interp, int column)
{
	struct klartext *klartext = klartext_of(interp);
	const struct klartext_call_of call = {.interp = interp, .cycle = &klartext->cycles.active, .column = column};

	if (klartext->cycles.active.number == 0)
		return fault(&interp->at, column, "no cycle has been defined that could be called");
	if (klartext->cycles.active.refused)
		return true;
	if (klartext_comp_is_selected(interp))
		return fault(&interp->at, column, "a cycle under radius compensation is not supported; R0 comes first");
	if (!check_along_z(interp, column))
		return false;
	if (klartext->stay.waits)
		return fault(&interp->at, column,
			     "a cycle before the rotary axes stand where PLANE ... STAY needs them");
	if (!klartext_preset_check_plane(interp, column) ||
	    !klartext_frame_check_shift(interp, 1U << SLOT_X | 1U << SLOT_Y | 1U << SLOT_Z, column))
		return false;
	if (klartext->corner.waits)
		return fault(&interp->at, column, "RND and CHF need a straight line behind them");
	klartext->last.known = false;
	if (klartext->cycles.active.number == 12)
		return call_program(interp, column);
	klartext->tool.moved = true;
	if (klartext_builder_cycle_is_called(klartext->cycles.active.number))
		return klartext_builder_cycle_run(interp, &klartext->cycles.active);
	if (klartext->cycles.active.by_q)
		return by_q(&call);
	return klartext->cycles.active.number >= 3 && klartext->cycles.active.number <= 5
		   ? klartext_pocket_make_old(&call)
		   : by_parts(&call);
}

bool klartext_cycle_start(struct interp *interp, double *height)
{
	const struct klartext_call_of call = {.interp = interp, .cycle = &klartext_of(interp)->cycles.active};
	double clearance, surface;

	if (!call.cycle->by_q || !klartext_parameter_find(&call, 200, &clearance) ||
	    !klartext_parameter_find(&call, 203, &surface))
		return false;
	*height = (clearance + surface) * interp->state.scale;
	return true;
}

bool klartext_cycle_call_modal(struct interp *interp, const struct klartext_words *words, bool moves)
{
	struct klartext_cycles *cycles = &klartext_of(interp)->cycles;
	const struct klartext_m *m = words->m_count ? klartext_words_m(words, 99) : NULL;

	if (!cycles->modal)
		return true;
	/* The block with M99 is the last one. */
	if (m) {
		cycles->modal = false;
		return true;
	}
	return !moves || klartext_cycle_call(interp, words->first_column);
}
