#include "gcode/dialect/klartext/klartext_m.h"

#include <math.h>

#include "base/same_double.h"
#include "base/units.h"
#include "gcode/dialect/klartext/klartext_cycle.h"
#include "gcode/dialect/klartext/klartext_frame.h"
#include "gcode/dialect/klartext/klartext_tool.h"
#include "gcode/execute/motion_commands.h"
#include "gcode/execute/tool_length.h"

enum m_action {
	M_HARMLESS, M_HALT, M_END, M_TURN_RIGHT, M_TURN_LEFT, M_STAND, M_CHANGE, M_CALL, M_CALL_MODAL, M_MACHINE,
	M_SHORTEST, M_PLAIN, M_TCP_START, M_TCP_STOP, M_PER_REVOLUTION, M_PER_MINUTE, M_RETRACT, M_TILT_AXES, M_REDUCE,
	M_REFUSED
};

/* iTNC 530 and TNC 640 user's manuals, "Miscellaneous functions". Sorted by number. */
static const struct m_function {
	short number;
	enum m_action action;
	const char *what;	/* REFUSED */
} functions[] = {
	{0, M_HALT, NULL},
	{1, M_HALT, NULL},
	{2, M_END, NULL},
	{3, M_TURN_RIGHT, NULL},
	{4, M_TURN_LEFT, NULL},
	{5, M_STAND, NULL},
	{6, M_CHANGE, NULL},
	{7, M_HARMLESS, NULL},
	{8, M_HARMLESS, NULL},
	{9, M_HARMLESS, NULL},
	{13, M_TURN_RIGHT, NULL},
	{14, M_TURN_LEFT, NULL},
	{30, M_END, NULL},
	{89, M_CALL_MODAL, NULL},
	{90, M_HARMLESS, NULL},
	{91, M_MACHINE, NULL},
	{92, M_REFUSED, "coordinates from a point that the machine's builder has set; use M91"},
	{94, M_REDUCE, NULL},
	{97, M_HARMLESS, NULL},	/* and M98, M120: of radius compensation alone */
	{98, M_HARMLESS, NULL},
	{99, M_CALL, NULL},
	{101, M_REFUSED, "a change of tools when the tool's life ends"},
	{102, M_HARMLESS, NULL},
	{103, M_HARMLESS, NULL},	/* feeds only, as M109 to M111, M116, M117 */
	{104, M_REFUSED, "the datum that was set last"},
	{105, M_HARMLESS, NULL},
	{106, M_HARMLESS, NULL},
	{107, M_HARMLESS, NULL},
	{108, M_HARMLESS, NULL},
	{109, M_HARMLESS, NULL},
	{110, M_HARMLESS, NULL},
	{111, M_HARMLESS, NULL},
	{112, M_REFUSED, "transitions between contour elements"},
	{113, M_HARMLESS, NULL},
	{114, M_REFUSED, "compensation of the tilted axes' geometry"},
	{115, M_HARMLESS, NULL},
	{116, M_HARMLESS, NULL},
	{117, M_HARMLESS, NULL},
	{118, M_REFUSED, "moves of the handwheel during the program"},
	{120, M_HARMLESS, NULL},
	{124, M_REFUSED, "leaving out of points"},
	{126, M_SHORTEST, NULL},
	{127, M_PLAIN, NULL},
	{128, M_TCP_START, NULL},
	{129, M_TCP_STOP, NULL},
	{130, M_REFUSED, "coordinates of the untilted system in a tilted plane"},
	{134, M_HARMLESS, NULL},
	{135, M_HARMLESS, NULL},
	{136, M_PER_REVOLUTION, NULL},
	{137, M_PER_MINUTE, NULL},
	{138, M_TILT_AXES, NULL},
	{140, M_RETRACT, NULL},
	{141, M_HARMLESS, NULL},
	{142, M_REFUSED, "erasing of program information"},
	{143, M_REFUSED, "erasing of the basic rotation"},
	{144, M_REFUSED, "compensation of the machine's kinematics"},
	{145, M_HARMLESS, NULL},
	{148, M_HARMLESS, NULL},
	{149, M_HARMLESS, NULL},
	{197, M_REFUSED, "rounding of corners"},
};

static const struct m_function *find_function(int number)
{
	size_t low = 0, high = sizeof(functions) / sizeof(functions[0]);

	while (low < high) {
		size_t middle = (low + high) / 2;

		if (functions[middle].number == number)
			return &functions[middle];
		if (functions[middle].number < number)
			low = middle + 1;
		else
			high = middle;
	}
	return NULL;
}

/* What the machine file says of an M-function, or the control's own meaning. False: not known, which was reported. */
static bool find_action(struct interp *interp, const struct klartext_m *m, enum m_action *action)
{
	static const enum m_action actions[] = {
		[MCODE_TCP_ON] = M_TCP_START, [MCODE_TCP_OFF] = M_TCP_STOP, [MCODE_IGNORE] = M_HARMLESS,
		[MCODE_SPINDLE_ON] = M_TURN_RIGHT, [MCODE_SPINDLE_OFF] = M_STAND,
	};
	const struct controller *controller = &interp->config->controller;
	const struct m_function *found;

	for (size_t i = 0; i < controller->mcode_count; i++) {
		if (controller->mcodes[i].number == m->number) {
			*action = actions[controller->mcodes[i].action];
			return true;
		}
	}
	found = find_function(m->number);
	if (!found)
		return fault(&interp->at, m->column,
			     "M%d is not known; if it moves no axis, <mcode number=\"%d\" action=\"ignore\"/> in the "
			     "machine's <controller> says so",
			     m->number, m->number);
	if (found->action == M_REFUSED)
		return fault(&interp->at, m->column, "M%d: %s is not supported yet", m->number, found->what);
	*action = found->action;
	return true;
}

/* ------------------------------------------------------------------- start */

/* "M128": reset it before positioning with M91, and before TOOL CALL. */
static bool start_tcp(struct interp *interp, const struct klartext_m *m)
{
	struct klartext *klartext = klartext_of(interp);

	if (interp->state.tcp == TCP_BY_MCODE)
		return true;
	if (klartext->waits)
		return fault(&interp->at, m->column, "M128 before the rotary axes stand where PLANE ... STAY needs them");
	return klartext_frame_check_preset(interp, m->column) &&
	       tool_length_switch_tcp(interp, m->column, TCP_BY_MCODE);
}

/* "M94": reduces the display of rotary axes to less than 360 degrees; of positions there it does nothing. */
static bool reduce(struct interp *interp, const struct klartext_m *m)
{
	for (int slot = SLOT_A; slot <= SLOT_C; slot++) {
		if (!interp->config->has_axis[slot] || (m->way > 0 && !((unsigned)m->way & 1U << slot)))
			continue;
		if (fabs(interp->state.position.v[slot] - interp->state.offset.v[slot]) >= 360)
			return fault(&interp->at, m->column, "M94 where %c stands a turn or more away from 0 is not supported yet",
				     AXIS_LETTERS[slot]);
	}
	return true;
}

/* "M138": only the axes named tilt the plane. With all of them named, or none, nothing is left out. */
static bool select_axes(struct interp *interp, const struct klartext_m *m)
{
	unsigned named = (unsigned)m->way;

	for (int slot = SLOT_A; slot <= SLOT_C; slot++) {
		if (interp->config->has_axis[slot] && named && !(named & 1U << slot))
			return fault(&interp->at, m->column, "M138 that leaves %c out is not supported yet", AXIS_LETTERS[slot]);
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
		return fault(&interp->at, m->column, "M140 beside axis words: which comes first is not known here; write two blocks");
	if (!interp->kinematics->retract(interp->kinematics->context, line_loc(&interp->at, m->column), &way))
		return false;
	for (int slot = SLOT_X; slot <= SLOT_Z; slot++)
		target.v[slot] = way.position.v[slot];
	klartext_of(interp)->last.known = false;
	klartext_of(interp)->moved = true;
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

	if (!find_action(interp, m, &action))
		return false;
	switch (action) {
	case M_TURN_RIGHT:
		return turn_spindle(interp, SPINDLE_CLOCKWISE);
	case M_TURN_LEFT:
		return turn_spindle(interp, SPINDLE_COUNTERCLOCKWISE);
	case M_SHORTEST:
		klartext_of(interp)->shortest = true;
		return true;
	case M_TCP_START:
		return start_tcp(interp, m);
	case M_PER_REVOLUTION:
		return fault(&interp->at, m->column, "M136: a feed per revolution is not supported yet");
	case M_REDUCE:
		return reduce(interp, m);
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
	enum tcp_source back = klartext_of(interp)->frame.tilted ? TCP_BY_PLANE : TCP_OFF;

	return interp->state.tcp != TCP_BY_MCODE || tool_length_switch_tcp(interp, m->column, back);
}

/* "M2", "M30": subprograms may stand behind them, up to END PGM. */
static bool end_program(struct interp *interp, const struct klartext_m *m)
{
	struct klartext *klartext = klartext_of(interp);

	if (klartext->programs > 0)
		return fault(&interp->at, m->column, "M%d in a program that CALL PGM has called: a called program ends with END PGM",
			     m->number);
	klartext->behind_end = true;
	return motion_commands_spindle_stops(interp);
}

static bool end(struct interp *interp, const struct klartext_m *m)
{
	enum m_action action;

	if (!find_action(interp, m, &action))
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
		klartext_of(interp)->modal_call = true;
		return true;
	case M_PLAIN:
		klartext_of(interp)->shortest = false;
		return true;
	case M_TCP_STOP:
		return stop_tcp(interp, m);
	default:
		return true;
	}
}

bool klartext_m_end(struct interp *interp, const struct klartext_words *words)
{
	for (int i = 0; i < words->m_count; i++) {
		if (!end(interp, &words->m[i]))
			return false;
	}
	return true;
}
