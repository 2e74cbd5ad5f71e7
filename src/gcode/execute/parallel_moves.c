#include "gcode/execute/parallel_moves.h"

#include <math.h>
#include <string.h>

#include "base/same_double.h"
#include "gcode/execute/box_cover.h"
#include "gcode/execute/motion_commands.h"
#include "gcode/execute/probed_axes.h"
#include "gcode/execute/rotated_frame.h"

/* mm: how far the moves may extend beyond the places of the tool: less than the usual clearances of programs. */
#define BESIDE 0.7

/* mm: more than 0, so that a move between the lines counts as a set of paths, of which none is certain to cut. */
#define NARROW 1e-9

/* The moves that cover a region: they are first counted, and then made. */
struct moves {
	struct interp *interp;
	slot_values at;
	struct canon_move narrow;	/* between the lines */
	long count;
	bool counts;
};

struct parallel_box parallel_moves_box(const double spread[3])
{
	return (struct parallel_box){{{spread[SLOT_X], 0, 0}, {0, spread[SLOT_Y], 0}, {0, 0, spread[SLOT_Z]}}};
}

/* Adds the extent of a box along X, Y and Z. */
static void add_spread(struct canon_move *move, const vec3 half[3])
{
	for (int side = 0; side < 3; side++) {
		move->spread[SLOT_X] += fabs(half[side].x);
		move->spread[SLOT_Y] += fabs(half[side].y);
		move->spread[SLOT_Z] += fabs(half[side].z);
	}
}

static bool is_plain(const struct interp *interp, const slot_values *target)
{
	bool same = !probed_axes_any(&interp->state);

	for (int slot = SLOT_A; slot < SLOT_COUNT; slot++)
		same = same && same_double(target->v[slot], interp->state.position.v[slot]);
	return same;
}

/* Moves to a point of the controller. */
static bool go_to(struct moves *moves, vec3 point, const struct canon_move *move)
{
	const vec3 straight = rotated_frame_straight_point(&moves->interp->state, point);
	struct canon_move part = *move;

	slot_values_set_linear(&moves->at, straight);
	return motion_commands_go(moves->interp, &moves->at, &part);
}

static bool go_along(void *context, const struct cover_line *line)
{
	struct moves *moves = (struct moves *)context;
	struct canon_move wide = moves->narrow;

	moves->count++;
	if (moves->counts)
		return true;
	wide.spread[SLOT_X] = line->spread.x;
	wide.spread[SLOT_Y] = line->spread.y;
	wide.spread[SLOT_Z] = line->spread.z;
	return go_to(moves, line->from, &moves->narrow) && go_to(moves, line->to, &wide);
}

bool parallel_moves_go(struct interp *interp, const slot_values *target, const struct canon_move *move,
		       const struct parallel_box *box)
{
	const slot_values end = rotated_frame_position(&interp->state, target);
	struct moves moves = {.interp = interp, .at = *target, .narrow = *move, .counts = true};
	struct box_way way = {.start = slot_values_linear(&interp->state.position),
			      .half = {box->half[0], box->half[1], box->half[2]}};
	struct canon_move whole = *move;
	const double size = vec3_norm((vec3){vec3_norm(way.half[0]), vec3_norm(way.half[1]), vec3_norm(way.half[2])});

	if (!is_plain(interp, target) || size <= BESIDE) {
		add_spread(&whole, box->half);
		return motion_commands_go(interp, target, &whole);
	}
	way.way = vec3_sub(slot_values_linear(&end), way.start);
	box_cover(&way, BESIDE, go_along, &moves);
	/* All moves together take about the time of the one move: the control's true time is not known. */
	moves.narrow.feed.linear *= (double)moves.count;
	moves.counts = false;
	moves.narrow.spread[SLOT_X] = moves.narrow.spread[SLOT_Y] = NARROW;
	if (!box_cover(&way, BESIDE, go_along, &moves))
		return false;
	whole = moves.narrow;
	return motion_commands_go(interp, target, &whole);
}

bool parallel_moves_go_from_open(struct interp *interp, const slot_values *target, struct canon_move *move,
				 const struct parallel_box *box)
{
	double *loose = interp->comp.loose, open[3];

	memcpy(open, loose, sizeof(open));
	if (!(open[0] + open[1] + open[2] > 0) || !is_plain(interp, target))
		return motion_commands_go(interp, target, move);
	memset(loose, 0, sizeof(open));
	if (!parallel_moves_go(interp, target, move, box))
		return false;
	memcpy(loose, open, sizeof(open));
	return true;
}
