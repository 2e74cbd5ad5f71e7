#include "gcode/dialect/sinumerik/sinumerik_system.h"

#include <string.h>

#include "base/same_double.h"
#include "gcode/dialect/sinumerik/sinumerik_expr.h"
#include "gcode/dialect/sinumerik/sinumerik_frame.h"
#include "gcode/eval/expr.h"
#include "gcode/execute/probed_axes.h"

bool sinumerik_system_constant(const char *name, double *value)
{
	/* 840D sl, "High speed settings (CYCLE832)": S_TOLM. */
	static const struct {
		const char *name;
		double value;
	} constants[] = {{"TRUE", 1}, {"FALSE", 0}, {"_OFF", 0}, {"_FINISH", 1}, {"_SEMIFIN", 2}, {"_ROUGH", 3},
			 {"_PRECISION", 4}, {"_ORI_FINISH", 11}, {"_ORI_SEMIFIN", 12}, {"_ORI_ROUGH", 13},
			 {"_ORI_PRECISION", 14}};

	for (size_t i = 0; i < sizeof(constants) / sizeof(constants[0]); i++) {
		if (!strcmp(constants[i].name, name)) {
			*value = constants[i].value;
			return true;
		}
	}
	return false;
}

static double in_unit(const struct state *state, int slot, double value)
{
	return slot_is_rotary(slot) ? value : value / state->scale;
}

/* 840D sl, system variables: actual positions; the program is never ahead of the axes here. */
static bool read_position(struct interp *interp, const char *name, int slot, int column, double *value)
{
	struct state *state = &interp->state;

	if (!probed_axes_is_known(interp, slot, column))
		return false;
	if (!strcmp(name, "$AA_IM")) {
		if (state->tcp != TCP_OFF && !slot_is_rotary(slot))
			return fault(&interp->at, column, "$AA_IM of %c under TRAORI is not supported yet",
				     AXIS_LETTERS[slot]);
		*value = in_unit(state, slot, state->position.v[slot]);
		return true;
	}
	*value = in_unit(state, slot, sinumerik_frame_place(interp)->v[slot]);
	return true;
}

bool sinumerik_system_read(struct interp *interp, const char *name, int slot, int column, double *value)
{
	const struct sinumerik *sinumerik = sinumerik_of(interp);
	const bool position = !strcmp(name, "$AA_IW") || !strcmp(name, "$P_EP") || !strcmp(name, "$AA_IM");
	/* A program is checked as it runs: no search for a block, no simulation, no dry run. */
	static const char *const zero[] = {"$P_SEARCH", "$P_SIM", "$P_ISTEST", "$P_DRYRUN", "$P_SIMUL"};

	for (size_t i = 0; i < sizeof(zero) / sizeof(zero[0]); i++) {
		if (slot < 0 && !strcmp(name, zero[i])) {
			*value = 0;
			return true;
		}
	}
	if (position && slot >= 0)
		return read_position(interp, name, slot, column, value);
	if (!strcmp(name, "$P_TOOLNO") && slot < 0) {
		*value = interp->state.tool;
		return true;
	}
	if (!strcmp(name, "$P_TOOL") && slot < 0 && !sinumerik->edge_unsure) {
		*value = sinumerik->edge;
		return true;
	}
	if (!strcmp(name, "$P_TOOLL") && slot < 0)
		return fault(&interp->at, column, "%s needs an index, and is not supported yet", name);
	return fault(&interp->at, column, "the value of %s is known to the control alone", name);
}

/* --------------------------------------------------------------------- writing */

/* The work offset of $P_UIFR[n]: 1 is G54. */
static int system_of(int n)
{
	return n <= 4 ? n - 1 : SYSTEM_SETTABLE + n - 5;
}

static bool set_component(struct interp *interp, int system, int slot, double value)
{
	struct state *state = &interp->state;

	state->work[system].v[slot] = slot_is_rotary(slot) ? value : value * state->scale;
	state->work_known[system] = true;
	return true;
}

/* CTRANS(X,1,Y,2): what is not named is 0. */
static bool read_translation(struct interp *interp, struct lexer *lexer, int system)
{
	int slot;
	double value;

	if (!sinumerik_expr_take(lexer, "CTRANS"))
		return fault(lexer->at, expr_column(lexer),
			     "$P_UIFR is given a shift, CTRANS(), here; other frames are not "
			     "supported yet");
	for (slot = 0; slot < SLOT_COUNT; slot++)
		set_component(interp, system, slot, 0);
	if (!sinumerik_expr_need(lexer, '(', "CTRANS") || sinumerik_expr_take_byte(lexer, ')'))
		return lexer->at->text[lexer->position - 1] == ')';
	do {
		if (!sinumerik_expr_axis(interp, lexer, &slot) || !sinumerik_expr_need(lexer, ',', "the axis") ||
		    !sinumerik_expr_number(interp, lexer, &value) || !set_component(interp, system, slot, value))
			return false;
	} while (sinumerik_expr_take_byte(lexer, ','));
	return sinumerik_expr_need(lexer, ')', "CTRANS");
}

/*
 * 840D sl, system variables, $P_UIFR: a settable work offset; TR is its shift, FI the fine one, RT its turn. It takes
 * effect where the program selects the offset the next time.
 */
static bool write_offset(struct interp *interp, struct lexer *lexer, int column)
{
	char component[SINUMERIK_NAME + 1] = "";
	int n, slot, system;
	double value;

	if (!sinumerik_expr_need(lexer, '[', "$P_UIFR") ||
	    !sinumerik_expr_whole(interp, lexer, "the number of $P_UIFR", 1, 99, &n))
		return false;
	system = system_of(n);
	if (system == interp->state.system)
		return fault(&interp->at, column,
			     "$P_UIFR[%d] is the work offset in force, and takes effect at its next selection; select "
			     "G500 before it",
			     n);
	if (sinumerik_expr_take_byte(lexer, ']'))
		return sinumerik_expr_need(lexer, '=', "$P_UIFR[]") && read_translation(interp, lexer, system);
	if (!sinumerik_expr_need(lexer, ',', "the number of $P_UIFR") || !sinumerik_expr_axis(interp, lexer, &slot) ||
	    !sinumerik_expr_need(lexer, ',', "the axis"))
		return false;
	sinumerik_expr_name(lexer, component);
	if (!sinumerik_expr_need(lexer, ']', "TR") || !sinumerik_expr_need(lexer, '=', "$P_UIFR[]") ||
	    !sinumerik_expr_number(interp, lexer, &value))
		return false;
	if (!strcmp(component, "TR"))
		return set_component(interp, system, slot, value);
	if ((!strcmp(component, "FI") || !strcmp(component, "RT") || !strcmp(component, "MI")) && same_double(value, 0))
		return true;
	return fault(&interp->at, column, "$P_UIFR with %s is not supported yet, only with TR",
		     component[0] ? component : "no component");
}

bool sinumerik_system_write(struct interp *interp, struct lexer *lexer, const char *name, int column)
{
	static const char *const idle[] = {"$AC_TIMER", "$AC_MARKER", "$AC_PARAM"};
	double value;
	int index;

	if (!strcmp(name, "$P_UIFR"))
		return write_offset(interp, lexer, column);
	for (size_t i = 0; i < sizeof(idle) / sizeof(idle[0]); i++) {
		if (strcmp(idle[i], name) != 0)
			continue;
		if (sinumerik_expr_take_byte(lexer, '[') &&
		    (!sinumerik_expr_whole(interp, lexer, "an index", 0, 32767, &index) ||
		     !sinumerik_expr_need(lexer, ']', "an index")))
			return false;
		return sinumerik_expr_need(lexer, '=', name) && sinumerik_expr_number(interp, lexer, &value);
	}
	return fault(&interp->at, column, "%s: a program that writes data of the control is not supported yet", name);
}
