#include "gcode/dialect/klartext/machine/klartext_m.h"

#include <math.h>

#include "base/same_double.h"
#include "base/units.h"
#include "gcode/dialect/klartext/cycles/klartext_cycle.h"
#include "gcode/dialect/klartext/frames/klartext_frame.h"
#include "gcode/dialect/klartext/frames/klartext_preset.h"
#include "gcode/dialect/klartext/machine/klartext_tool.h"
#include "gcode/dialect/klartext/moves/klartext_comp.h"
#include "gcode/dialect/klartext/moves/klartext_move.h"
#include "gcode/execute/motion_commands.h"
#include "gcode/execute/tool_length.h"

enum m_action {
	M_HARMLESS,
	M_HALT,
	M_END,
	M_TURN_RIGHT,
	M_TURN_LEFT,
	M_STAND,
	M_CHANGE,
	M_CALL,
	M_CALL_MODAL,
	M_SHORTEST,
	M_PLAIN,
	M_TCP_START,
	M_TCP_STOP,
	M_RETRACT,
	M_TILT_AXES,
	M_REDUCE,
	M_LOOK_AHEAD,
	M_PER_REVOLUTION,
	M_PER_MINUTE,
	M_UNROTATE
};

/* The effects of the M-functions that are read; klartext_codes.c says which others are refused or ignored. */
static enum m_action action_of(int number)
{
	static const struct {
		short number;
		short action;
	} actions[] = {
	    {0, M_HALT},	 {1, M_HALT},	     {2, M_END},
	    {3, M_TURN_RIGHT},	 {4, M_TURN_LEFT},   {5, M_STAND},
	    {6, M_CHANGE},	 {13, M_TURN_RIGHT}, {14, M_TURN_LEFT},
	    {30, M_END},	 {89, M_CALL_MODAL}, {94, M_REDUCE},
	    {99, M_CALL},	 {126, M_SHORTEST},  {127, M_PLAIN},
	    {120, M_LOOK_AHEAD}, {128, M_TCP_START}, {129, M_TCP_STOP},
	    {138, M_TILT_AXES},	 {140, M_RETRACT},   {136, M_PER_REVOLUTION},
	    {137, M_PER_MINUTE}, {143, M_UNROTATE},
	};

	for (size_t i = 0; i < sizeof(actions) / sizeof(actions[0]); i++) {
		if (actions[i].number == number)
			return (enum m_action)actions[i].action;
	}
	return M_HARMLESS;
}

/* What to write instead of a function that changes the position of the tool; NULL: the function may be left out. */
static const char *instead_of(int number)
{
	switch (number) {
	case 104:
		return "select the datum by CYCL DEF 247, CYCL DEF 7 or TRANS DATUM";
	case 114:
	case 144:
		return "write M128, or give the positions of the axes without it";
	case 130:
		return "write PLANE RESET before this block, or give the positions of the axes with M91";
	default:
		return NULL;
	}
}

/* The action of an M-function by the machine file or the control. False: it is not known, which was reported. */
static bool find_action(struct interp *interp, const struct klartext_m *m, enum m_action *action)
{
	static const enum m_action actions[] = {
	    [MCODE_TCP_ON] = M_TCP_START,      [MCODE_TCP_OFF] = M_TCP_STOP,  [MCODE_IGNORE] = M_HARMLESS,
	    [MCODE_SPINDLE_ON] = M_TURN_RIGHT, [MCODE_SPINDLE_OFF] = M_STAND,
	};
	const struct controller *controller = &interp->config->controller;
	const struct code *found;

	for (size_t i = 0; i < controller->mcode_count; i++) {
		if (controller->mcodes[i].number == m->number) {
			*action = actions[controller->mcodes[i].action];
			return true;
		}
	}
	found = code_find(interp->config->dialect->m_codes, m->number);
	if (!found)
		return fault(&interp->at, m->column,
			     "M%d is not known; if it moves no axis, set <mcode number=\"%d\" action=\"ignore\"/> "
			     "in the machine file's <controller>",
			     m->number, m->number);
	if (found->state == CODE_REFUSED && instead_of(m->number))
		return fault(&interp->at, m->column, "M%d: %s is not supported; %s", m->number, found->what,
			     instead_of(m->number));
	if (found->state == CODE_REFUSED)
		return fault(&interp->at, m->column,
			     "M%d: %s is not supported; if it may be left out, set <mcode number=\"%d\" "
			     "action=\"ignore\"/> in the machine file's <controller>",
			     m->number, found->what, m->number);
	/* "M118" without limits ends an M118 with limits. */
	if (m->number == 118 && m->way > 0)
		return fault(
		    &interp->at, m->column,
		    "M118: handwheel moves during the program are not supported; if they may be left out, set "
		    "<mcode number=\"118\" action=\"ignore\"/> in the machine file's <controller>");
	*action = action_of(m->number);
	return true;
}

/* Under radius compensation moves are delayed, and some functions would change the delayed moves. False: reported. */
static bool check_comp(struct interp *interp, const struct klartext_m *m, enum m_action action)
{
	if (!klartext_comp_is_selected(interp))
		return true;
	switch (action) {
	case M_HARMLESS:
		if (m->number == 98)
			break;
		return true;
	case M_LOOK_AHEAD:
		if (m->way > 0)
			break;
		return true;
	case M_TURN_RIGHT:
	case M_TURN_LEFT:
	case M_STAND:
	case M_SHORTEST:
	case M_PLAIN:
	case M_END:
		return true;
	default:
		break;
	}
	return fault(&interp->at, m->column, "M%d under radius compensation is not supported; R0 comes first",
		     m->number);
}

/* Does the function take effect at the end of a block, without a move? */
static bool is_end(enum m_action action)
{
	return action == M_END || action == M_STAND || action == M_PLAIN;
}

/* Does the function take effect at the start of a block, or is its place of no consequence? It moves no axis. */
static bool is_harmless(enum m_action action)
{
	return action == M_HARMLESS || action == M_TURN_RIGHT || action == M_TURN_LEFT || action == M_SHORTEST;
}

bool klartext_m_check_harmless(struct interp *interp, const struct klartext_words *words, const char *where, bool ends)
{
	for (int i = 0; i < words->m_count; i++) {
		enum m_action action;

		if (!find_action(interp, &words->m[i], &action))
			return false;
		if (!is_harmless(action) && !(ends && is_end(action)))
			return fault(&interp->at, words->m[i].column,
				     "M%d %s is not supported: write it into a block of its own", words->m[i].number,
				     where);
	}
	return true;
}

/* ------------------------------------------------------------------- start */

/* "M128": reset it before positioning with M91, and before TOOL CALL. */
static bool start_tcp(struct interp *interp, const struct klartext_m *m)
{
	struct klartext *klartext = klartext_of(interp);

	klartext->tcpm.spatial = klartext->tcpm.by_vector = false;
	if (interp->state.tcp == TCP_BY_MCODE)
		return true;
	if (klartext->corner.waits)
		return fault(&interp->at, m->column,
			     "M128 in the block behind RND or CHF is not supported: write it into a block of its own");
	if (!klartext_comp_check_known(interp, m->column, "M128"))
		return false;
	if (klartext->stay.waits)
		return fault(&interp->at, m->column,
			     "M128 before the rotary axes stand where PLANE ... STAY needs them");
	return klartext_preset_check(interp, m->column) && klartext_frame_check_zero(interp, m->column) &&
	       tool_length_switch_tcp(interp, m->column, TCP_BY_MCODE);
}

/*
 * "M94": reduces the display of rotary axes to less than 360 degrees. It does nothing if the positions already lie
 * there.
 */
static bool reduce(struct interp *interp, const struct klartext_m *m)
{
	for (int slot = SLOT_A; slot <= SLOT_C; slot++) {
		/* An axis with wrap always has a reduced display. */
		if (!interp->config->has_axis[slot] || interp->config->wrap[slot] != WRAP_NONE ||
		    (m->way > 0 && !((unsigned)m->way & 1U << slot)))
			continue;
		if (fabs(interp->state.position.v[slot] - interp->state.offset.v[slot]) >= 360)
			return fault(&interp->at, m->column,
				     "M94 where %c stands a turn or more away from 0 is not supported",
				     AXIS_LETTERS[slot]);
	}
	return true;
}

/* "M138": only the named axes tilt the plane. If all are named, or none, M138 changes nothing. */
static bool select_axes(struct interp *interp, const struct klartext_m *m)
{
	unsigned named = (unsigned)m->way;

	for (int slot = SLOT_A; slot <= SLOT_C; slot++) {
		if (interp->config->has_axis[slot] && named && !(named & 1U << slot))
			return fault(&interp->at, m->column, "M138 that leaves %c out is not supported",
				     AXIS_LETTERS[slot]);
	}
	return true;
}

/* "M140": away from the contour along the tool's axis, by MB or up to the limit of travel. */
static bool retract(struct interp *interp, const struct klartext_words *words, const struct klartext_m *m)
{
	struct kinematics_retract way = {
	    .to_limit = m->to_limit, .distance = m->way, .position = interp->state.canonical};
	struct canon_move move = {.kind = CANON_RAPID};
	slot_values target = interp->state.position;

	if (!m->has_way)
		return fault(&interp->at, m->column, "M140 needs MB and a way, or MB MAX");
	if (m->way < 0)
		return fault(&interp->at, m->column, "the way of M140 cannot be negative");
	if (words->axes)
		return fault(&interp->at, m->column,
			     "M140 beside axis words: which comes first is not known here; write two blocks");
	if (!interp->kinematics->retract(interp->kinematics->context, line_loc(&interp->at, m->column), &way))
		return false;
	for (int slot = SLOT_X; slot <= SLOT_Z; slot++)
		target.v[slot] = way.position.v[slot];
	klartext_of(interp)->last.known = false;
	klartext_of(interp)->tool.moved = true;
	return motion_commands_go(interp, &target, &move);
}

static bool turn_spindle(struct interp *interp, enum spindle_turn turn)
{
	interp->state.spindle = turn;
	return true;
}

static bool start(struct interp *interp, const struct klartext_words *words, const struct klartext_m *m)
{
	enum m_action action;

	if (!find_action(interp, m, &action) || !check_comp(interp, m, action))
		return false;
	switch (action) {
	case M_TURN_RIGHT:
		return turn_spindle(interp, SPINDLE_CLOCKWISE);
	case M_TURN_LEFT:
		return turn_spindle(interp, SPINDLE_COUNTERCLOCKWISE);
	case M_SHORTEST:
		klartext_of(interp)->rotary.shortest = true;
		return true;
	case M_TCP_START:
		return start_tcp(interp, m);
	case M_REDUCE:
		return reduce(interp, m);
	case M_LOOK_AHEAD:
		klartext_of(interp)->crossing.looks_ahead = m->way > 0;
		return true;
	case M_PER_REVOLUTION:
	case M_PER_MINUTE:
		klartext_of(interp)->per_revolution = action == M_PER_REVOLUTION;
		return true;
	case M_UNROTATE:
		caution(&interp->at, m->column,
			"M143 erases the basic rotation of the preset: the setup's presets have none, and the blocks "
			"before are read without one, too");
		return true;
	case M_TILT_AXES:
		return select_axes(interp, m);
	case M_RETRACT:
		return retract(interp, words, m);
	default:
		return true;
	}
}

bool klartext_m_start(struct interp *interp, const struct klartext_words *words)
{
	if (words->has_speed) {
		interp->state.speed = words->speed;
		interp->state.speed_is_zero = !(words->speed > 0);
	}
	for (int i = 0; i < words->m_count; i++) {
		if (!start(interp, words, &words->m[i]))
			return false;
	}
	return true;
}

/* --------------------------------------------------------------------- end */

static bool stand(struct interp *interp)
{
	if (!motion_commands_spindle_stops(interp))
		return false;
	interp->state.spindle = SPINDLE_STOPPED;
	return true;
}

static bool stop_tcp(struct interp *interp, const struct klartext_m *m)
{
	klartext_of(interp)->tcpm.spatial = false;
	return interp->state.tcp != TCP_BY_MCODE || klartext_move_end_tcp(interp, m->column);
}

/* "M2", "M30": subprograms may stand behind them, up to END PGM. */
static bool end_program(struct interp *interp, const struct klartext_m *m)
{
	struct klartext *klartext = klartext_of(interp);

	if (klartext->calls.programs > 0)
		return fault(&interp->at, m->column,
			     "M%d in a program that CALL PGM has called: a called program ends with END PGM",
			     m->number);
	klartext->lines.behind_end = true;
	return klartext_comp_end(interp, m->column) && motion_commands_spindle_stops(interp);
}

static bool end(struct interp *interp, const struct klartext_m *m)
{
	enum m_action action;

	if (!find_action(interp, m, &action) || !check_comp(interp, m, action))
		return false;
	switch (action) {
	case M_HALT:
		return motion_commands_spindle_stops(interp);
	case M_END:
		return end_program(interp, m);
	case M_STAND:
		return stand(interp);
	case M_CHANGE:
		return klartext_tool_m6(interp, m->column);
	case M_CALL:
		return klartext_cycle_call(interp, m->column);
	case M_CALL_MODAL:
		klartext_of(interp)->cycles.modal = true;
		return klartext_cycle_call(interp, m->column);
	case M_PLAIN:
		klartext_of(interp)->rotary.shortest = false;
		return true;
	case M_TCP_STOP:
		return stop_tcp(interp, m);
	default:
		return true;
	}
}

/*
 * A program that M99 calls (CYCL DEF 12) runs from the next line on. The effect of an M-function behind M99 would come
 * before the program, and not after it.
 */
static bool check_behind_call(struct interp *interp, const struct klartext_words *words, int call)
{
	enum m_action action;

	if (words->m[call].number != 99 || klartext_of(interp)->cycles.active.number != 12)
		return true;
	for (int i = call + 1; i < words->m_count; i++) {
		const struct klartext_m *m = &words->m[i];

		if (!find_action(interp, m, &action))
			return false;
		if (!is_harmless(action))
			return fault(&interp->at, m->column,
				     "M%d behind M99 that calls a program (CYCL DEF 12) is not supported: write it "
				     "into a block of its own",
				     m->number);
	}
	return true;
}

bool klartext_m_end(struct interp *interp, const struct klartext_words *words)
{
	for (int i = 0; i < words->m_count; i++) {
		if (!check_behind_call(interp, words, i) || !end(interp, &words->m[i]))
			return false;
	}
	return true;
}
