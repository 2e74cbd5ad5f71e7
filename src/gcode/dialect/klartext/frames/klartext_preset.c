#include "gcode/dialect/klartext/frames/klartext_preset.h"

#include <math.h>
#include <string.h>

#include "base/same_double.h"
#include "gcode/dialect/klartext/frames/klartext_frame.h"
#include "gcode/execute/tool_length.h"
#include "gcode/execute/work_offset_use.h"

/* Is a rotary or a parallel axis shifted? */
static bool shifts_others(const struct interp *interp)
{
	for (int slot = SLOT_A; slot < SLOT_COUNT; slot++) {
		if (!same_double(interp->state.shift.v[slot], 0))
			return true;
	}
	return false;
}

/*
 * iTNC 530 and TNC 640 user's manuals, "DATUM SETTING (Cycle 247)": the preset takes a datum shift back; newer controls
 * cancel a mirror image, a rotation and a scaling, too.
 */
static void cancel_shift(struct interp *interp)
{
	struct klartext *klartext = klartext_of(interp);

	for (int slot = SLOT_A; slot < SLOT_COUNT; slot++) {
		klartext->rotary.shifted[slot] |= !same_double(interp->state.shift.v[slot], 0);
		interp->state.shift.v[slot] = 0;
	}
	klartext->frame.shift = (vec3){0, 0, 0};
	klartext->shift.in_plane = klartext->shift.open = 0;
	klartext_frame_update(interp);
}

static bool may_select(struct interp *interp, const struct klartext_cycle_word *word, const struct line_place *at)
{
	const struct klartext_frame *frame = &klartext_of(interp)->frame;

	if (!(word->value >= 0 && word->value <= EXTENDED_COUNT) || !same_double(floor(word->value), word->value))
		return fault(at, word->column,
			     "presets from 0 to %d are supported, as G54 and G54.1 P1 to P%d of the setup",
			     EXTENDED_COUNT, EXTENDED_COUNT);
	if (klartext_frame_is_inner(frame) || (frame->tilted && (!vec3_is_zero(frame->shift) || shifts_others(interp))))
		return fault(at, word->column,
			     "a preset while a mirror image, a rotation, a scaling or a shift in a tilted plane is in "
			     "force: which of them it cancels is not known here; cancel them first");
	return interp->state.tcp != TCP_BY_MCODE ||
	       fault(at, word->column, "a preset while M128 is in force is not supported; M129 first");
}

/* Row Q339 of the preset table, which a setup gives as G54.1 P<row>; row 0, the datum set by hand, as G54. */
bool klartext_preset_select(struct interp *interp, const struct klartext_cycle *cycle)
{
	struct klartext *klartext = klartext_of(interp);
	struct state *state = &interp->state;
	const struct klartext_cycle_word *word = cycle->count ? &cycle->words[0] : NULL;
	struct line_place at = klartext_frame_place(interp, cycle->line);
	const struct line_place here = interp->at;
	bool known;

	if (!word || strcmp(word->name, "Q339") != 0 || !word->given)
		return fault(&at, cycle->column, "DATUM SETTING needs Q339, the number of the preset");
	at = klartext_frame_place(interp, word->line);
	if (!may_select(interp, word, &at))
		return false;
	cancel_shift(interp);
	state->system = word->value > 0 ? SYSTEM_COUNT - 1 + (int)word->value : 0;
	klartext->preset.settled = true;
	klartext->preset.row = (int)word->value;
	klartext->preset.in_plane = klartext->frame.tilted;
	/* The fault is placed at the definition; the current line may be the next one. */
	interp->at = at;
	known = work_offset_use_require(interp, state->system, word->column);
	interp->at = here;
	return known && tool_length_offsets_changed(interp, word->column);
}

bool klartext_preset_check_plane(struct interp *interp, int column)
{
	return !klartext_of(interp)->preset.in_plane || fault(&interp->at, column,
							      "CYCL DEF 247 has selected a preset in a tilted plane: "
							      "whether the plane stays tilted is not known here; write "
							      "PLANE RESET first");
}

bool klartext_preset_check(struct interp *interp, int column)
{
	struct klartext_preset *preset = &klartext_of(interp)->preset;
	struct state *state = &interp->state;
	int known = 0, only = 0, others = 0;

	if (preset->settled)
		return true;
	for (int system = 0; system < SYSTEM_COUNT + EXTENDED_COUNT; system++) {
		if (!state->work_known[system])
			continue;
		others += known > 0 && !slot_values_same(&state->work[system], &state->work[only]);
		known++;
		only = system;
	}
	/* If all presets are equal, it does not matter which one is in force. */
	if (others > 0)
		return fault(
		    &interp->at, column,
		    "the setup has %d presets, and the program does not say which one is in force: select it by "
		    "CYCL DEF 247",
		    known);
	preset->settled = true;
	state->system = known ? only : 0;
	if (!known)
		work_offset_use_note(interp, 0, column);
	return tool_length_offsets_changed(interp, column);
}
