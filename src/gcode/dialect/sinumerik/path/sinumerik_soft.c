#include "gcode/dialect/sinumerik/path/sinumerik_soft.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "base/math/math_functions.h"
#include "base/mem.h"
#include "base/same_double.h"
#include "gcode/dialect/sinumerik/cycles/sinumerik_contour.h"
#include "gcode/dialect/sinumerik/frames/sinumerik_frame.h"
#include "gcode/dialect/sinumerik/frames/sinumerik_open_place.h"
#include "gcode/dialect/sinumerik/path/sinumerik_soft_moves.h"
#include "gcode/dialect/sinumerik/path/sinumerik_target.h"
#include "gcode/execute/cutter_comp/comp_moves.h"
#include "gcode/execute/cutter_comp/cutter_comp.h"
#include "gcode/execute/motion_commands.h"
#include "gcode/execute/rotated_frame.h"
#include "geom/tolerance.h"

#define LINEAR_BITS (letter_bit('X') | letter_bit('Y') | letter_bit('Z'))
#define SOFT_BITS (1U << SINUMERIK_DISR | 1U << SINUMERIK_DISCL | 1U << SINUMERIK_DISRP | 1U << SINUMERIK_FAD)

/* ------------------------------------------------------------------ blocks that wait */

static void release_block(struct sinumerik_soft_block *kept)
{
	free(kept->text);
	*kept = (struct sinumerik_soft_block){.kept = false};
}

static bool drop(struct interp *interp)
{
	struct sinumerik_soft *soft = &sinumerik_of(interp)->soft;

	release_block(&soft->first);
	release_block(&soft->second);
	soft->waits = soft->fresh = false;
	return false;
}

void sinumerik_soft_release(struct sinumerik *sinumerik)
{
	release_block(&sinumerik->soft.first);
	release_block(&sinumerik->soft.second);
}

static void keep_block(struct interp *interp, struct sinumerik_soft_block *kept)
{
	*kept = (struct sinumerik_soft_block){.kept = true,
					      .block = interp->block,
					      .at = interp->at,
					      .callers = interp->callers,
					      .text = mem_strndup(interp->at.text, strlen(interp->at.text))};
	kept->at.text = kept->text;
	sinumerik_of(interp)->soft.fresh = true;
}

static void enter_block(struct interp *interp, const struct sinumerik_soft_block *kept)
{
	interp->block = kept->block;
	interp->at = kept->at;
	interp->callers = kept->callers;
	interp->moves = 0;
}

bool sinumerik_soft_keeps_block(struct interp *interp)
{
	struct sinumerik_soft *soft = &sinumerik_of(interp)->soft;
	const bool keeps = soft->fresh;

	soft->fresh = false;
	return keeps;
}

bool sinumerik_soft_end_block(struct interp *interp)
{
	const struct sinumerik_soft *soft = &sinumerik_of(interp)->soft;

	if (!soft->waits || soft->fresh)
		return true;
	fault_report(&interp->at, 1,
		     "G%d of line %ld waits for the path that it touches: the block behind it must be a move in the "
		     "plane with G1, G2 or G3 and no other code",
		     soft->words.code / 10, soft->first.at.line);
	return drop(interp);
}

/* ---------------------------------------------------------------------- words */

void sinumerik_soft_note(struct interp *interp, const struct sinumerik_block *block)
{
	struct sinumerik_soft *soft = &sinumerik_of(interp)->soft;

	if (block->code[SINUMERIK_SOFT] == CODE_NONE)
		return;
	soft->motion_before = interp->state.motion;
	soft->linear_before = interp->state.feed_linear;
	soft->angular_before = interp->state.feed_angular;
	soft->mode_before = interp->state.feed_mode;
}

bool sinumerik_soft_select(struct interp *interp, const struct sinumerik_block *block)
{
	struct sinumerik_comp *comp = &sinumerik_of(interp)->comp;

	if (block->code[SINUMERIK_SOFT_SIDE] != CODE_NONE)
		comp->soft_side = block->code[SINUMERIK_SOFT_SIDE];
	if (block->code[SINUMERIK_SOFT_WAY] != CODE_NONE)
		comp->soft_way = block->code[SINUMERIK_SOFT_WAY];
	for (int i = 0; i < SINUMERIK_ADDRESSES && block->code[SINUMERIK_SOFT] == CODE_NONE; i++) {
		if (block->addresses & SOFT_BITS & 1U << i)
			return fault(&interp->at, block->address_column[i],
				     "this word belongs to a soft approach or retraction (G147, G247, G347, G148, "
				     "G248, G348)");
	}
	return true;
}

static bool check_block(struct interp *interp, const struct sinumerik_block *block)
{
	const int column = block->code_column[SINUMERIK_SOFT], code = block->code[SINUMERIK_SOFT] / 10;

	if (block->code[SINUMERIK_SUPPRESSION] != CODE_NONE || block->positions || block->call[0] ||
	    (block->letters & SINUMERIK_CENTRE_BITS) || (block->letters & AXIS_BITS & ~LINEAR_BITS) ||
	    (block->addresses & ~(SOFT_BITS | 1U << SINUMERIK_OFFN | 1U << SINUMERIK_DISC | 1U << SINUMERIK_ADIS)))
		return fault(&interp->at, column,
			     "G%d has coordinates of X, Y and Z alone; write the other words into another block",
			     code);
	if (sinumerik_contour_is_read(interp) || sinumerik_modal_acts(sinumerik_of(interp)))
		return fault(&interp->at, column, "G%d in the contour of a cycle or under MCALL is not supported",
			     code);
	if (interp->state.feed_mode == FEED_INVERSE_TIME || sinumerik_of(interp)->soft.mode_before == FEED_INVERSE_TIME)
		return fault(&interp->at, column, "G%d in inverse time mode (G93) is not supported", code);
	if (interp->state.feed_mode != sinumerik_of(interp)->soft.mode_before)
		return fault(&interp->at, column,
			     "another kind of feed (G94, G95) beside G%d: write it into a block of its own before",
			     code);
	if (sinumerik_frame_resizes(interp))
		return fault(&interp->at, column, "G%d while SCALE is in force is not supported", code);
	if (!sinumerik_block_has_address(block, SINUMERIK_DISR))
		return fault(&interp->at, column, "G%d needs DISR, the length of its line or the radius of its circle",
			     code);
	return sinumerik_open_place_check(interp, column, "a soft approach") &&
	       sinumerik_target_check(interp, block, false, true);
}

/* ------------------------------------------------------------------- approach */

static const struct canon_feed *feed_before(const struct sinumerik_soft_words *words)
{
	return words->rapid_before ? NULL : &words->before;
}

/* From P0 to P4. If another block has given P4, the path that touches the contour belongs to that block. */
static bool make_moves(struct interp *interp, const struct sinumerik_soft_path *path)
{
	const struct sinumerik_soft *soft = &sinumerik_of(interp)->soft;
	const struct sinumerik_soft_words *words = &soft->words;
	const enum axis_slot across = comp_slot_across(interp);
	const bool level = sinumerik_of(interp)->comp.soft_way == SINUMERIK_G(341);
	const struct canon_feed *down = words->has_slow	  ? &words->slow
					: words->has_feed ? &words->own
							  : feed_before(words);
	double base = soft->end.v[across], high, low;
	slot_values upper, lower, start;

	if (!sinumerik_soft_moves_find_heights(interp, words, base, soft->start.v[across], &high, &low))
		return false;
	upper = sinumerik_soft_moves_place(interp, &soft->end, path->end, high);
	lower = sinumerik_soft_moves_place(interp, &soft->end, path->end, low);
	start = sinumerik_soft_moves_place(interp, &soft->end, path->end, level ? base : low);
	sinumerik_soft_moves_put_at(interp, &soft->start);
	if (!sinumerik_soft_moves_line(interp, &upper, feed_before(words)) ||
	    !sinumerik_soft_moves_line(interp, &lower, feed_before(words)) ||
	    !sinumerik_soft_moves_line(interp, &start, down))
		return false;
	if (soft->second.kept) {
		if (!cutter_comp_end_block(interp))
			return false;
		enter_block(interp, &soft->second);
	}
	return sinumerik_soft_moves_path(interp, &soft->end, path,
					 words->has_slow && !level ? &words->slow : &words->path) &&
	       cutter_comp_end_block(interp);
}

static bool make_approach(struct interp *interp, struct plane_point along)
{
	struct sinumerik_soft *soft = &sinumerik_of(interp)->soft;
	const struct block block = interp->block;
	const struct line_place at = interp->at;
	const struct call_chain callers = interp->callers;
	const int moves = interp->moves;
	const struct plane_point outside = comp_point_of(interp, &soft->start), end = comp_point_of(interp, &soft->end);
	struct sinumerik_soft_path path = {.is_arc = false};
	bool good;

	enter_block(interp, &soft->first);
	good = sinumerik_soft_path_find(interp, &soft->words, end, along, &outside, &path) && make_moves(interp, &path);
	interp->block = block;
	interp->at = at;
	interp->callers = callers;
	interp->moves = moves;
	drop(interp);
	return good;
}

/* The next path only gives P4, the end of the approach. */
static bool take_end(struct interp *interp, const slot_values *target, const struct canon_move *move, bool is_arc)
{
	struct sinumerik_soft *soft = &sinumerik_of(interp)->soft;

	if (is_arc || move->kind != CANON_FEED)
		return fault(&interp->at, interp->block.g_column[G_MOTION],
			     "this block gives the end of the approach of line %ld, so it needs G1",
			     soft->first.at.line);
	soft->end = sinumerik_frame_straight(interp, target);
	soft->words.path = move->feed;
	soft->needs_end = false;
	keep_block(interp, &soft->second);
	sinumerik_soft_moves_put_at(interp, &soft->end);
	sinumerik_of(interp)->place.program = *target;
	sinumerik_of(interp)->place.known = true;
	return true;
}

bool sinumerik_soft_pass(struct interp *interp, const slot_values *target, const struct canon_move *move,
			 const struct sinumerik_circle *circle, bool *taken)
{
	const struct sinumerik_soft *soft = &sinumerik_of(interp)->soft;
	const slot_values straight = sinumerik_frame_straight(interp, target);
	const struct plane_point to = comp_point_of(interp, &straight), from = comp_point_of(interp, &soft->end);
	struct plane_point along = {to.a - from.a, to.b - from.b};
	double length;

	*taken = soft->needs_end;
	if (soft->needs_end)
		return take_end(interp, target, move, circle != NULL) || drop(interp);
	if (circle && circle->in_plane)
		along = circle->clockwise
			    ? (struct plane_point){from.b - circle->centre.b, circle->centre.a - from.a}
			    : (struct plane_point){circle->centre.b - from.b, from.a - circle->centre.a};
	length = math_hypot(along.a, along.b);
	if (!(length > SAME_POINT) || (circle && !circle->in_plane)) {
		fault_report(&interp->at, interp->block.g_column[G_MOTION],
			     "the path behind the approach of line %ld must be a line or a circle in the plane",
			     soft->first.at.line);
		return drop(interp);
	}
	return make_approach(interp, (struct plane_point){along.a / length, along.b / length});
}

/* How many coordinates of the plane the block has. */
static int plane_words(const struct interp *interp, const struct sinumerik_block *block)
{
	return (sinumerik_block_has(block, AXIS_LETTERS[comp_slot_a(interp)]) ? 1 : 0) +
	       (sinumerik_block_has(block, AXIS_LETTERS[comp_slot_b(interp)]) ? 1 : 0);
}

static bool approach(struct interp *interp, const struct sinumerik_block *block, const slot_values *target)
{
	struct sinumerik_soft *soft = &sinumerik_of(interp)->soft;
	const int code = soft->words.code / 10;

	if (interp->comp.side != 0 && interp->comp.entered)
		return fault(&interp->at, soft->words.column,
			     "G%d while tool radius compensation has begun is not supported: G40 first, and G41 or G42 "
			     "in the block of G%d",
			     code, code);
	if (plane_words(interp, block) == 1)
		return fault(&interp->at, soft->words.column,
			     "G%d with one coordinate of the plane: write both, or both into the next block", code);
	soft->needs_end = plane_words(interp, block) == 0;
	if (!soft->needs_end && interp->state.motion == G0 && !soft->words.has_feed)
		return fault(&interp->at, soft->words.column,
			     "G%d without F while G0 is in force: whether it goes to the contour at the rapid rate is "
			     "not certain; write G1 or F",
			     code);
	if (!soft->needs_end && !motion_commands_feed(interp, &soft->words.path))
		return false;
	soft->start = rotated_frame_straight(&interp->state);
	soft->end = sinumerik_frame_straight(interp, target);
	soft->waits = true;
	keep_block(interp, &soft->first);
	sinumerik_soft_moves_put_at(interp, &soft->end);
	sinumerik_of(interp)->place.program = *target;
	sinumerik_of(interp)->place.known = true;
	sinumerik_of(interp)->tangent.known = false;
	return true;
}

/* ----------------------------------------------------------------- retraction */

static bool find_end_direction(struct interp *interp, struct plane_point *along)
{
	const struct sinumerik_tangent *tangent = &sinumerik_of(interp)->tangent;
	const slot_values *place = sinumerik_frame_place(interp);
	const double length = math_hypot(tangent->way.a, tangent->way.b);

	if (!tangent->known || tangent->plane != interp->state.plane || !(length > SAME_POINT) ||
	    !same_double(tangent->end.a, place->v[comp_slot_a(interp)]) ||
	    !same_double(tangent->end.b, place->v[comp_slot_b(interp)]))
		return fault(&interp->at, sinumerik_of(interp)->soft.words.column,
			     "G%d goes on in the direction of the motion before it, which is not known here: move in "
			     "the plane, by G1, G2 or G3, right before it",
			     sinumerik_of(interp)->soft.words.code / 10);
	*along = (struct plane_point){tangent->way.a / length, tangent->way.b / length};
	return true;
}

/* From P4, where the tool is, to P0. The way in the plane behind P1 ends the compensation, if the block has G40. */
static bool leave(struct interp *interp, const struct sinumerik_soft_path *path, const slot_values *last, bool in_plane,
		  const double heights[2])
{
	const struct sinumerik_soft_words *words = &sinumerik_of(interp)->soft.words;
	const bool level = sinumerik_of(interp)->comp.soft_way == SINUMERIK_G(341), ends = interp->comp.leaving;
	const struct canon_feed *onward = interp->state.motion == G0 ? NULL : &words->path;
	const slot_values here = rotated_frame_straight(&interp->state);
	const double base = here.v[comp_slot_across(interp)];
	const slot_values away = sinumerik_soft_moves_place(interp, &here, path->end, level ? base : heights[1]),
			  lower = sinumerik_soft_moves_place(interp, &here, path->end, heights[1]),
			  upper = sinumerik_soft_moves_place(interp, &here, path->end, heights[0]);
	bool good;

	interp->comp.leaving = false;
	good = sinumerik_soft_moves_path(interp, &away, path,
					 words->has_slow && !level ? &words->slow : &words->before) &&
	       sinumerik_soft_moves_line(interp, &lower, words->has_slow ? &words->slow : &words->before) &&
	       sinumerik_soft_moves_line(interp, &upper, onward);
	interp->comp.leaving = ends;
	return good && (!in_plane || sinumerik_soft_moves_line(interp, last, onward));
}

/*
 * "Programming during retraction": the end stands in this block. Without coordinates the motion ends in P2, with that
 * of the third axis alone in P1.
 */
static bool depart(struct interp *interp, const struct sinumerik_block *block, const slot_values *target)
{
	struct sinumerik_soft_words *words = &sinumerik_of(interp)->soft.words;
	const enum axis_slot across = comp_slot_across(interp);
	const slot_values here = rotated_frame_straight(&interp->state);
	const slot_values last = sinumerik_frame_straight(interp, target);
	const struct plane_point outside = comp_point_of(interp, &last);
	const bool in_plane = plane_words(interp, block) > 0;
	const bool rises = sinumerik_block_has(block, AXIS_LETTERS[across]);
	struct sinumerik_soft_path path = {.is_arc = false};
	struct plane_point along;
	double heights[2];

	if (!in_plane && words->retract.given)
		return fault(&interp->at, words->column, "DISRP of G%d needs coordinates of the plane",
			     words->code / 10);
	if (words->rapid_before)
		return fault(&interp->at, words->column, "G%d behind a contour that moves with G0 is not supported",
			     words->code / 10);
	if (!motion_commands_feed(interp, &words->path) || !find_end_direction(interp, &along) ||
	    !sinumerik_soft_path_find(interp, words, comp_point_of(interp, &here), along, in_plane ? &outside : NULL,
				      &path) ||
	    !sinumerik_soft_moves_find_heights(interp, words, here.v[across],
					       in_plane || rises ? last.v[across] : NAN, &heights[0], &heights[1]))
		return false;
	if (interp->comp.leaving && math_hypot(outside.a - path.end.a, outside.b - path.end.b) < SAME_POINT)
		return fault(&interp->at, words->column,
			     "G40 beside G%d needs a way in the plane from beside the contour to its end",
			     words->code / 10);
	if (!leave(interp, &path, &last, in_plane, heights))
		return false;
	if (block->code[SINUMERIK_CUTTER] == G40)
		sinumerik_of(interp)->comp.selected = G40;
	sinumerik_frame_moved(interp);
	sinumerik_of(interp)->tangent.known = false;
	return true;
}

bool sinumerik_soft_run(struct interp *interp, const struct sinumerik_block *block)
{
	struct sinumerik_soft *soft = &sinumerik_of(interp)->soft;
	const int code = block->code[SINUMERIK_SOFT], column = block->code_column[SINUMERIK_SOFT];
	slot_values target;

	interp->block.motion = interp->block.g[G_MOTION] = G1;
	interp->block.g_column[G_MOTION] = column;
	if (!check_block(interp, block) || !sinumerik_target_find(interp, block, &target))
		return false;
	soft->words = (struct sinumerik_soft_words){
	    .code = code,
	    .column = column,
	    .size = sinumerik_target_length(interp, block->address_value[SINUMERIK_DISR])};
	if (!sinumerik_soft_moves_read_heights(interp, block, &soft->words) ||
	    !sinumerik_soft_moves_find_feeds(interp, block, &soft->words))
		return false;
	return sinumerik_soft_path_departs(code) ? depart(interp, block, &target) : approach(interp, block, &target);
}
