#include "gcode/dialect/sinumerik/cycles/sinumerik_cycle.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "base/math/math_functions.h"
#include "base/units.h"
#include "gcode/dialect/sinumerik/cycles/sinumerik_argument.h"
#include "gcode/dialect/sinumerik/frames/sinumerik_frame.h"
#include "gcode/execute/motion_commands.h"

/* 840D sl, "CYCLE83", VARI=1: how far above the last depth the rapid ends, by the depth of the hole; mm. */
#define PECK_LEAST 0.6
#define PECK_MOST 7.0
#define PECK_SHARE 50.0
#define PECK_SHALLOW 30.0
/* The maximum number of pecks in one hole. */
#define PECKS_MAX 10000

struct drilling {
	struct interp *interp;
	struct sinumerik_arguments of;
	int column;
	enum axis_slot a, b, depth;	/* the plane, and the drilling axis */
	slot_values at;	/* program coordinates of the tool */
	struct sinumerik_heights height;
	struct canon_feed feed;
	bool turns;	/* the cycle starts the spindle */
};

static bool given(const struct drilling *d, size_t i)
{
	return sinumerik_argument_given(&d->of, i);
}

static double argument(const struct drilling *d, size_t i, double otherwise)
{
	return sinumerik_argument_or(&d->of, i, otherwise);
}

static double length(const struct drilling *d, size_t i)
{
	return sinumerik_argument_length(&d->of, i);
}

/* ------------------------------------------------------------------- moves */

static bool go(struct drilling *d, enum canon_kind kind, double height)
{
	struct canon_move move = {.kind = kind, .feed = d->feed, .spindle_turns = d->turns,
				  .turn = d->turns ? TURN_OF_TAP : TURN_UNKNOWN};
	slot_values straight;

	d->at.v[d->depth] = height;
	straight = sinumerik_frame_straight(d->interp, &d->at);
	if (!motion_commands_go(d->interp, &straight, &move))
		return false;
	sinumerik_of(d->interp)->place.program = d->at;
	sinumerik_of(d->interp)->place.known = true;
	return true;
}

static bool rapid(struct drilling *d, double height)
{
	return go(d, CANON_RAPID, height);
}

static bool feed(struct drilling *d, double height)
{
	return go(d, CANON_FEED, height);
}

/* Seconds; a negative value is revolutions of the spindle. */
static bool dwell(struct drilling *d, size_t i)
{
	double seconds = argument(d, i, 0);

	if (seconds < 0 && d->interp->state.speed > 0)
		seconds = -seconds * SECONDS_PER_MINUTE / d->interp->state.speed;
	return !(seconds > 0) ||
	       motion_commands_emit(d->interp, &(struct canon_move){.kind = CANON_DWELL, .seconds = seconds});
}

static bool programmed_feed(struct drilling *d)
{
	d->interp->block.motion = d->interp->block.g[G_MOTION] = G1;
	d->interp->block.g_column[G_MOTION] = d->column;
	d->interp->block.letters = 0;
	return motion_commands_feed(d->interp, &d->feed);
}

static void own_feed(struct drilling *d, double per_minute)
{
	d->feed = (struct canon_feed){.linear = per_minute / SECONDS_PER_MINUTE};
}

static bool stop_spindle(struct drilling *d)
{
	const bool good = motion_commands_spindle_stops(d->interp);

	d->interp->state.spindle = SPINDLE_STOPPED;
	return good;
}

/* SDIR: 3 or 4, the direction of the spindle. */
static bool start_spindle(struct drilling *d, size_t i)
{
	const double way = argument(d, i, 0);

	if (given(d, i) && !(way >= 3 && way <= 4))
		return fault(&d->interp->at, d->column, "SDIR must be 3 or 4, as M3 and M4, not %.15g", way);
	if (given(d, i))
		d->interp->state.spindle = way > 3 ? SPINDLE_COUNTERCLOCKWISE : SPINDLE_CLOCKWISE;
	return true;
}

/* ------------------------------------------------------------------ cycles */

static bool drill(struct drilling *d)
{
	return programmed_feed(d) && rapid(d, d->height.safe) && feed(d, d->height.bottom) && rapid(d, d->height.clear);
}

static bool counterbore(struct drilling *d)
{
	return programmed_feed(d) && rapid(d, d->height.safe) && feed(d, d->height.bottom) && dwell(d, 5) &&
	       rapid(d, d->height.clear);
}

/* The depth of the next peck: each peck is smaller by DAM; a negative DAM is a factor. */
static double next_peck(const struct drilling *d, double peck)
{
	const double amount = argument(d, 7, 0), least = length(d, 13);
	double next = amount < 0 ? peck * -amount : peck - amount * d->interp->state.scale;

	if (amount > 0)
		next = fmax(next, fmin(peck, amount * d->interp->state.scale));
	return fmax(next, least);
}

/*
 * CYCLE83: first to FDEP, then in pecks. All moves are on one line between the safe plane and the bottom. If the
 * control divides the last two pecks differently, only the time differs.
 */
static bool deep(struct drilling *d)
{
	const bool removes = argument(d, 11, 0) > 0;
	const double first = given(d, 6)   ? d->height.reference - length(d, 6)
			     : given(d, 5) ? length(d, 5)
					   : d->height.bottom;
	const double whole = d->height.reference - d->height.bottom;
	const double above = whole <= PECK_SHALLOW ? PECK_LEAST : fmin(whole / PECK_SHARE, PECK_MOST);
	const double lift = length(d, 14) > 0 ? length(d, 14) : 1;
	double depth = fmax(first, d->height.bottom), peck = d->height.reference - depth;

	if (!programmed_feed(d) || !rapid(d, d->height.safe))
		return false;
	for (int i = 0; depth > d->height.bottom; i++) {
		if (!(peck > 0) || i == PECKS_MAX)
			return fault(&d->interp->at, d->column, "the pecks of CYCLE83 never reach its depth");
		if (!feed(d, depth) || !dwell(d, 8))
			return false;
		if (removes
			? !rapid(d, d->height.safe) || !dwell(d, 9) || !rapid(d, fmin(depth + above, d->height.safe))
			: !rapid(d, fmin(depth + lift, d->height.safe)))
			return false;
		peck = next_peck(d, peck);
		depth = fmax(depth - peck, d->height.bottom);
	}
	return feed(d, d->height.bottom) && dwell(d, 8) && rapid(d, d->height.clear);
}

/* The pitch of a metric thread from its size (MPIT): DIN 13, coarse. 0: not known. */
static double metric_pitch(double size)
{
	static const double threads[][2] = {{3, 0.5}, {4, 0.7}, {5, 0.8},  {6, 1},    {8, 1.25}, {10, 1.5},
					    {12, 1.75}, {14, 2}, {16, 2},  {18, 2.5}, {20, 2.5}, {22, 2.5},
					    {24, 3},  {27, 3},  {30, 3.5}, {33, 3.5}, {36, 4},	 {39, 4},
					    {42, 4.5}, {45, 4.5}, {48, 5}};

	for (size_t i = 0; i < sizeof(threads) / sizeof(threads[0]); i++) {
		if (fabs(fabs(size) - threads[i][0]) < 1e-9)
			return threads[i][1];
	}
	return 0;
}

/* Into the hole and out of it, at the feed of the thread. */
static bool tap(struct drilling *d, double pitch, double speed, size_t dwell_at)
{
	d->feed = (struct canon_feed){.linear = motion_commands_thread_feed(d->interp, d->column,
									    pitch * speed / SECONDS_PER_MINUTE)};
	d->turns = true;
	return rapid(d, d->height.safe) && feed(d, d->height.bottom) && dwell(d, dwell_at) && feed(d, d->height.safe) &&
	       rapid(d, d->height.clear);
}

/* PITA, the unit of PIT: 0 and 1 mm, 2 threads per inch, 3 inches, 4 modules. */
static double pitch_of(const struct drilling *d, size_t size, size_t pitch, size_t unit)
{
	const double value = fabs(argument(d, pitch, 0));

	if (!(value > 0))
		return metric_pitch(argument(d, size, 0));
	switch (sinumerik_argument_digit(&d->of, unit, 0)) {
	case 2:
		return MM_PER_INCH / value;
	case 3:
		return MM_PER_INCH * value;
	case 4:
		return PI * value;
	default:
		return value * d->interp->state.scale;
	}
}

static bool tap_rigid(struct drilling *d)
{
	return stop_spindle(d) && tap(d, pitch_of(d, 7, 8, 13), argument(d, 10, d->interp->state.speed), 5);
}

static bool tap_floating(struct drilling *d)
{
	return tap(d, pitch_of(d, 9, 10, 12), d->interp->state.speed, 5);
}

/* CYCLE85: in with the feed FFR, out with RFF. */
static bool ream(struct drilling *d)
{
	const double scale = sinumerik_of(d->interp)->feed_scale;

	if (!given(d, 6) || !given(d, 7) || !(d->of.values[6] > 0 && d->of.values[7] > 0))
		return fault(&d->interp->at, d->column, "CYCLE85 needs its feeds FFR and RFF");
	own_feed(d, d->of.values[6] * scale);
	if (!rapid(d, d->height.safe) || !feed(d, d->height.bottom) || !dwell(d, 5))
		return false;
	own_feed(d, d->of.values[7] * scale);
	return feed(d, d->height.safe) && rapid(d, d->height.clear);
}

/*
 * CYCLE86: the spindle stops at an angle, the tool moves away from the wall by RPA, RPO and RPAP, and retracts with
 * G0.
 */
static bool bore_oriented(struct drilling *d)
{
	const slot_values start = d->at;

	if (!programmed_feed(d) || !start_spindle(d, 6) || !rapid(d, d->height.safe) || !feed(d, d->height.bottom) ||
	    !dwell(d, 5) || !stop_spindle(d))
		return false;
	d->at.v[d->a] += length(d, 7);
	d->at.v[d->b] += length(d, 8);
	if (!rapid(d, d->height.bottom + length(d, 9)) || !rapid(d, d->height.clear))
		return false;
	d->at.v[d->a] = start.v[d->a];
	d->at.v[d->b] = start.v[d->b];
	return rapid(d, d->height.clear);
}

/* CYCLE87 and CYCLE88: M5 M0 at the bottom; then the tool retracts with G0. */
static bool bore_stopped(struct drilling *d, bool dwells, size_t direction)
{
	return programmed_feed(d) && start_spindle(d, direction) && rapid(d, d->height.safe) &&
	       feed(d, d->height.bottom) && (!dwells || dwell(d, 5)) && stop_spindle(d) && rapid(d, d->height.clear);
}

static bool bore_stop(struct drilling *d)
{
	return bore_stopped(d, false, 5);
}

static bool bore_stop_dwell(struct drilling *d)
{
	return bore_stopped(d, true, 6);
}

static bool bore_feed(struct drilling *d)
{
	return programmed_feed(d) && rapid(d, d->height.safe) && feed(d, d->height.bottom) && dwell(d, 5) &&
	       feed(d, d->height.safe) && rapid(d, d->height.clear);
}

/* 840D sl, "Drilling cycles". */
static const struct cycle {
	const char *name;
	bool (*run)(struct drilling *d);
	size_t axis;	/* the index of _AXN among the arguments; 0: there is none */
	size_t modes;	/* the index of _GMODE; _DMODE and _AMODE follow it; 0: there is none of them */
} cycles[] = {
	{"CYCLE81", drill, 0, 6},
	{"CYCLE82", counterbore, 0, 6},
	{"CYCLE83", deep, 12, 17},
	{"CYCLE84", tap_rigid, 12, 21},
	{"CYCLE840", tap_floating, 11, 17},
	{"CYCLE85", ream, 0, 8},
	{"CYCLE86", bore_oriented, 0, 11},
	{"CYCLE87", bore_stop, 0, 0},
	{"CYCLE88", bore_stop_dwell, 0, 0},
	{"CYCLE89", bore_feed, 0, 6},
};

static const struct cycle *find(const char *name)
{
	for (size_t i = 0; i < sizeof(cycles) / sizeof(cycles[0]); i++) {
		if (!strcmp(cycles[i].name, name))
			return &cycles[i];
	}
	return NULL;
}

bool sinumerik_cycle_drills(const char *name)
{
	return find(name) != NULL;
}

/* _AXN: 1, 2 and 3 select the drilling axis, independent of the plane; with 0 the plane selects it. */
static bool check_axis(const struct drilling *d, size_t i)
{
	const double axis = i > 0 ? argument(d, i, 0) : 0;

	return !(axis >= 1 && axis <= 3) || (int)axis - 1 + SLOT_X == (int)d->depth ||
	       fault(&d->interp->at, d->column,
		     "_AXN=%.15g has the cycle drill along %c, which is not the axis across the plane in force; select "
		     "its plane",
		     axis, "XYZ"[(int)axis - 1]);
}

/*
 * _GMODE, tens: 1 is a depth given by the diameter of the countersink (CYCLE81), or the depth of the drill's shank,
 * so that the tip goes deeper. Both need the angle of the tip.
 */
static bool check_geometry(const struct drilling *d, size_t i)
{
	return i == 0 || !sinumerik_argument_counts(&d->of, i) ||
	       fault(&d->interp->at, d->column,
		     "_GMODE=%.15g of %s is not supported, only 0: the depth is that of the tool's tip",
		     argument(d, i, 0), d->of.cycle);
}

bool sinumerik_cycle_drill(struct interp *interp, const char *name, const double *arguments, size_t count, int column)
{
	const struct cycle *cycle = find(name);
	const struct sinumerik_modes modes = {.display = cycle->modes ? cycle->modes + 1 : 0,
					      .alternative = cycle->modes ? cycle->modes + 2 : 0,
					      .has_relative = true};
	const int plane = interp->state.plane;
	struct drilling d = {.interp = interp, .of = {interp, name, column, arguments, count}, .column = column};

	d.depth = plane == G17 ? SLOT_Z : plane == G18 ? SLOT_Y : SLOT_X;
	d.a = plane == G17 ? SLOT_X : plane == G18 ? SLOT_Z : SLOT_Y;
	d.b = plane == G17 ? SLOT_Y : plane == G18 ? SLOT_X : SLOT_Z;
	if (!interp->config->has_axis[d.depth])
		return fault(&interp->at, column, "the machine has no %c axis", AXIS_LETTERS[d.depth]);
	if (!check_axis(&d, cycle->axis) || !check_geometry(&d, cycle->modes))
		return false;
	d.at = *sinumerik_frame_place(interp);
	return sinumerik_argument_heights(&d.of, &modes, &d.height) && cycle->run(&d);
}
