#include "gcode/dialect/sinumerik/frames/sinumerik_place_check.h"

#include "base/same_double.h"
#include "gcode/execute/work_offset_use.h"

#define LINEAR_BITS (letter_bit('X') | letter_bit('Y') | letter_bit('Z'))

/* 840D sl, MD20270: the edge that is active after M6. */
bool sinumerik_place_check_edge(const struct interp *interp, int column)
{
	if (!sinumerik_of(interp)->tool.edge_unsure)
		return true;
	return fault(&interp->at, column,
		     "a parameter of the control (MD20270) decides which D holds after M6: write D, or set "
		     "edge_after_tool_change=\"first\" (D1), \"none\" (D0) or \"keeps\" in the machine file's "
		     "<controller>");
}

/*
 * MD22550: either T changes the tool, or M6 does. If the program has an M6 anywhere, M6 does; else T may have changed
 * the tool.
 */
bool sinumerik_place_check_tool(const struct interp *interp, int column)
{
	const struct sinumerik *sinumerik = sinumerik_of(interp);
	const struct state *state = &interp->state;

	return interp->config->controller.t_changes_tool != ANSWER_UNKNOWN || !sinumerik->tool.t_waits ||
	       sinumerik->tool.changed || sinumerik->tool.changes_ahead || state->selected == state->tool ||
	       fault(&interp->at, column,
		     "T without any M6: a parameter of the control (MD22550) decides whether T changes the tool by "
		     "itself: write M6, or set t_changes_tool=\"yes\" or \"no\" in the machine file's <controller>");
}

/*
 * Does a work offset of the setup shift an axis of these letters? X, Y and Z count together, because frames may
 * rotate them.
 */
static bool is_shifted(const struct interp *interp, uint32_t letters)
{
	const bool linear = letters & LINEAR_BITS;

	for (size_t i = 0; i < interp->config->work_offset_count; i++) {
		for (int slot = 0; slot < SLOT_COUNT; slot++) {
			const bool moves = slot <= SLOT_Z ? linear : (letters & letter_bit(AXIS_LETTERS[slot]));

			if (moves && !same_double(interp->config->work_offsets[i].value.v[slot], 0))
				return true;
		}
	}
	return false;
}

/* CYCLE800() may have deleted the programmable frame: does this frame shift or rotate the axes of these letters? */
static bool unsure_frame_counts(const struct sinumerik *sinumerik, uint32_t letters)
{
	if (!sinumerik->frames.programmed_unsure)
		return false;
	for (int slot = SLOT_A; slot < SLOT_COUNT; slot++) {
		if ((letters & letter_bit(AXIS_LETTERS[slot])) &&
		    !same_double(sinumerik->frames.programmed.shift.v[slot], 0))
			return true;
	}
	return (letters & LINEAR_BITS) || !(letters & AXIS_BITS);
}

/* A parameter may make a work offset of the setup active at power-on. */
bool sinumerik_place_check_frames(const struct interp *interp, uint32_t letters, int column)
{
	const struct sinumerik *sinumerik = sinumerik_of(interp);

	if (interp->state.work_assigned)
		return work_offset_use_fault(interp, column);
	if (sinumerik->frames.unsure)
		return fault(
		    &interp->at, column,
		    "a parameter of the control (MD10602) decides whether frames and work offsets outlive TRAORI "
		    "and TRAFOOF: select the work offset again, or set frames_outlive_traori=\"yes\" or \"no\" in "
		    "the machine file's <controller>");
	if (sinumerik->frames.plane_unsure)
		return fault(&interp->at, column,
			     "another work offset was selected while CYCLE800 has swivelled, and whether the plane "
			     "goes with it is not certain: write CYCLE800 behind it");
	if (unsure_frame_counts(sinumerik, letters))
		return fault(&interp->at, column,
			     "CYCLE800() was called while TRANS, ROT, SCALE or MIRROR was in force, and whether it "
			     "deletes them is not certain: write TRANS, or TRANS with its values, behind it, or "
			     "set frames_outlive_cycle800=\"yes\" or \"no\" in the machine file's <controller>");
	if (sinumerik->frames.work_selected || !is_shifted(interp, letters))
		return true;
	return fault(
	    &interp->at, column,
	    "a parameter of the control (MD20150) decides which work offset is in force at power-on: select G54 or "
	    "the like, or G500, or set power_on_work_offset=\"G500\" or \"G54\" in the machine file's <controller>");
}

bool sinumerik_place_check(const struct interp *interp, int slot, int column)
{
	return (slot > SLOT_Z || sinumerik_place_check_edge(interp, column)) &&
	       sinumerik_place_check_frames(interp, letter_bit(AXIS_LETTERS[slot]), column);
}
