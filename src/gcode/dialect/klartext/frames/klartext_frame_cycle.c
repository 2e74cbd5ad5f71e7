#include "gcode/dialect/klartext/frames/klartext_frame_cycle.h"

#include <math.h>
#include <stdarg.h>
#include <stdio.h>
#include <string.h>

#include "base/same_double.h"
#include "gcode/dialect/klartext/frames/klartext_frame.h"
#include "gcode/execute/tool_length.h"

/* TNC 640 user's manual: the last row of a datum table. */
#define KLARTEXT_ROW_MAX 9999

/* Reports a fault of a word of the definition, whose line may not be the current one. Returns false. */
__attribute__((format(printf, 3, 4))) static bool
word_fault(const struct interp *interp, const struct klartext_cycle_word *word, const char *format, ...)
{
	const struct line_place at = klartext_frame_place(interp, word->line);
	char text[320];
	va_list args;

	va_start(args, format);
	vsnprintf(text, sizeof(text), format, args);
	va_end(args);
	return fault(&at, word->column, "%s", text);
}

/* The axis of a word X, IX, Y ...; -1: the word names no axis. */
static int axis_of(const char *name, bool *increment)
{
	*increment = name[0] == 'I' && name[1] != '\0';
	name += *increment;
	return name[0] != '\0' && name[1] == '\0' ? slot_of_letter(name[0]) : -1;
}

/* Does a mirror image, a rotation or a scaling act between an existing shift and a new one? */
static bool has_turned(const struct klartext_frame *frame)
{
	struct klartext_frame bare = *frame;

	bare.inner = (vec3){0, 0, 0};
	return klartext_frame_is_inner(&bare);
}

/* Refuses a line without values, which posts write but an editor of the control does not. False: reported. */
static bool check_values(const struct interp *interp, const struct klartext_cycle *cycle, bool in_force,
			 const char *what, const char *words)
{
	const struct line_place at = klartext_frame_place(interp, cycle->line);

	return cycle->count > 0 || !in_force ||
	       fault(&at, cycle->column,
		     "a line without values while %s is in force: whether it cancels that is not known here; write %s",
		     what, words);
}

bool klartext_frame_cycle_is_shifted(const struct interp *interp, vec3 linear)
{
	bool shifted = vec3_norm2(linear) > 0;

	for (int slot = SLOT_A; slot < SLOT_COUNT; slot++)
		shifted |= !same_double(interp->state.shift.v[slot], 0);
	return shifted;
}

/* Row 5 of the datum table: the setup's <work_offset name="#5">. NULL: it has none. */
static const struct work_offset *find_row(const struct interp *interp, int number)
{
	const struct gcode_config *config = interp->config;
	char name[16];

	snprintf(name, sizeof(name), "#%d", number);
	for (size_t i = 0; i < config->work_offset_count; i++) {
		if (!strcmp(config->work_offsets[i].name, name))
			return &config->work_offsets[i];
	}
	return NULL;
}

/* Reads a row of the datum table as the words of a shift of all axes. False: reported. */
static bool read_row(struct interp *interp, const struct klartext_cycle *cycle, struct klartext_cycle *row)
{
	const struct klartext_cycle_word *word = &cycle->words[0];
	const struct work_offset *offset;

	if (cycle->count > 1 || !word->given || !(word->value >= 0 && word->value <= KLARTEXT_ROW_MAX) ||
	    !same_double(floor(word->value), word->value))
		return word_fault(interp, word,
				  "a row of the datum table is a whole number from 0 to %d, alone in its line",
				  KLARTEXT_ROW_MAX);
	offset = find_row(interp, (int)word->value);
	if (!offset && interp->config->has_setup)
		return word_fault(interp, word,
				  "the setup has no row %d of the datum table: add <work_offset name=\"#%d\" X=\"\" "
				  "Y=\"\" Z=\"\"/> with its values",
				  (int)word->value, (int)word->value);
	*row = (struct klartext_cycle){.number = cycle->number, .line = cycle->line, .column = cycle->column};
	for (int slot = 0; slot < SLOT_COUNT; slot++) {
		struct klartext_cycle_word *value = &row->words[row->count];

		if (!interp->config->has_axis[slot])
			continue;
		*value = (struct klartext_cycle_word){.given = true, .column = word->column, .line = word->line};
		value->name[0] = AXIS_LETTERS[slot];
		if (offset)
			value->value = state_from_canonical(slot, offset->value.v[slot]) /
				       (slot_is_rotary(slot) ? 1 : interp->state.scale);
		row->count++;
	}
	return true;
}

/*
 * The manual requires that shifts are cancelled in the reverse order. Posts cancel a shift from before the plane and a
 * shift in the plane of the same axis at once; the manual does not say what then remains of the first shift.
 */
static void note_order(struct klartext *klartext, int slot, bool increment)
{
	const vec3 before = klartext->frame.shift;
	const double outer[] = {before.x, before.y, before.z};

	if (klartext->frame.tilted && !same_double(outer[slot], 0))
		klartext->shift.in_plane |= 1U << slot;
	if (!klartext->frame.tilted && !increment)
		klartext->shift.open &= ~(1U << slot);
}

/*
 * iTNC 530 user's manual, "DATUM SHIFT (Cycle 7)": absolute values count from the preset, I values from the shift in
 * force. "WORKING PLANE (Cycle 19)", combining cycles: a shift before the tilting is in machine coordinates; a shift
 * after the tilting is in the tilted coordinates. While a mirror image, a rotation or a scaling is in force, only a
 * shift of 0 is known, because then the order does not matter.
 */
static bool shift(struct interp *interp, const struct klartext_cycle *cycle)
{
	struct klartext_frame *frame = &klartext_of(interp)->frame;
	vec3 *linear = frame->tilted ? &frame->inner : &frame->shift;
	double values[3] = {linear->x, linear->y, linear->z};
	slot_values shift = interp->state.shift;
	bool increment;

	if (!check_values(interp, cycle, klartext_frame_cycle_is_shifted(interp, *linear), "a datum shift",
			  "X+0, Y+0 and Z+0"))
		return false;
	for (int i = 0; i < cycle->count; i++) {
		const struct klartext_cycle_word *word = &cycle->words[i];
		int slot = axis_of(word->name, &increment);

		if (slot < 0 || !word->given)
			return word_fault(interp, word, "DATUM SHIFT needs an axis and a value here");
		if (!interp->config->has_axis[slot])
			return word_fault(interp, word, "the machine has no %c axis", AXIS_LETTERS[slot]);
		if (slot_is_rotary(slot) && frame->tilted && !same_double(word->value, 0))
			return word_fault(interp, word,
					  "a shift of a rotary axis in a tilted plane is not supported");
		if (slot <= SLOT_Z)
			note_order(klartext_of(interp), slot, increment);
		if (slot_is_rotary(slot) || slot > SLOT_Z)
			shift.v[slot] = word->value * (slot_is_rotary(slot) ? 1 : interp->state.scale) +
					(increment ? shift.v[slot] : 0);
		else
			values[slot] = word->value * interp->state.scale + (increment ? values[slot] : 0);
		if (slot <= SLOT_Z && has_turned(frame) && !(same_double(word->value, 0) && !increment))
			return word_fault(
			    interp, word,
			    "a datum shift while a mirror image, a rotation or a scaling is in force: whether it is "
			    "turned with them is not known here; shift the datum first");
	}
	for (int slot = SLOT_A; slot < SLOT_COUNT; slot++)
		klartext_of(interp)->rotary.shifted[slot] |= !same_double(shift.v[slot], interp->state.shift.v[slot]);
	*linear = (vec3){values[0], values[1], values[2]};
	interp->state.shift = shift;
	klartext_frame_update(interp);
	state_update_offset(&interp->state);
	return (interp->state.tcp != TCP_BY_MCODE || klartext_frame_check_zero(interp, cycle->column)) &&
	       tool_length_offsets_changed(interp, cycle->column);
}

/* "DATUM SHIFT with datum tables (Cycle 7)": a row of the table in place of values. */
bool klartext_frame_cycle_shift(struct interp *interp, const struct klartext_cycle *cycle)
{
	struct klartext_cycle row = {.number = cycle->number};

	if (cycle->count == 0 || cycle->words[0].name[0] != '#')
		return shift(interp, cycle);
	return read_row(interp, cycle, &row) && shift(interp, &row);
}

/*
 * The order of mirror image, rotation and unequal scaling matters, and it is not known which the control applies first.
 */
static bool check_order(struct interp *interp, const struct klartext_cycle *cycle, const struct klartext_frame *frame)
{
	const struct line_place at = klartext_frame_place(interp, cycle->line);
	bool mirrored = frame->mirror[0] || frame->mirror[1] || frame->mirror[2];
	bool rotated = !same_double(frame->rotation, 0);
	bool unequal = !same_double(frame->factor.x, frame->factor.y);

	if (mirrored && rotated)
		return fault(&at, cycle->column,
			     "a mirror image and a rotation at a time: their order is not known here; "
			     "cancel one of them first");
	if (unequal && rotated)
		return fault(&at, cycle->column,
			     "a rotation and factors that differ in X and Y at a time: their order is not "
			     "known here; cancel one of them first");
	return true;
}

static bool put(struct interp *interp, const struct klartext_cycle *cycle, const struct klartext_frame *frame)
{
	if (!check_order(interp, cycle, frame))
		return false;
	klartext_of(interp)->frame = *frame;
	klartext_frame_update(interp);
	return true;
}

/* "MIRROR IMAGE (Cycle 8)": mirrors the named axes at the datum; a cycle without axes cancels it. */
bool klartext_frame_cycle_mirror(struct interp *interp, const struct klartext_cycle *cycle)
{
	struct klartext_frame frame = klartext_of(interp)->frame;
	bool increment;

	memset(frame.mirror, 0, sizeof(frame.mirror));
	for (int i = 0; i < cycle->count; i++) {
		const struct klartext_cycle_word *word = &cycle->words[i];
		int slot = axis_of(word->name, &increment);

		if (slot < 0 || word->given || increment)
			return word_fault(interp, word, "MIRROR IMAGE needs axes without values here");
		if (slot > SLOT_Z)
			return word_fault(interp, word, "a mirror image of %c is not supported",
					  AXIS_LETTERS[slot]);
		frame.mirror[slot] = true;
	}
	return put(interp, cycle, &frame);
}

/* "ROTATION (Cycle 10)": about the datum in the working plane, counter-clockwise; IROT adds to the angle in force. */
bool klartext_frame_cycle_rotate(struct interp *interp, const struct klartext_cycle *cycle)
{
	struct klartext_frame frame = klartext_of(interp)->frame;

	if (!check_values(interp, cycle, !same_double(frame.rotation, 0), "a rotation", "ROT+0"))
		return false;
	for (int i = 0; i < cycle->count; i++) {
		const struct klartext_cycle_word *word = &cycle->words[i];
		bool increment = !strcmp(word->name, "IROT");

		if ((strcmp(word->name, "ROT") != 0 && !increment) || !word->given)
			return word_fault(interp, word, "ROTATION needs ROT and an angle here");
		frame.rotation = word->value + (increment ? frame.rotation : 0);
	}
	return put(interp, cycle, &frame);
}

static bool check_factor(struct interp *interp, const struct klartext_cycle_word *word)
{
	return (word->value > 0 && word->value < 100) ||
	       word_fault(interp, word, "a scaling factor must be more than 0 and less than 100");
}

/*
 * The manuals do not say whether the factors of cycles 11 and 26 multiply, or which of the cycles a factor of 1
 * cancels.
 */
static bool check_one_scaling(struct interp *interp, const struct klartext_cycle *cycle, int number)
{
	const int before = klartext_of(interp)->frame.scaled_by;
	const struct line_place at = klartext_frame_place(interp, cycle->line);

	return !klartext_frame_is_scaled(interp) || before == number ||
	       fault(&at, cycle->column, "CYCL DEF %d while CYCL DEF %d scales: cancel that first", number, before);
}

/*
 * "SCALING FACTOR (Cycle 11)": scales from the datum. A machine parameter decides whether it scales all three axes or
 * the plane only.
 */
bool klartext_frame_cycle_scale(struct interp *interp, const struct klartext_cycle *cycle)
{
	const enum cycle_11_axes axes = interp->config->controller.cycle_11_axes;
	struct klartext_frame frame = klartext_of(interp)->frame;

	if (!check_values(interp, cycle, klartext_frame_is_scaled(interp), "a scaling", "SCL 1"))
		return false;
	for (int i = 0; i < cycle->count; i++) {
		const struct klartext_cycle_word *word = &cycle->words[i];

		if (strcmp(word->name, "SCL") != 0 || !word->given)
			return word_fault(interp, word, "SCALING needs SCL and a factor here");
		if (!check_factor(interp, word))
			return false;
		if (!same_double(word->value, 1) && axes == CYCLE_11_AXES_UNKNOWN)
			return word_fault(
			    interp, word,
			    "a machine parameter says whether SCALING changes Z, too: set cycle_11_axes=\"plane\" "
			    "or \"all\" in the machine file's <controller>, or give the factors of X, Y and Z by "
			    "CYCL DEF 26");
		frame.factor = (vec3){word->value, word->value, axes == CYCLE_11_AXES_PLANE ? 1 : word->value};
		frame.centre = (vec3){0, 0, 0};
		frame.scaled_by = 11;
	}
	return check_one_scaling(interp, cycle, 11) && put(interp, cycle, &frame);
}

/* "AXIS-SPECIFIC SCALING (Cycle 26)": a factor for each axis, from a centre CCX, CCY, CCZ. */
bool klartext_frame_cycle_scale_axes(struct interp *interp, const struct klartext_cycle *cycle)
{
	struct klartext_frame frame = klartext_of(interp)->frame;
	double factor[3] = {1, 1, 1}, centre[3] = {0, 0, 0};
	bool named[3] = {false, false, false};

	if (!check_values(interp, cycle, klartext_frame_is_scaled(interp), "a scaling", "a factor of 1 for each axis"))
		return false;
	for (int i = 0; i < cycle->count; i++) {
		const struct klartext_cycle_word *word = &cycle->words[i];
		bool is_centre = !strncmp(word->name, "CC", 2) && word->name[2] != '\0';
		int slot = slot_of_letter(word->name[is_centre ? 2 : 0]);

		if (slot < SLOT_X || slot > SLOT_Z || !word->given || word->name[is_centre ? 3 : 1] != '\0')
			return word_fault(interp, word,
					  "AXIS-SPECIFIC SCALING needs X, Y, Z or CCX, CCY, CCZ with a value here");
		if (!is_centre && !check_factor(interp, word))
			return false;
		if (is_centre)
			centre[slot] = word->value * interp->state.scale;
		else
			factor[slot] = word->value;
		named[slot] |= !is_centre;
	}
	if ((!named[0] && !same_double(frame.factor.x, 1)) || (!named[1] && !same_double(frame.factor.y, 1)) ||
	    (!named[2] && !same_double(frame.factor.z, 1)))
		return word_fault(interp, &cycle->words[0],
				  "an axis is scaled that this CYCL DEF 26 does not name: whether it stays so is not "
				  "known here; name it, too");
	frame.factor = (vec3){factor[0], factor[1], factor[2]};
	frame.centre = (vec3){centre[0], centre[1], centre[2]};
	frame.scaled_by = 26;
	return check_one_scaling(interp, cycle, 26) && put(interp, cycle, &frame);
}
