#include "gcode/dialect/sinumerik/values/sinumerik_system_write.h"

#include <string.h>

#include "base/same_double.h"
#include "gcode/dialect/sinumerik/frames/sinumerik_frame.h"
#include "gcode/dialect/sinumerik/values/sinumerik_expr.h"
#include "gcode/dialect/sinumerik/values/sinumerik_setting.h"
#include "gcode/dialect/sinumerik/values/sinumerik_system.h"
#include "gcode/dialect/sinumerik/words/sinumerik_name.h"
#include "gcode/eval/expr.h"
#include "gcode/execute/work_offset_use.h"

static bool set_component(struct interp *interp, int system, int slot, double value)
{
	struct state *state = &interp->state;

	state->work[system].v[slot] = slot_is_rotary(slot) ? value : value * sinumerik_of(interp)->feed_scale;
	state->work_known[system] = true;
	return true;
}

/* The values of a part of a frame for each axis, as they are written. */
struct part_values {
	bool has[SLOT_COUNT];
	double value[SLOT_COUNT];
};

/* (X,1,Y,2) after the name of a part, or (X,Y) if it has no values. */
static bool read_values(struct interp *interp, struct lexer *lexer, const char *name, bool valued,
			struct part_values *values)
{
	int slot;

	*values = (struct part_values){{false}, {0}};
	if (!sinumerik_name_need(lexer, '(', name))
		return false;
	while (lexer_peek(lexer) != ')') {
		if (!sinumerik_expr_axis(interp, lexer, &slot))
			return false;
		values->has[slot] = true;
		if (valued && (!sinumerik_name_need(lexer, ',', "the axis") ||
			       !sinumerik_expr_number(interp, lexer, &values->value[slot])))
			return false;
		if (!sinumerik_name_take_byte(lexer, ',') && lexer_peek(lexer) != ')')
			return fault(lexer->at, lexer_next_column(lexer), "',' or ')' is needed here");
	}
	lexer_take(lexer);
	return true;
}

/* Do all given values leave the coordinates unchanged? */
static bool all_are(const struct part_values *values, double nothing)
{
	for (int slot = 0; slot < SLOT_COUNT; slot++) {
		if (values->has[slot] && !same_double(values->value[slot], nothing))
			return false;
	}
	return true;
}

/* One part of $P_UIFR: CTRANS and the fine shift CFINE are added. */
static bool read_offset_part(struct interp *interp, struct lexer *lexer, slot_values *shift)
{
	static const struct {
		const char *name;
		bool shifts;
		double nothing;
	} parts[] = {{"CTRANS", true, 0}, {"CFINE", true, 0}, {"CROT", false, 0}, {"CSCALE", false, 1}};
	const int column = lexer_next_column(lexer);
	struct part_values values;
	size_t i = 0;

	while (i < sizeof(parts) / sizeof(parts[0]) && !sinumerik_name_take(lexer, parts[i].name))
		i++;
	if (i == sizeof(parts) / sizeof(parts[0]))
		return fault(lexer->at, column,
			     "$P_UIFR is given a shift, CTRANS(), here; other frames are not supported");
	if (!read_values(interp, lexer, parts[i].name, true, &values))
		return false;
	for (int slot = 0; slot < SLOT_COUNT && parts[i].shifts; slot++)
		shift->v[slot] += values.value[slot];
	return parts[i].shifts || all_are(&values, parts[i].nothing) ||
	       fault(lexer->at, column,
		     "$P_UIFR that turns or scales is not supported, only its shift; ROT and SCALE behind the work "
		     "offset can say it");
}

/* CTRANS(X,1,Y,2):CROT(Z,0): an axis that is not named has 0. */
static bool read_offset_frame(struct interp *interp, struct lexer *lexer, int system)
{
	slot_values shift = {{0}};

	do {
		if (!read_offset_part(interp, lexer, &shift))
			return false;
	} while (sinumerik_name_take_byte(lexer, ':'));
	for (int slot = 0; slot < SLOT_COUNT; slot++)
		set_component(interp, system, slot, shift.v[slot]);
	return true;
}

/*
 * 840D sl, system variables, $P_UIFR: a settable work offset. TR is its shift, FI the fine shift, RT its rotation. A
 * new value has an effect when the program selects the offset the next time.
 */
static bool write_offset(struct interp *interp, struct lexer *lexer, int column)
{
	char component[SINUMERIK_NAME + 1] = "";
	int n, slot, system;
	double value;

	if (!sinumerik_name_need(lexer, '[', "$P_UIFR") ||
	    !sinumerik_expr_whole(interp, lexer, "the number of $P_UIFR", 1, 99, &n))
		return false;
	system = sinumerik_system_of_offset(n);
	/* No move can come before that (sinumerik_place_check.h). */
	if (system == interp->state.system) {
		sinumerik_frame_place(interp);
		interp->state.work_assigned = true;
	}
	if (sinumerik_name_take_byte(lexer, ']'))
		return sinumerik_name_need(lexer, '=', "$P_UIFR[]") && read_offset_frame(interp, lexer, system);
	if (!sinumerik_name_need(lexer, ',', "the number of $P_UIFR") || !sinumerik_expr_axis(interp, lexer, &slot) ||
	    !sinumerik_name_need(lexer, ',', "the axis"))
		return false;
	sinumerik_name_read(lexer, component);
	if (!sinumerik_name_need(lexer, ']', "TR") || !sinumerik_name_need(lexer, '=', "$P_UIFR[]") ||
	    !sinumerik_expr_number(interp, lexer, &value))
		return false;
	if (!strcmp(component, "TR"))
		return set_component(interp, system, slot, value);
	if ((!strcmp(component, "FI") || !strcmp(component, "RT") || !strcmp(component, "MI")) && same_double(value, 0))
		return true;
	return fault(&interp->at, column, "$P_UIFR with %s is not supported, only with TR",
		     component[0] ? component : "no component");
}

/* $P_IFRAME=$P_UIFR[1]: a new value of the active work offset gets its effect. */
static bool renew_offset(struct interp *interp, struct lexer *lexer, int column)
{
	int n;

	if (!sinumerik_name_need(lexer, '=', "$P_IFRAME"))
		return false;
	if (!sinumerik_name_take(lexer, "$P_UIFR") || !sinumerik_name_need(lexer, '[', "$P_UIFR") ||
	    !sinumerik_expr_whole(interp, lexer, "the number of $P_UIFR", 1, 99, &n) ||
	    !sinumerik_name_need(lexer, ']', "the number of $P_UIFR") ||
	    sinumerik_system_of_offset(n) != interp->state.system || !sinumerik_of(interp)->frames.work_selected)
		return fault(&interp->at, column,
			     "$P_IFRAME is given the work offset that is in force here, $P_UIFR[1] of G54; others are "
			     "selected by G54 and the like");
	if (sinumerik_of(interp)->frames.swivelled)
		return fault(&interp->at, column, "$P_IFRAME while CYCLE800 has swivelled; CYCLE800() first");
	if (!work_offset_use_require(interp, interp->state.system, column))
		return false;
	sinumerik_frame_place(interp);
	interp->state.work_assigned = false;
	return sinumerik_frame_changed(interp, column);
}

/* One part of $P_PFRAME: the frame itself, if it comes first; CTRANS(X,1,Y,2), CROT(Z,30), CSCALE(X,2), CMIRROR(X). */
static bool read_part(struct interp *interp, struct lexer *lexer, bool first)
{
	static const struct {
		const char *name;
		enum sinumerik_frame_code code;
	} parts[] = {{"CTRANS", SINUMERIK_TRANS}, {"CROT", SINUMERIK_ROT}, {"CSCALE", SINUMERIK_SCALE},
		     {"CMIRROR", SINUMERIK_MIRROR}};
	const int column = lexer_next_column(lexer);
	struct sinumerik_frame_words words = {.added = !first, .column = column};
	struct part_values values;
	size_t i = 0;

	if (first && sinumerik_name_take(lexer, "$P_PFRAME"))
		return true;
	while (i < sizeof(parts) / sizeof(parts[0]) && !sinumerik_name_take(lexer, parts[i].name))
		i++;
	if (i == sizeof(parts) / sizeof(parts[0]))
		return fault(lexer->at, column, "CTRANS, CROT, CSCALE or CMIRROR is needed here");
	words.code = parts[i].code;
	if (!read_values(interp, lexer, parts[i].name, words.code != SINUMERIK_MIRROR, &values))
		return false;
	for (int slot = 0; slot < SLOT_COUNT; slot++) {
		const bool is_length = words.code == SINUMERIK_TRANS && !slot_is_rotary(slot);

		words.has[slot] = values.has[slot];
		words.value[slot] = values.value[slot] * (is_length ? sinumerik_of(interp)->feed_scale : 1);
	}
	/* The first one replaces the frame, with what G59 has set. */
	sinumerik_of(interp)->frames.programmed.axial &= !first;
	return sinumerik_frame_set(interp, &words);
}

/* May the programmable frame be changed? */
static bool check_frame(struct interp *interp, int column)
{
	if (interp->state.unknown_modes & 1U << G_UNITS)
		return fault(&interp->at, column, "$P_PFRAME needs G70, G71, G700 or G710 before it");
	if (sinumerik_of(interp)->frames.tool_frame)
		return fault(&interp->at, column, "frames while TOROT or TOFRAME is in force; TOROTOF first");
	if (sinumerik_of(interp)->frames.unsure)
		return fault(&interp->at, column, "frames after TRAORI or TRAFOOF: select the work offset again first");
	return true;
}

/* $P_PFRAME[X,TR]=5: the shift of the frame along one axis. */
static bool write_shift(struct interp *interp, struct lexer *lexer, int column)
{
	struct sinumerik *sinumerik = sinumerik_of(interp);
	char component[SINUMERIK_NAME + 1] = "";
	double value;
	int slot;

	if (!sinumerik_expr_axis(interp, lexer, &slot) || !sinumerik_name_need(lexer, ',', "the axis"))
		return false;
	sinumerik_name_read(lexer, component);
	if (!sinumerik_name_need(lexer, ']', "TR") || !sinumerik_name_need(lexer, '=', "$P_PFRAME[]") ||
	    !sinumerik_expr_number(interp, lexer, &value))
		return false;
	if (strcmp(component, "TR") != 0)
		return fault(&interp->at, column,
			     "$P_PFRAME with %s is not supported, only with TR; ROT, SCALE and MIRROR can say it",
			     component[0] ? component : "no component");
	if (sinumerik->frames.programmed_unsure)
		return fault(&interp->at, column,
			     "this changes a frame that CYCLE800() may have deleted; write TRANS before it");
	sinumerik->frames.programmed.shift.v[slot] = slot_is_rotary(slot) ? value : value * sinumerik->feed_scale;
	sinumerik->frames.programmed.fine.v[slot] = 0;
	return sinumerik_frame_changed(interp, column);
}

/* The programmable frame: ':' chains its parts, each in the coordinates of those before it. */
static bool write_frame(struct interp *interp, struct lexer *lexer, int column)
{
	bool first = true;

	if (!check_frame(interp, column))
		return false;
	if (sinumerik_name_take_byte(lexer, '['))
		return write_shift(interp, lexer, column);
	if (!sinumerik_name_need(lexer, '=', "$P_PFRAME"))
		return false;
	do {
		if (!read_part(interp, lexer, first))
			return false;
		first = false;
	} while (sinumerik_name_take_byte(lexer, ':'));
	return true;
}

/* Base frames: programs cancel them at their start; here there are none. */
static bool is_base_frame(const char *name)
{
	static const char *const frames[] = {"$P_UBFR", "$P_BFRAME", "$P_CHBFR", "$P_CHBFRAME",
					      "$P_NCBFR", "$P_NCBFRAME"};

	for (size_t i = 0; i < sizeof(frames) / sizeof(frames[0]); i++) {
		if (!strcmp(name, frames[i]))
			return true;
	}
	return false;
}

static bool refuse_base_frame(struct interp *interp, const char *name, int column)
{
	return fault(&interp->at, column,
		     "%s: of base frames only the shift of none, CTRANS(), is supported; a work offset can say it",
		     name);
}

/* $P_CHBFR[0]=CTRANS() */
static bool clear_base_frame(struct interp *interp, struct lexer *lexer, const char *name, int column)
{
	struct part_values values;
	int index;

	if (sinumerik_name_take_byte(lexer, '[') &&
	    (!sinumerik_expr_whole(interp, lexer, "the number of a base frame", 0, 15, &index) ||
	     !sinumerik_name_need(lexer, ']', "the number of a base frame")))
		return false;
	if (!sinumerik_name_need(lexer, '=', name))
		return false;
	if (!sinumerik_name_take(lexer, "CTRANS"))
		return refuse_base_frame(interp, name, column);
	return read_values(interp, lexer, "CTRANS", true, &values) &&
	       (all_are(&values, 0) || refuse_base_frame(interp, name, column));
}

bool sinumerik_system_write(struct interp *interp, struct lexer *lexer, const char *name, int column)
{
	double value;
	int index;

	if (!strcmp(name, "$P_UIFR"))
		return write_offset(interp, lexer, column);
	if (!strcmp(name, "$P_PFRAME"))
		return write_frame(interp, lexer, column);
	if (!strcmp(name, "$P_IFRAME"))
		return renew_offset(interp, lexer, column);
	if (is_base_frame(name))
		return clear_base_frame(interp, lexer, name, column);
	if (sinumerik_system_is_scratch(name)) {
		if (sinumerik_name_take_byte(lexer, '[') &&
		    (!sinumerik_expr_whole(interp, lexer, "an index", 0, 32767, &index) ||
		     !sinumerik_name_need(lexer, ']', "an index")))
			return false;
		return sinumerik_name_need(lexer, '=', name) && sinumerik_expr_number(interp, lexer, &value);
	}
	return sinumerik_setting_write(interp, lexer, name, column);
}
