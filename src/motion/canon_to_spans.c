#include "motion/canon_to_spans.h"

#include <assert.h>
#include <math.h>

#include "base/apart.h"
#include "base/units.h"
#include "motion/dogleg.h"
#include "motion/limits.h"
#include "motion/motion_modes.h"
#include "motion/move_bounds.h"
#include "motion/move_path.h"
#include "motion/timing.h"

/* mm: a move that deviates less from its chord needs few pieces. */
#define CURVED 1.0

static void take_tool(struct canon_to_spans *converter, int number)
{
	const struct tool *tool = converter->setup ? setup_tool(converter->setup, number) : NULL;

	converter->tool = number;
	converter->probes = tool && tool->kind == TOOL_PROBES;
	cutter_hand_init(&converter->hand, converter->setup, number);
	length_check_tool(&converter->length, converter->setup, number);
}

void canon_to_spans_init(struct canon_to_spans *converter, const struct machine *machine, const struct setup *setup,
			 double flatness, const struct motion_sink *sink, struct diag *diag, const char *name,
			 struct motion_summary *summary)
{
	*summary = (struct motion_summary){0};
	*converter = (struct canon_to_spans){.machine = machine,
					     .setup = setup,
					     .flatness = flatness,
					     .sink = sink,
					     .diag = diag,
					     .name = name,
					     .position = machine_home(machine),
					     .tells_steps = true,
					     .summary = summary};
	converter->controller = converter->position;
	axis_table_init(&converter->axes, machine);
	take_tool(converter, setup ? setup->initial_tool : 0);
}

/* Sends converter->event.of as an event of this kind. */
static bool send_event(struct canon_to_spans *converter, enum motion_event_kind kind)
{
	converter->event.kind = kind;
	return converter->sink->event(converter->sink->context, &converter->event);
}

/* -------------------------------------------------------------- one move */

/* The values that are the same for all steps of a move. */
struct run {
	struct canon_to_spans *converter;
	const struct canon_move *move;
	/* The converter's event: filled in place, because it is large and there are many. */
	struct motion_step *step;
	bool has_room;	/* the axes may be beside the path in a way that counts for the limits, by `room` */
	axis_values room;	/* if has_room: how far */
	bool turns;	/* a rotary axis may be beside its path */
	bool swings;	/* a rapid under TCP that is only known to stay in a box */
	axis_values swing;	/* if swings: how far the axes may be outside the box */
	struct leg guided;	/* such a rapid if the control keeps the tip on a line */
	size_t count;	/* of legs; 0: nothing moves */
	struct leg legs[SLOT_COUNT];
};

static bool is_countable(const struct run *run, const struct path *path)
{
	const struct canon_to_spans *converter = run->converter;

	return move_is_countable(run->move, path, converter->flatness, converter->diag, converter->name);
}

/*
 * How far each axis leaves the box between start and end if the control keeps the tip on a line after all: linear axes
 * then move to and fro while rotary ones turn. False: the move is too long, which was reported.
 */
static APART bool swing_out(struct run *run, const struct path *box)
{
	const struct canon_to_spans *converter = run->converter;
	struct path *guided = &run->guided.path;
	struct span piece;
	struct span_walk walk;

	run->swings = true;
	run->swing = (axis_values){{0}};
	guided->kind = PATH_TCP;
	guided->tcp = &converter->tcp;
	span_init(&run->guided.span, guided);
	if (!span_is_flat(&run->guided.span, CURVED) && !is_countable(run, guided))
		return false;
	span_walk_init(&walk, &run->guided.span, converter->flatness);
	while (span_walk_next(&walk, &piece)) {
		for (int slot = 0; slot < SLOT_COUNT; slot++) {
			const double low = fmin(piece.q0.v[slot], piece.q1.v[slot]) - piece.chord_error.v[slot];
			const double high = fmax(piece.q0.v[slot], piece.q1.v[slot]) + piece.chord_error.v[slot];
			const double below = fmin(box->start.v[slot], box->end.v[slot]) - low;
			const double above = high - fmax(box->start.v[slot], box->end.v[slot]);

			run->swing.v[slot] = fmax(run->swing.v[slot], fmax(below, above));
		}
	}
	return true;
}

/* Adds how far the axes may be beside the path of the move, because only a set of paths is known. */
static void add_spread(struct run *run)
{
	const struct machine *machine = run->converter->machine;
	const struct canon_move *move = run->move;
	axis_values spread = {{move->spread[0], move->spread[1], move->spread[2]}};

	/* Under TCP the spread is along X, Y and Z of the workpiece, which a table rotates. */
	if (move->tcp)
		spread = tcp_spread(&run->converter->tcp, &run->converter->position, &move->end, move->spread);
	for (size_t i = 0; i < machine->axis_count; i++) {
		const int slot = machine->axes[i].slot;

		if (slot > SLOT_Z || !(spread.v[slot] > 0))
			continue;
		run->step->tolerance.v[slot] += spread.v[slot];
		if (move->between[slot] && move->kind != CANON_ARC && !move->tcp)
			continue;
		run->room.v[slot] = spread.v[slot];
		run->has_room = true;
	}
}

/* The same for the rotary axes. Their effect on the linear axes under TCP is added when the path is known. */
static void add_turn_spread(struct run *run)
{
	const struct canon_move *move = run->move;

	for (int slot = SLOT_A; slot <= SLOT_C; slot++) {
		if (!(move->turn_spread[slot - SLOT_A] > 0))
			continue;
		run->step->tolerance.v[slot] += move->turn_spread[slot - SLOT_A];
		run->room.v[slot] += move->turn_spread[slot - SLOT_A];
		run->has_room = run->turns = true;
	}
}

static void add_following(struct run *run)
{
	const struct path *path = &run->legs[0].path;
	axis_values follow;

	if (!run->turns || !run->move->tcp)
		return;
	follow = tcp_follow(&run->converter->tcp, &path->start, &path->end, run->move->turn_spread);
	for (int slot = SLOT_X; slot <= SLOT_Z; slot++) {
		run->step->tolerance.v[slot] += follow.v[slot];
		run->room.v[slot] += follow.v[slot];
	}
}

/* The path has no length, but the axes may move: a leg that takes no time. */
static bool stand(struct run *run)
{
	struct leg *leg = &run->legs[0];
	const axis_values here = run->converter->position;

	leg->path = (struct path){.kind = PATH_STRAIGHT, .start = here, .end = here};
	span_init(&leg->span, &leg->path);
	run->count = 1;
	return true;
}

/* Each axis of a straight rapid moves at its own rate. */
static APART bool set_dogleg(struct run *run)
{
	struct path parts[SLOT_COUNT];

	run->count = dogleg_split(run->converter->machine, &run->legs[0].path, parts);
	for (size_t i = 0; i < run->count; i++) {
		run->legs[i].path = parts[i];
		span_init(&run->legs[i].span, &run->legs[i].path);
	}
	return true;
}

static bool set_legs(struct run *run)
{
	const struct canon_to_spans *converter = run->converter;
	const struct machine *machine = converter->machine;
	const struct canon_move *move = run->move;
	struct leg *leg = &run->legs[0];
	struct path *path = &leg->path;
	const struct move_start start = {
	    machine, &converter->tcp, &converter->position,
	    converter->controller_guided ? &converter->controller : NULL};
	double seconds = 0;

	run->count = 0;
	move_path_set(path, &start, move, &run->guided.path);
	if (!move_path_moves(path) && !(path->circular && path_length(path) > 0))
		return !run->has_room || stand(run);
	if (path->kind == PATH_STRAIGHT && move->kind == CANON_RAPID && machine->controller.rapid == RAPID_DOGLEG)
		return set_dogleg(run);
	if (path->kind == PATH_BOX && move->tcp && !swing_out(run, path))
		return false;
	span_init_from(&leg->span, &leg->path, &converter->position);
	if (!span_is_flat(&leg->span, CURVED) && !is_countable(run, path))
		return false;
	if (move->kind != CANON_RAPID)
		seconds = timing_programmed(path, &move->feed);
	leg->path.seconds = timing_held(&converter->axes, &leg->span, converter->flatness, seconds);
	run->count = 1;
	return move_is_bearable(move, leg->path.seconds, converter->diag, converter->name);
}

/* Is the move a rapid of several axes that is straight, in the axes or of the tip, only because the machine says so? */
static bool is_straight_rapid(const struct run *run)
{
	const struct path *path = &run->legs[0].path;

	return run->move->kind == CANON_RAPID && run->converter->machine->controller.rapid == RAPID_LINEAR &&
	       path->kind != PATH_BOX && move_path_axes(path) > 1;
}

static bool report_crossing(struct run *run, const struct path *path, double before,
			    const struct limit_crossing *crossing)
{
	const struct canon_to_spans *converter = run->converter;
	const struct canon_move *move = run->move;
	const double since = before + crossing->u * path->seconds;
	const int slot = crossing->slot;
	/* The converter's own event holds the step. */
	struct motion_event event = {.kind = MOTION_LIMIT};

	event.of.limit = (struct motion_limit){
	    .travel = {
		.slot = slot,
		.bound = crossing->bound,
		.target = run->legs[run->count - 1].span.q1.v[slot],
		.excess = crossing->excess,
		.path_tolerance = crossing->room,
		.work_offset = move->machine_coordinates ? NULL : move->origin->work_offset,
		.work = move->origin->work.v[slot],
		.shift = move->origin->shift.v[slot],
		.length_acts = slot == SLOT_Z || (move->tcp && !slot_is_rotary(slot)),
		.length = move->origin->length,
	    },
	    .position = path_position(path, crossing->u), .time = converter->time + since,
	    .block_time = converter->block_time + since, .file = move->file,
	    .line = move->line, .move = move->number, .tool = converter->tool};
	run->step->outside = true;
	return converter->sink->event(converter->sink->context, &event);
}

/* Reports the limits that a rapid passes if the control keeps the tip on a line, for axes without a report. */
static bool report_swing(struct run *run, const bool reported[SLOT_COUNT])
{
	struct limit_crossing crossings[SLOT_COUNT];
	size_t count;

	run->guided.path.seconds = run->legs[0].path.seconds;
	count = limits_crossed(run->converter->machine, &run->guided, 1, NULL, crossings);
	for (size_t i = 0; i < count; i++) {
		crossings[i].room = run->swing.v[crossings[i].slot];
		if (!reported[crossings[i].slot] && !report_crossing(run, &run->guided.path, 0, &crossings[i]))
			return false;
	}
	return true;
}

static APART bool report_limits(struct run *run, const axis_values *room)
{
	struct limit_crossing crossings[SLOT_COUNT];
	bool reported[SLOT_COUNT] = {false};
	size_t count;

	count = limits_crossed(run->converter->machine, run->legs, run->count, room, crossings);
	for (size_t i = 0; i < count; i++) {
		double before = 0;

		for (size_t k = 0; k < crossings[i].leg; k++)
			before += run->legs[k].path.seconds;
		reported[crossings[i].slot] = true;
		if (!report_crossing(run, &run->legs[crossings[i].leg].path, before, &crossings[i]))
			return false;
	}
	return !run->swings || report_swing(run, reported);
}

static bool check_limits(struct run *run)
{
	struct canon_to_spans *converter = run->converter;
	const axis_values *room = run->has_room ? &run->room : NULL;
	const bool straight = run->count == 1 && path_is_straight(&run->legs[0].path) && !room && !run->swings;

	/* A straight move between two positions inside the limits stays inside. */
	if (straight && converter->inside && limits_hold(&converter->axes, &run->legs[0].span.q1))
		return true;
	converter->inside = limits_kept(&converter->axes, run->legs, run->count, room);
	return (converter->inside && !run->swings) || report_limits(run, room);
}

/*
 * The duration of a step from `time` to `end`, where the next one begins. No instant of the step is later than that,
 * not even by the last bit: findings are sorted by time, and those of two steps must never change places.
 */
static double duration(double time, double end)
{
	double seconds = end - time;

	while (time + seconds > end)
		seconds = nextafter(seconds, 0);
	return seconds;
}

/* Sends the step, which is complete except for its times. */
static bool send_step(struct canon_to_spans *converter, double seconds)
{
	struct motion_step *step = &converter->event.of.step;

	step->time = converter->time + step->span.u0 * seconds;
	step->block_time = converter->block_time + step->span.u0 * seconds;
	step->seconds = duration(step->time, converter->time + step->span.u1 * seconds);
	converter->summary->spans++;
	return send_event(converter, MOTION_STEP);
}

static bool send_curved(struct canon_to_spans *converter, const struct leg *leg)
{
	struct span_walk walk;

	span_walk_init(&walk, &leg->span, converter->flatness);
	while (span_walk_next(&walk, &converter->event.of.step.span)) {
		if (!send_step(converter, leg->path.seconds))
			return false;
	}
	return true;
}

/* A probe move measures if it may end early, and if only a set of paths is known. */
static enum step_class class_of(const struct run *run)
{
	if (run->move->kind == CANON_RAPID)
		return STEP_RAPID;
	if (run->converter->probes)
		return run->step->bounded ? STEP_FEED_STANDING : STEP_PROBE_TRAVEL;
	if (!run->move->spindle_turns)
		return STEP_FEED_STANDING;
	return cutter_hand_reversed(&run->converter->hand, run->move) ? STEP_FEED_REVERSED : STEP_FEED_TURNING;
}

static bool send_steps(const struct run *run, const struct leg *leg)
{
	struct canon_to_spans *converter = run->converter;
	struct motion_step *step = run->step;

	step->file = run->move->file;
	step->line = run->move->line;
	step->move = run->move->number;
	step->tool = converter->tool;
	step->step_class = class_of(run);
	if (!span_is_flat(&leg->span, converter->flatness))
		return send_curved(converter, leg);
	step->span = leg->span;
	return send_step(converter, leg->path.seconds);
}

/* Sends the steps of the leg, then moves the clock and the axes to its end. */
static bool send_leg(const struct run *run, const struct leg *leg)
{
	struct canon_to_spans *converter = run->converter;
	double seconds = leg->path.seconds;

	if (!converter->tells_steps)
		converter->summary->spans += span_count(&leg->span, converter->flatness);
	else if (!send_steps(run, leg))
		return false;
	converter->time += seconds;
	converter->block_time += seconds;
	converter->position = leg->span.q1;
	converter->controller_guided = leg->path.kind == PATH_TCP;
	if (converter->controller_guided)
		converter->controller = leg->path.end;
	return true;
}

static bool carry_out(struct canon_to_spans *converter, const struct canon_move *move)
{
	struct run run;

	assert(!move->tcp || converter->tcp.state.on);
	run.converter = converter;
	run.move = move;
	run.step = &converter->event.of.step;
	run.step->outside = run.has_room = run.swings = run.turns = false;
	blend_take(&converter->blend, converter->machine, &converter->axes, move);
	run.step->tolerance = converter->blend.tolerance;
	run.step->bounded = canon_move_is_bounded(move);
	if (run.step->bounded) {
		run.room = (axis_values){{0}};
		add_spread(&run);
		add_turn_spread(&run);
	}
	if (!move_is_in_reach(move, converter->diag, converter->name) ||
	    (cutter_hand_is_asked(move) &&
	     !cutter_hand_ask(&converter->hand, converter->diag, move_place(move, converter->name))) ||
	    !set_legs(&run))
		return false;
	if (!run.count)
		return true;
	add_following(&run);
	for (int slot = 0; slot < SLOT_COUNT && run.swings; slot++)
		run.step->tolerance.v[slot] += run.swing.v[slot];
	length_check_move(&converter->length, converter->diag, move_place(move, converter->name), move);
	if (blend_is_unbounded(converter->machine, move))
		converter->summary->blend_unbounded = true;
	if (is_straight_rapid(&run))
		converter->summary->straight_rapids = true;
	converter->summary->moves++;
	if (!check_limits(&run))
		return false;
	for (size_t i = 0; i < run.count; i++)
		if (!send_leg(&run, &run.legs[i]))
			return false;
	return true;
}

/* ------------------------------------------------------------- canon_sink */

/* Reports the modes of this move if they differ from the last ones. */
static bool tell_modes(struct canon_to_spans *converter, const struct canon_move *move)
{
	const struct motion_modes modes = motion_modes_of(move);

	if (converter->modes_told && motion_modes_same(&modes, &converter->modes))
		return true;
	converter->modes_told = true;
	converter->event.of.modes = converter->modes = modes;
	return send_event(converter, MOTION_MODES);
}

static bool take_move(struct canon_to_spans *converter, const struct canon_move *move)
{
	bool ok = true;

	if (converter->tells_modes && move->kind <= CANON_ARC && !tell_modes(converter, move))
		return false;

	switch (move->kind) {
	case CANON_RAPID:
	case CANON_FEED:
	case CANON_ARC:
		ok = carry_out(converter, move);
		break;
	case CANON_DWELL:
		ok = move_is_bearable(move, move->seconds, converter->diag, converter->name);
		converter->time += ok ? move->seconds : 0;
		break;
	case CANON_TOOL_CHANGE:
		take_tool(converter, move->tool);
		converter->event.of.tool = (struct motion_tool){move->tool, converter->position};
		ok = send_event(converter, MOTION_TOOL);
		break;
	case CANON_SPINDLE_STOP:
		converter->event.of.spindle_stop =
		    (struct motion_spindle_stop){converter->position, converter->time, move->number};
		ok = send_event(converter, MOTION_SPINDLE_STOP);
		break;
	}
	converter->summary->seconds = converter->time;
	return ok;
}

static bool end_block(struct canon_to_spans *converter, const struct canon_block *block)
{
	converter->event.of.block = (struct motion_block){
		.file = block->file,
		.line = block->line,
		.text = block->text,
		.seconds = converter->block_time,
		.moves = block->moves,
		.callers = block->callers ? block->callers->calls : NULL,
		.caller_count = block->callers ? block->callers->count : 0,
	};
	converter->summary->blocks++;
	converter->summary->lines = block->lines;
	converter->block_time = 0;
	return send_event(converter, MOTION_BLOCK);
}

bool canon_to_spans_event(void *context, const struct canon_event *event)
{
	return event->kind == CANON_BLOCK ? end_block(context, event->of.block) : take_move(context, event->of.move);
}
