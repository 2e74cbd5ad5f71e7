#include "motion/canon_to_spans.h"

#include <assert.h>
#include <math.h>

#include "base/apart.h"
#include "base/units.h"
#include "motion/dogleg.h"
#include "motion/limit_report.h"
#include "motion/limits.h"
#include "motion/motion_modes.h"
#include "motion/move_bounds.h"
#include "motion/move_path.h"
#include "motion/move_spread.h"
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
	struct move_spread spread;
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
		return !run->spread.acts || stand(run);
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

static APART bool report_limits(struct run *run, const axis_values *room)
{
	const struct canon_to_spans *converter = run->converter;
	const struct limit_report report = {.machine = converter->machine,
					    .move = run->move,
					    .legs = run->legs,
					    .leg_count = run->count,
					    .time = converter->time,
					    .block_time = converter->block_time,
					    .tool = converter->tool,
					    .sink = converter->sink};
	bool reported[SLOT_COUNT] = {false};

	if (!limit_report_legs(&report, room, reported))
		return false;
	if (run->swings) {
		run->guided.path.seconds = run->legs[0].path.seconds;
		if (!limit_report_guided(&report, &run->guided, &run->swing, reported))
			return false;
	}
	for (int slot = 0; slot < SLOT_COUNT; slot++)
		run->step->outside |= reported[slot];
	return true;
}

static bool check_limits(struct run *run)
{
	struct canon_to_spans *converter = run->converter;
	const axis_values *room = run->spread.acts ? &run->spread.room : NULL;
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
	run.step->outside = run.spread.acts = run.spread.turns = run.swings = false;
	blend_take(&converter->blend, converter->machine, &converter->axes, move);
	run.step->tolerance = converter->blend.tolerance;
	run.step->bounded = canon_move_is_bounded(move);
	if (run.step->bounded)
		move_spread_find(&run.spread, converter->machine, &converter->tcp, &converter->position, move,
				 &run.step->tolerance);
	if (!move_is_in_reach(move, converter->diag, converter->name) ||
	    (cutter_hand_is_asked(move) &&
	     !cutter_hand_ask(&converter->hand, converter->diag, move_place(move, converter->name))) ||
	    !set_legs(&run))
		return false;
	if (!run.count)
		return true;
	if (run.spread.turns && move->tcp)
		move_spread_follow(&run.spread, &converter->tcp, move, &run.legs[0].path, &run.step->tolerance);
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
