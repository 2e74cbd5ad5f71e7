#include "gcode/dialect/klartext/path/klartext_straight.h"

#include <math.h>

#include "gcode/dialect/klartext/cycles/klartext_cycle.h"
#include "gcode/dialect/klartext/frames/klartext_frame.h"
#include "gcode/dialect/klartext/machine/klartext_m.h"
#include "gcode/dialect/klartext/moves/klartext_comp.h"
#include "gcode/dialect/klartext/path/klartext_approach.h"
#include "gcode/dialect/klartext/path/klartext_corner.h"
#include "gcode/dialect/klartext/path/klartext_path.h"
#include "gcode/dialect/klartext/path/klartext_vector.h"
#include "gcode/dialect/klartext/planes/klartext_orient.h"
#include "gcode/execute/endpoint.h"
#include "gcode/execute/motion_commands.h"
#include "gcode/execute/tool_length.h"

/* --------------------------------------------------------------------- L */

/* Finds the machine coordinate from which M92 counts an axis; 0 for M91. False: reported. */
static bool find_zero(struct interp *interp, const struct klartext_words *words, int slot, double *zero)
{
	const struct control_place *place = &interp->config->controller.references[0];

	*zero = 0;
	if (!klartext_words_m(words, 92))
		return true;
	if (!place->given || !place->has[slot])
		return fault(&interp->at, words->column[slot],
			     "the machine's builder decides from where M92 counts %c: set <reference number=\"1\" "
			     "%c=\"\"/> in the machine file's <controller>, in machine coordinates",
			     AXIS_LETTERS[slot], AXIS_LETTERS[slot]);
	*zero = state_from_canonical(slot, place->value.v[slot]);
	return true;
}

/*
 * M91: coordinates of the machine's axes. M92: coordinates from a point that the machine's builder has set. Work
 * offsets, the frame and the tool's length do not count ("M91", "M92" in the iTNC 530 user's manual). No manual was
 * found for the assumption that the plane stays tilted meanwhile.
 */
static bool run_in_machine(struct interp *interp, const struct klartext_words *words, bool rapid,
			   const struct canon_feed *feed)
{
	struct canon_move move = {.kind = rapid ? CANON_RAPID : CANON_FEED, .feed = *feed, .machine_coordinates = true};
	const struct klartext_m *m = klartext_m_machine(words);
	const int column = m->column, number = m->number;
	struct suspended suspended;
	slot_values target;

	if (klartext_comp_is_selected(interp))
		return fault(&interp->at, column, "M%d under radius compensation is not supported: R0 comes first",
			     number);
	if (interp->state.tcp == TCP_BY_MCODE)
		return fault(&interp->at, column, "M%d while M128 is in force: the manual wants M129 first", number);
	if (klartext_of(interp)->stay.waits)
		return fault(&interp->at, column,
			     "M%d between PLANE ... STAY and the rotary axes' way to the plane is not supported",
			     number);
	if (klartext_words_m(words, 91) && klartext_words_m(words, 92))
		return fault(&interp->at, column, "M91 and M92 in one block");
	if (interp->state.tcp != TCP_OFF)
		klartext_comp_turn_open(interp);
	if (!tool_length_suspend(interp, column, &suspended))
		return false;
	target = interp->state.position;
	for (int slot = 0; slot < SLOT_COUNT; slot++) {
		double zero;

		if (!klartext_words_has(words, slot))
			continue;
		if (suspended.tcp == TCP_BY_PLANE && slot_is_rotary(slot))
			return fault(&interp->at, words->column[slot],
				     "a rotary axis leaves the tilted plane: write PLANE RESET first");
		if (words->increments & 1U << slot)
			target.v[slot] += words->value[slot];
		else if (!find_zero(interp, words, slot, &zero) ||
			 !endpoint_absolute(interp, slot, words->value[slot], zero, words->column[slot],
					    &target.v[slot]))
			return false;
	}
	klartext_of(interp)->last = (struct klartext_path){.rapid = rapid};
	klartext_of(interp)->tool.moved = true;
	if (!motion_commands_go(interp, &target, &move) || !tool_length_resume(interp, column, &suspended))
		return false;
	/* In a tilted plane, X and Y of the machine alone do not determine the position of the tool in the plane. */
	if (suspended.tcp == TCP_OFF)
		klartext_comp_settle(interp, words);
	return true;
}

/* After the rotary axes have reached the plane of PLANE ... STAY, coordinates are tilted. */
static bool settle_plane(struct interp *interp, const struct klartext_target *target, int column)
{
	struct klartext_stay *stay = &klartext_of(interp)->stay;

	if (!stay->waits || !target->turns)
		return true;
	if (!klartext_move_in_plane(interp, &interp->state.position))
		return true;
	stay->waits = false;
	return tool_length_switch_tcp(interp, column, TCP_BY_PLANE);
}

/* Refuses words of linear axes between STAY and the move of the rotary axes to the plane. False: reported. */
static bool check_waiting(struct interp *interp, const struct klartext_words *words)
{
	if (!klartext_of(interp)->stay.waits || !(words->axes & (1U << SLOT_X | 1U << SLOT_Y | 1U << SLOT_Z)))
		return true;
	return klartext_move_refuse_waiting(interp, words->first_column);
}

/* PATHCTRL VECTOR: the tool turns in the plane of its first and last directions. */
static bool turn_by_vector(struct interp *interp, const struct klartext_words *words,
			   const struct klartext_target *target, const struct klartext_path *path)
{
	struct klartext *klartext = klartext_of(interp);

	if (klartext_comp_is_selected(interp) || words->comp == KLARTEXT_RL || words->comp == KLARTEXT_RR)
		return fault(&interp->at, words->first_column,
			     "radius compensation with PATHCTRL VECTOR is not supported; post the path of the tool's "
			     "centre with R0");
	if (!klartext_corner_check_none(interp) || !klartext_approach_check_none(interp) ||
	    !klartext_comp_check_known(interp, words->first_column, "PATHCTRL VECTOR"))
		return false;
	klartext->last = *path;
	if (!klartext_vector_go(interp, words->first_column, target, path->rapid, &path->feed))
		return false;
	klartext_comp_settle(interp, words);
	return true;
}

static bool make_path(struct interp *interp, const struct klartext_words *words, bool rapid,
		      const struct canon_feed *feed)
{
	struct klartext_target target;
	struct klartext_path path = {.rapid = rapid, .feed = *feed};

	if (klartext_comp_is_selected(interp) && words->axes >> SLOT_A)
		return fault(&interp->at, words->first_column,
			     "axes other than X, Y and Z under radius compensation are not supported");
	if (!check_waiting(interp, words) || !klartext_move_target(interp, words, &target) ||
	    ((words->tool_given || words->spatial) && !klartext_orient_target(interp, words, &target)) ||
	    !klartext_move_check(interp, &target, words->first_column))
		return false;
	path.known = !target.turns;
	if (target.turns && klartext_of(interp)->tcpm.by_vector && interp->state.tcp == TCP_BY_MCODE)
		return turn_by_vector(interp, words, &target, &path);
	path.start = klartext_frame_point(interp);
	path.end = target.point;
	return klartext_path_make(interp, words, &target, &path) && settle_plane(interp, &target, words->first_column);
}

static bool run_words(struct interp *interp, const struct klartext_words *words)
{
	struct canon_feed feed;
	bool rapid;

	if ((!words->axes || klartext_m_machine(words)) && !klartext_corner_check_none(interp))
		return false;
	if (!klartext_m_start(interp, words))
		return false;
	if (!words->axes && !klartext_comp_switch_standing(interp, words))
		return false;
	if (!words->axes && !words->tool_given && !words->spatial) {
		/* F alone applies to the next moves. */
		return (words->feed != KLARTEXT_FEED_VALUE && words->feed != KLARTEXT_FEED_AUTO) ||
		       klartext_move_feed(interp, words, &rapid, &feed);
	}
	if (!klartext_move_feed(interp, words, &rapid, &feed))
		return false;
	return klartext_m_machine(words) ? run_in_machine(interp, words, rapid, &feed)
					    : make_path(interp, words, rapid, &feed);
}

static bool check_line_words(struct lexer *lexer, const struct klartext_words *words)
{
	if (words->has_radius || words->has_angle)
		return fault(lexer->at, words->has_radius ? words->radius_column : words->angle_column,
			     "polar coordinates need LP or CP");
	if (words->has_size)
		return fault(lexer->at, words->size_column, "R with a radius belongs to CR, RND, APPR and DEP");
	if (words->direction || words->has_length || words->has_centre_angle)
		return fault(lexer->at, words->first_column, "DR, LEN and CCA belong to circles, APPR and DEP");
	return true;
}

static bool run(struct lexer *lexer, const struct klartext_words *words)
{
	struct interp *interp = lexer->context;

	return check_line_words(lexer, words) && run_words(interp, words) &&
	       klartext_cycle_call_modal(interp, words, words->axes || words->tool_given || words->spatial) &&
	       klartext_m_end(interp, words);
}

bool klartext_straight_run(struct lexer *lexer)
{
	struct klartext_words words;

	if (!klartext_words_read(lexer, &words))
		return false;
	if (words.normal_given || words.tool_given)
		return fault(lexer->at, words.first_column, "NX and TX belong to LN");
	return run(lexer, &words);
}

/*
 * "Three-dimensional tool compensation": if the block has a surface normal, the control shifts the tool along it by the
 * oversizes of TOOL CALL. Without oversizes the path is that of L.
 */
bool klartext_straight_run_normal(struct lexer *lexer)
{
	const struct interp *interp = lexer->context;
	struct klartext_words words;

	if (!klartext_words_read(lexer, &words))
		return false;
	if (klartext_of(interp)->tool.oversize)
		return fault(
		    lexer->at, words.first_column,
		    "LN with an oversize of the tool (DL, DR, DR2 of TOOL CALL): three-dimensional compensation is not "
		    "supported");
	return run(lexer, &words);
}

/*
 * "Calling a cycle with CYCL CALL POS": from above the workpiece the tool moves in the plane, then the cycle runs. Z
 * "serves as an additional datum shift". A start below the set-up clearance is refused.
 */
bool klartext_straight_cycle_position(struct lexer *lexer, double *shift)
{
	struct interp *interp = lexer->context;
	const unsigned plane = 1U << SLOT_X | 1U << SLOT_Y, all = plane | 1U << SLOT_Z;
	const struct canon_feed none = {0};
	struct klartext_target target;
	struct klartext_words words;
	double start;

	if (!klartext_words_read(lexer, &words) || !check_line_words(lexer, &words))
		return false;
	if (words.axes != all || words.increments)
		return fault(lexer->at, words.first_column, "CYCL CALL POS needs absolute coordinates of X, Y and Z");
	if (!klartext_m_start(interp, &words) || !klartext_move_target(interp, &words, &target) ||
	    !klartext_move_check(interp, &target, words.first_column))
		return false;
	target.point.z = klartext_frame_point(interp).z;
	if (!klartext_cycle_start(interp, &start) || target.point.z < start + words.value[SLOT_Z])
		return fault(
		    lexer->at, words.first_column,
		    "CYCL CALL POS from below the set-up clearance: how the tool gets there is not known here");
	if (!klartext_move_line(interp, &target, true, &none))
		return false;
	klartext_comp_settle(interp, &words);
	*shift = words.value[SLOT_Z];
	return true;
}
