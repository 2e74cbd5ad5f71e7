#include "gcode/dialect/sinumerik/cycles/sinumerik_pattern.h"

#include <math.h>
#include <stdint.h>
#include <string.h>

#include "base/same_double.h"
#include "base/units.h"
#include "gcode/dialect/sinumerik/cycles/sinumerik_argument.h"
#include "gcode/dialect/sinumerik/cycles/sinumerik_cycle.h"
#include "gcode/dialect/sinumerik/cycles/sinumerik_region.h"
#include "gcode/dialect/sinumerik/flow/sinumerik_call.h"
#include "gcode/dialect/sinumerik/flow/sinumerik_save.h"
#include "gcode/dialect/sinumerik/frames/sinumerik_frame.h"
#include "gcode/dialect/sinumerik/frames/sinumerik_open_place.h"
#include "gcode/dialect/sinumerik/path/sinumerik_move.h"
#include "gcode/dialect/sinumerik/path/sinumerik_target.h"

/* The maximum number of positions of one CYCLE802. */
#define POSITIONS 9

/* The maximum number of holes of a pattern, or of one side of a grid. */
#define HOLES_MAX 9999

struct pattern {
	struct sinumerik_arguments of;
	enum axis_slot a, b;	/* the plane */
	const slot_values *from;	/* the place of the tool before the pattern, program coordinates */
	struct sinumerik_pattern *left;	/* `done` holes of it are skipped */
	long holes;	/* holes reached so far */
	bool called;	/* a subprogram runs at the last hole; the other holes wait */
};

static double value(const struct pattern *p, size_t i)
{
	return sinumerik_argument_or(&p->of, i, 0);
}

static double length(const struct pattern *p, size_t i)
{
	return sinumerik_argument_length(&p->of, i);
}

bool sinumerik_pattern_modal(struct interp *interp)
{
	const struct sinumerik_modal *modal = &sinumerik_of(interp)->modal;

	if (!modal->cycle)
		return sinumerik_call_modal(interp);
	return sinumerik_region_is(modal->name)
		   ? sinumerik_region_mill_here(interp, modal->name, modal->arguments, modal->argument_count, 1)
		   : sinumerik_cycle_drill(interp, modal->name, modal->arguments, modal->argument_count, 1);
}

/*
 * A subprogram that starts at the hole returns to the line of the pattern. A program that the machine file defines is
 * already complete.
 */
static bool call_at(struct pattern *p)
{
	struct sinumerik *sinumerik = sinumerik_of(p->of.interp);

	if (!sinumerik_pattern_modal(p->of.interp))
		return false;
	p->called = sinumerik->calls.depth > p->left->depth;
	if (p->called)
		sinumerik->calls.items[sinumerik->calls.depth - 1].back = p->left->line;
	return true;
}

static bool drill_at(struct pattern *p, double at_a, double at_b)
{
	struct interp *interp = p->of.interp;
	slot_values target = *sinumerik_frame_place(interp);

	if (p->called || p->holes++ < p->left->done)
		return true;
	p->left->done = p->holes;
	target.v[p->a] = at_a;
	target.v[p->b] = at_b;
	/* Without a modal cycle the tool only moves there. */
	if (!sinumerik_move_to(interp, &target, true))
		return false;
	/* Both axes of the plane have been commanded. */
	sinumerik_open_place_settle(interp, letter_bit(AXIS_LETTERS[p->a]) | letter_bit(AXIS_LETTERS[p->b]));
	return !sinumerik_of(interp)->modal.on || call_at(p);
}

static bool count(const struct pattern *p, size_t i, const char *name, int *holes)
{
	const double number = fabs(value(p, i));

	if (!(number >= 1 && number <= HOLES_MAX) || floor(number) < number)
		return fault(&p->of.interp->at, p->of.column, "%s needs a number of holes, %s, from 1 to %d",
			     p->of.cycle, name, HOLES_MAX);
	*holes = (int)number;
	return true;
}

/*
 * HOLES1(SPCA, SPCO, STA1, FDIS, DBH, NUM): a row of holes. The control begins at the end that is nearer to the tool.
 */
static bool run_row(struct pattern *p)
{
	const double c = math_cos_degrees(value(p, 2)), s = math_sin_degrees(value(p, 2));
	const slot_values *place = p->from;
	const double along = (place->v[p->a] - length(p, 0)) * c + (place->v[p->b] - length(p, 1)) * s;
	const double first = fabs(length(p, 3)), step = fabs(length(p, 4));
	bool backward;
	int holes;

	if (!count(p, 5, "NUM", &holes))
		return false;
	backward = fabs(along - first - (holes - 1) * step) < fabs(along - first);
	for (int i = 0; i < holes; i++) {
		const double at = first + (backward ? holes - 1 - i : i) * step;

		if (!drill_at(p, length(p, 0) + at * c, length(p, 1) + at * s))
			return false;
	}
	return true;
}

/*
 * HOLES2(CPA, CPO, RAD, STA1, INDA, NUM, _VARI): a circle of holes; INDA=0 divides the full circle. _VARI: with the
 * tens the tool moves from hole to hole on the circle; thousands: 1 full circle, 2 by INDA.
 */
static bool run_ring(struct pattern *p)
{
	const double radius = fabs(length(p, 2));
	double step = value(p, 4);
	int holes;

	if (!count(p, 5, "NUM", &holes))
		return false;
	if (sinumerik_argument_digit(&p->of, 6, 1) == 1)
		return fault(&p->of.interp->at, p->of.column,
			     "HOLES2 whose holes are approached on a circle (the tens of _VARI) is not supported");
	if (!(fabs(step) > 0) || sinumerik_argument_digit(&p->of, 6, 3) == 1)
		step = 360.0 / holes;
	for (int i = 0; i < holes; i++) {
		const double angle = value(p, 3) + i * step;

		if (!drill_at(p, length(p, 0) + radius * math_cos_degrees(angle),
			      length(p, 1) + radius * math_sin_degrees(angle)))
			return false;
	}
	return true;
}

/*
 * CYCLE801(_SPCA, _SPCO, _STA, _DIS1, _DIS2, _NUM1, _NUM2, _VARI, , _ANG1, _ANG2): a grid, rotated by _STA. The tool
 * moves to and fro along the side with the smaller distance. It begins at the corner in whose quarter it is.
 */
static bool run_grid(struct pattern *p)
{
	const double c = math_cos_degrees(value(p, 2)), s = math_sin_degrees(value(p, 2));
	const slot_values *place = p->from;
	const double a = place->v[p->a] - length(p, 0), b = place->v[p->b] - length(p, 1);
	const double here[2] = {a * c + b * s, b * c - a * s};
	const double step[2] = {fabs(length(p, 3)), fabs(length(p, 4))};
	const int row = step[0] <= step[1] ? 0 : 1;
	bool back[2];
	int holes[2];

	if (!count(p, 5, "_NUM1", &holes[0]) || !count(p, 6, "_NUM2", &holes[1]))
		return false;
	if (sinumerik_argument_digit(&p->of, 7, 0) == 1)
		return fault(&p->of.interp->at, p->of.column,
			     "CYCLE801 as a frame of holes (the units of _VARI) is not supported: in which order the "
			     "control goes is not known");
	if (sinumerik_argument_counts(&p->of, 9) || sinumerik_argument_counts(&p->of, 10))
		return fault(&p->of.interp->at, p->of.column,
			     "CYCLE801 as a parallelogram (_ANG1, _ANG2) is not supported");
	for (int i = 0; i < 2; i++)
		back[i] = (holes[i] - 1) * step[i] / 2 < here[i];
	for (int i = 0; i < holes[!row] * holes[row]; i++) {
		const int line = i / holes[row], along = i % holes[row];
		const bool returns = (line % 2 == 1) != back[row];
		double at[2];

		at[row] = (returns ? holes[row] - 1 - along : along) * step[row];
		at[!row] = (back[!row] ? holes[!row] - 1 - line : line) * step[!row];
		if (!drill_at(p, length(p, 0) + at[0] * c - at[1] * s, length(p, 1) + at[0] * s + at[1] * c))
			return false;
	}
	return true;
}

/*
 * CYCLE802(XA, YA, X0, Y0, X1, Y1, ...): up to nine positions, in their order. XA and YA have a digit for each
 * position; 1 means absolute.
 */
static bool run_positions(struct pattern *p)
{
	const double all_absolute = 111111111;

	for (size_t i = 0; i < 2; i++) {
		if (fabs(sinumerik_argument_or(&p->of, i, all_absolute) - all_absolute) > 0)
			return fault(
			    &p->of.interp->at, p->of.column,
			    "CYCLE802 with positions that are not all absolute (its first two arguments must be "
			    "111111111) is not supported");
	}
	for (size_t i = 2; i < 2 + 2 * POSITIONS; i += 2) {
		const bool x = sinumerik_argument_given(&p->of, i), y = sinumerik_argument_given(&p->of, i + 1);

		if (!x && !y)
			break;
		if (!x || !y)
			return fault(&p->of.interp->at, p->of.column,
				     "a position of CYCLE802 has one coordinate only");
		if (!drill_at(p, length(p, i), length(p, i + 1)))
			return false;
	}
	return true;
}

/* The indices of _HIDE, which skips holes, and of _DMODE; 0: there is none. */
static const struct {
	const char *name;
	bool (*run)(struct pattern *p);
	size_t hide, display;
} patterns[] = {
	{"HOLES1", run_row, 8, 10},
	{"HOLES2", run_ring, 8, 10},
	{"CYCLE801", run_grid, 11, 13},
	{"CYCLE802", run_positions, 0, 0},
};

static size_t find(const char *name)
{
	size_t i = 0;

	while (i < sizeof(patterns) / sizeof(patterns[0]) && strcmp(patterns[i].name, name) != 0)
		i++;
	return i;
}

bool sinumerik_pattern_is(const char *name)
{
	return find(name) < sizeof(patterns) / sizeof(patterns[0]);
}

/* Continues at the first hole that is left. */
static bool run_left(struct interp *interp)
{
	struct sinumerik_pattern *left = &sinumerik_of(interp)->pattern;
	/* The cycle at the holes has its own arguments. */
	struct pattern p = {{interp, left->name, left->column, left->arguments, left->argument_count},
			    left->plane == G17 ? SLOT_X : left->plane == G18 ? SLOT_Z : SLOT_Y,
			    left->plane == G17 ? SLOT_Y : left->plane == G18 ? SLOT_X : SLOT_Z,
			    &left->from, left, 0, false};

	left->on = false;
	if (!patterns[find(left->name)].run(&p))
		return false;
	left->on = p.called;
	return true;
}

bool sinumerik_pattern_run(struct interp *interp, const char *name, int column)
{
	struct sinumerik *sinumerik = sinumerik_of(interp);
	struct sinumerik_pattern *left = &sinumerik->pattern;
	const struct sinumerik_arguments of = {interp, name, column, sinumerik->passed.numbers,
					       sinumerik->passed.count};
	const size_t at = find(name), hide = patterns[at].hide;

	if (sinumerik->modal.on && !sinumerik->modal.cycle && !sinumerik_modal_acts(sinumerik))
		return fault(&interp->at, column, "%s in the subprogram %s, which MCALL calls, is not supported", name,
			     sinumerik->modal.name);
	if (hide && hide < sinumerik->passed.count &&
	    (sinumerik->passed.is_text[hide] ? sinumerik->passed.texts[hide].bytes[0] != '\0'
					       : sinumerik_argument_counts(&of, hide)))
		return fault(&interp->at, column, "%s that leaves holes out (_HIDE) is not supported", name);
	if (!sinumerik_target_check_cycle(interp, column) || !sinumerik_open_place_check(interp, column, name) ||
	    !sinumerik_argument_plane(&of, patterns[at].display ? patterns[at].display : SIZE_MAX))
		return false;
	*left = (struct sinumerik_pattern){.line = source_here(interp->program.source),
					   .depth = sinumerik->calls.depth,
					   .column = column,
					   .plane = interp->state.plane,
					   .scale = interp->state.scale,
					   .from = *sinumerik_frame_place(interp),
					   .argument_count = sinumerik->passed.count};
	sinumerik_save_modes(interp, &left->before);
	strcpy(left->name, name);
	memcpy(left->arguments, sinumerik->passed.numbers, sizeof(left->arguments));
	return run_left(interp);
}

bool sinumerik_pattern_waits(struct interp *interp)
{
	const struct sinumerik *sinumerik = sinumerik_of(interp);
	const struct sinumerik_pattern *left = &sinumerik->pattern;

	return left->on && sinumerik->calls.depth == left->depth && interp->program.source == left->line.source &&
	       interp->at.line == left->line.line;
}

bool sinumerik_pattern_go_on(struct interp *interp)
{
	const struct sinumerik *sinumerik = sinumerik_of(interp);
	const struct sinumerik_pattern *left = &sinumerik->pattern;

	interp->moves = 0;
	if (interp->state.plane != left->plane || !same_double(interp->state.scale, left->scale))
		return fault(&interp->at, left->column,
			     "%s has changed the plane or the unit of length (G17 to G19, G70 to G710) at a hole of "
			     "%s; PROC with SAVE brings them back",
			     sinumerik->modal.name, left->name);
	if (interp->comp.side != 0)
		return fault(&interp->at, left->column, "%s has left tool radius compensation on at a hole of %s; G40 "
							"first",
			     sinumerik->modal.name, left->name);
	/* The cycles of the control are subprograms with SAVE; everything at the holes has run inside of one. */
	return sinumerik_target_check_cycle(interp, left->column) && run_left(interp) &&
	       (left->on || sinumerik_save_restore(interp, &left->before, left->column));
}
