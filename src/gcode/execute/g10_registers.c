#include "gcode/execute/g10_registers.h"

#include "gcode/execute/tool_table.h"

#define NUMBER_MAX 9999

/* The setup has total lengths and radii: it does not say which part of them is wear. */
static void caution_wear(struct interp *interp, char letter, int number, bool is_wear)
{
	if (interp->cautioned_wear)
		return;
	interp->cautioned_wear = true;
	caution(&interp->at, block_column(&interp->block, 'L'),
		is_wear ? "the length or radius of %c%d in the setup is assumed to have no wear, here and further on"
			: "the wear of %c%d is assumed to be 0 until the program sets it, here and further on",
		letter, number);
}

static bool check_in_use(struct interp *interp, char letter, int number)
{
	const struct state *state = &interp->state;
	bool used = letter == 'H' ? state->length_number == number && state->length_code != G49
				  : interp->comp.side != 0 && interp->comp.number == number;

	return !used ||
	       fault(&interp->at, interp->block.g_column[G_NONMODAL],
		     "G10 changes %c%d while it is active: controls differ in the block from which the change is "
		     "valid; change it earlier",
		     letter, number);
}

/* Half of a diameter is written. */
static bool find_factor(struct interp *interp, double *factor)
{
	enum comp_d form = interp->config->controller.comp_d;

	*factor = form == COMP_D_DIAMETER ? 0.5 : 1;
	return form != COMP_D_UNKNOWN || fault(&interp->at, block_column(&interp->block, 'R'),
					       "a parameter of the control decides whether D is a radius or a "
					       "diameter: set cutter_comp_d=\"radius\" or \"diameter\" in the machine "
					       "file's <controller>");
}

bool g10_registers_write(struct interp *interp, int mode)
{
	const struct block *block = &interp->block;
	bool is_length = mode < 12, is_wear = mode % 2 == 1, adds = interp->state.incremental;
	char letter = is_length ? 'H' : 'D';
	double value, factor = 1, *whole, *wear;
	int number;

	if (!block_has(block, 'R') || (block->letters & AXIS_BITS))
		return fault(&interp->at, block->g_column[G_NONMODAL],
			     "G10 L%d needs R (value) and no axis words", mode);
	if (!block_integer(block, &interp->at, 'P', 1, NUMBER_MAX, &number) || !check_in_use(interp, letter, number))
		return false;
	if (!is_length && !find_factor(interp, &factor))
		return false;
	value = block_value(block, 'R') * interp->state.scale * factor;
	whole = is_length ? &tool_table_need_length(&interp->tools, number)->length
			  : &tool_table_need_radius(&interp->tools, number)->radius;
	wear = &tool_table_need_wear(&interp->tools, letter, number)->value;
	if (is_wear) {
		value += adds ? *wear : 0;
		*whole += value - *wear;
		*wear = value;
	} else {
		*whole = value + (adds ? *whole : *wear);
	}
	caution_wear(interp, letter, number, is_wear);
	return true;
}
