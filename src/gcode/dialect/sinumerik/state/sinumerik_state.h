/* sinumerik_state.h - the state of the sinumerik dialect for a program. */
#ifndef FIVECHECK_GCODE_DIALECT_SINUMERIK_STATE_SINUMERIK_STATE_H
#define FIVECHECK_GCODE_DIALECT_SINUMERIK_STATE_SINUMERIK_STATE_H

#include "gcode/dialect/sinumerik/state/sinumerik_calls.h"
#include "gcode/dialect/sinumerik/state/sinumerik_frames.h"
#include "gcode/dialect/sinumerik/state/sinumerik_modes.h"
#include "gcode/dialect/sinumerik/state/sinumerik_values.h"
#include "gcode/state.h"

struct sinumerik {
	bool begun;	/* the first line has been read */
	bool headed;	/* the head of the program or its first block has been read */
	bool cautioned_rotary_way;	/* the warning about the assumed shorter way of a modulo axis was given */
	bool cautioned_mirror;	/* the warning that MD10612 may decide what MIRROR does was given */
	bool cautioned_limits;	/* the warning that the nearest rotary positions are past their limits was given */
	bool cautioned_orientation;	/* the warning that MD21104 may decide how the tool turns was given */
	int master;	/* the number of the spindle that S and M3 mean, less 1 */
	double feed_scale;	/* mm per unit of F, and of lengths in variables of the control */
	struct sinumerik_variables variables;
	struct sinumerik_macros macros;
	struct sinumerik_logic logic;
	struct sinumerik_passed passed;
	struct sinumerik_loops loops;
	struct sinumerik_search search;
	struct sinumerik_calls calls;
	struct sinumerik_modal modal;
	struct sinumerik_pattern pattern;
	struct sinumerik_contour contour;
	struct sinumerik_frames frames;
	struct sinumerik_place place;
	struct sinumerik_tangent tangent;
	struct sinumerik_polar polar;
	struct sinumerik_open_place open;
	struct sinumerik_tools tool;
	struct sinumerik_path path;
	struct sinumerik_orientation orientation;
	struct sinumerik_comp comp;
	struct sinumerik_soft soft;
};

static inline struct sinumerik *sinumerik_of(const struct interp *interp)
{
	return interp->dialect_state;
}

/* The innermost active call, or NULL. */
static inline struct sinumerik_call *sinumerik_top_call(struct sinumerik *sinumerik)
{
	return sinumerik->calls.depth ? &sinumerik->calls.items[sinumerik->calls.depth - 1] : NULL;
}

/* Is the modal call carried out after motions now? */
static inline bool sinumerik_modal_acts(const struct sinumerik *sinumerik)
{
	return sinumerik->modal.on && !(sinumerik->modal.running && sinumerik->calls.depth > sinumerik->modal.depth);
}

#endif
