#include "gcode/dialect/klartext/frames/klartext_transform.h"

#include <math.h>
#include <string.h>

#include "gcode/dialect/klartext/frames/klartext_frame_cycle.h"
#include "gcode/dialect/klartext/frames/klartext_preset.h"
#include "gcode/dialect/klartext/text/klartext_lexis.h"
#include "gcode/dialect/klartext/values/klartext_value.h"
#include "gcode/dialect/klartext/words/klartext_cycle_words.h"

/* The manual does not say whether an axis that is not named keeps its shift. */
static bool check_datum(struct lexer *lexer, const struct klartext_cycle *cycle)
{
	struct interp *interp = lexer->context;
	const struct klartext_frame *frame = &klartext_of(interp)->frame;
	const vec3 linear = frame->tilted ? frame->inner : frame->shift;
	const double shifts[3] = {linear.x, linear.y, linear.z};

	for (int slot = SLOT_X; slot <= SLOT_C; slot++) {
		bool named = false;

		for (int i = 0; i < cycle->count; i++)
			named = named || strchr(cycle->words[i].name, AXIS_LETTERS[slot]);
		if (!named && fabs(slot <= SLOT_Z ? shifts[slot] : interp->state.shift.v[slot]) > 0)
			return fault(
			    lexer->at, cycle->column,
			    "TRANS DATUM without %c, which is shifted: whether the shift stays is not known here; "
			    "write %c, too",
			    AXIS_LETTERS[slot], AXIS_LETTERS[slot]);
	}
	return true;
}

/* "TRANS DATUM TABLE TABLINE5": a row, and the name of its table unless SEL TABLE has selected the table. */
static bool read_row(struct lexer *lexer, struct klartext_cycle *cycle)
{
	struct klartext_cycle_word *row = &cycle->words[0];

	if (!klartext_take(lexer, "TABLINE"))
		return fault(lexer->at, lexer_next_column(lexer), "TRANS DATUM TABLE needs TABLINE and a row");
	*row = (struct klartext_cycle_word){
	    .name = "#", .given = true, .column = lexer_next_column(lexer), .line = lexer->at->line};
	cycle->count = 1;
	return klartext_value(lexer, &row->value) && (klartext_ends(lexer) || klartext_transform_table(lexer));
}

/* "TRANS DATUM": AXIS and absolute values shift the datum as CYCL DEF 7 does; RESET cancels the shift. */
static bool shift(struct lexer *lexer, struct klartext_cycle *cycle)
{
	const struct interp *interp = lexer->context;

	if (klartext_take(lexer, "RESET")) {
		for (int slot = SLOT_X; slot <= SLOT_C; slot++) {
			if (interp->config->has_axis[slot] &&
			    !klartext_cycle_words_add_axis(cycle, AXIS_LETTERS[slot], 0))
				return false;
		}
		return klartext_expect_end(lexer) && klartext_frame_cycle_shift(lexer->context, cycle);
	}
	if (klartext_take(lexer, "TABLE"))
		return read_row(lexer, cycle) && klartext_frame_cycle_shift(lexer->context, cycle);
	if (!klartext_take(lexer, "AXIS"))
		return fault(lexer->at, lexer_next_column(lexer), "TRANS DATUM needs AXIS, TABLE or RESET");
	return klartext_cycle_words_read(lexer, cycle) && check_datum(lexer, cycle) &&
	       klartext_frame_cycle_shift(lexer->context, cycle);
}

/* "TRANS MIRROR": AXIS with the letters of axes, as CYCL DEF 8. */
static bool mirror(struct lexer *lexer, struct klartext_cycle *cycle)
{
	struct interp *interp = lexer->context;
	const bool *mirrored = klartext_of(interp)->frame.mirror;

	if (klartext_take(lexer, "RESET"))
		return klartext_expect_end(lexer) && klartext_frame_cycle_mirror(interp, cycle);
	if (!klartext_take(lexer, "AXIS") || !klartext_cycle_words_read(lexer, cycle))
		return fault(lexer->at, lexer_next_column(lexer), "TRANS MIRROR needs AXIS and the letters of axes");
	for (int slot = SLOT_X; slot <= SLOT_Z; slot++) {
		bool named = false;

		for (int i = 0; i < cycle->count; i++)
			named = named || strchr(cycle->words[i].name, AXIS_LETTERS[slot]);
		if (mirrored[slot] && !named)
			return fault(lexer->at, cycle->column,
				     "TRANS MIRROR without %c, which is mirrored: whether it stays so is not known "
				     "here; write TRANS MIRROR RESET first",
				     AXIS_LETTERS[slot]);
	}
	return klartext_frame_cycle_mirror(interp, cycle);
}

/* "TRANS ROTATION": ROT with an angle, as CYCL DEF 10. */
static bool rotate(struct lexer *lexer, struct klartext_cycle *cycle)
{
	if (klartext_take(lexer, "RESET")) {
		cycle->words[cycle->count++] = (struct klartext_cycle_word){.name = "ROT", .given = true};
		return klartext_expect_end(lexer) && klartext_frame_cycle_rotate(lexer->context, cycle);
	}
	return klartext_cycle_words_read(lexer, cycle) && klartext_frame_cycle_rotate(lexer->context, cycle);
}

/* "TRANS SCALE": SCL with a factor, as CYCL DEF 11. */
static bool scale(struct lexer *lexer, struct klartext_cycle *cycle)
{
	if (klartext_take(lexer, "RESET")) {
		cycle->words[cycle->count++] = (struct klartext_cycle_word){.name = "SCL", .value = 1, .given = true};
		return klartext_expect_end(lexer) && klartext_frame_cycle_scale(lexer->context, cycle);
	}
	return klartext_cycle_words_read(lexer, cycle) && klartext_frame_cycle_scale(lexer->context, cycle);
}

bool klartext_transform_run(struct lexer *lexer)
{
	struct klartext_cycle cycle = {.number = 7, .line = lexer->at->line, .column = lexer_next_column(lexer)};

	if (klartext_take(lexer, "DATUM"))
		return shift(lexer, &cycle);
	if (klartext_take(lexer, "MIRROR"))
		return mirror(lexer, &cycle);
	if (klartext_take(lexer, "ROTATION"))
		return rotate(lexer, &cycle);
	if (klartext_take(lexer, "SCALE"))
		return scale(lexer, &cycle);
	return fault(lexer->at, cycle.column, "TRANS needs DATUM, MIRROR, ROTATION or SCALE");
}

/* "PRESET SELECT": selects a preset by its number, as CYCL DEF 247 does. With KEEP TRANS the transformations stay. */
bool klartext_transform_preset(struct lexer *lexer)
{
	struct klartext_cycle cycle = {.number = 247, .line = lexer->at->line, .column = lexer_next_column(lexer)};
	struct klartext_cycle_word *word = &cycle.words[0];

	if (!klartext_take(lexer, "SELECT"))
		return fault(lexer->at, cycle.column,
			     "PRESET other than PRESET SELECT changes the preset table, which is not known here");
	if (lexer_peek(lexer) != '#')
		return fault(lexer->at, lexer_next_column(lexer), "PRESET SELECT needs # and the number of the preset");
	lexer_take(lexer);
	*word = (struct klartext_cycle_word){.name = "Q339", .given = true};
	word->column = lexer_next_column(lexer);
	word->line = lexer->at->line;
	cycle.count = 1;
	if (!klartext_value(lexer, &word->value))
		return false;
	if (klartext_take(lexer, "KEEP")) {
		if (!klartext_take(lexer, "TRANS"))
			return fault(lexer->at, lexer_next_column(lexer), "KEEP needs TRANS");
		if (klartext_frame_cycle_is_shifted(lexer->context, klartext_of(lexer->context)->frame.shift))
			return fault(lexer->at, cycle.column,
				     "KEEP TRANS while a datum shift is in force is not supported: write TRANS DATUM "
				     "RESET first, and the shift again behind the preset");
	}
	klartext_take(lexer, "WP");
	return klartext_expect_end(lexer) && klartext_preset_select(lexer->context, &cycle);
}

/* "SEL TABLE": names a datum table. The setup has the rows of only one table. */
bool klartext_transform_table(struct lexer *lexer)
{
	struct klartext_preset *preset = &klartext_of(lexer->context)->preset;
	const int column = lexer_next_column(lexer);
	char name[KLARTEXT_NAME];

	if (!klartext_name(lexer, "a table's name", name, sizeof(name)))
		return false;
	if (preset->table[0] != '\0' && strcmp(preset->table, name) != 0)
		return fault(
		    lexer->at, column,
		    "a second datum table: the rows of the setup (<work_offset name=\"#1\"/>) are those of one "
		    "table, %s",
		    preset->table);
	memcpy(preset->table, name, sizeof(name));
	return klartext_expect_end(lexer);
}
