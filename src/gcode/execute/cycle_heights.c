#include "gcode/execute/cycle_heights.h"

#include <math.h>

#include "base/same_double.h"
#include "gcode/execute/cycle_words.h"
#include "geom/tolerance.h"

/* The drilling axis' word is kept under the letter Z in every plane. */
static bool find_bottom(struct canned_cycle *cycle, bool kept, double *value)
{
	struct interp *interp = cycle->interp;
	struct cycle_memory *memory = &interp->state.cycle;
	char letter = AXIS_LETTERS[cycle->depth];

	if (block_has(&interp->block, letter)) {
		memory->word['Z' - 'A'] = block_value(&interp->block, letter);
		memory->known |= letter_bit('Z');
	} else if (!kept || !(memory->known & letter_bit('Z'))) {
		return fault(&interp->at, block_motion_column(&interp->block), "G%g needs %c (depth)",
			     cycle->code / 10.0, letter);
	}
	*value = memory->word['Z' - 'A'];
	return true;
}

/*
 * The height to which the tool retracts. LinuxCNC's interpreter starts with G99, unless the machine's
 * RS274NGC_STARTUP_CODE changes this.
 */
static double find_clear(struct canned_cycle *cycle, double level)
{
	struct interp *interp = cycle->interp;
	int retract = interp->state.retract;
	bool starts_at_r = cycle->traits->starts_at_r == ANSWER_YES;

	if (starts_at_r && retract == CODE_NONE && level > cycle->r && !interp->cautioned_retract) {
		caution(&interp->at, block_motion_column(&interp->block),
			"a cycle before any G98 or G99: it is assumed that the tool retracts to R (G99), which "
			"RS274NGC_STARTUP_CODE of the machine can change");
		interp->cautioned_retract = true;
	}
	if (retract == G99 || (starts_at_r && retract == CODE_NONE))
		return cycle->r;
	return cycle->traits->never_below_r == ANSWER_YES ? fmax(level, cycle->r) : level;
}

/* If it is not known whether the initial level is a coordinate or a position, both must give the same height. */
static bool check_level(const struct canned_cycle *cycle, double level)
{
	struct interp *interp = cycle->interp;
	const struct state *state = &interp->state;
	const struct cycle_memory *memory = &state->cycle;
	bool used = state->retract != G99 || state->incremental;
	bool moved = used && fabs(level - memory->height) > SAME_COORDINATE;
	bool rescaled = !same_double(memory->scale, state->scale);

	if (cycle->traits->level_is_coordinate == ANSWER_YES || !(moved || rescaled || memory->turned))
		return true;
	return fault(&interp->at, block_motion_column(&interp->block),
		     "the coordinates have changed since the first cycle, and the control decides whether the initial "
		     "level and the words change with them; write G80 first");
}

/*
 * R and Z in the wrong order. No manual forbids this: the control moves to R and then to Z, or stops with an alarm
 * before. A first peck may still move down from R.
 */
static bool cross_over(struct canned_cycle *cycle, double offset)
{
	struct interp *interp = cycle->interp;
	int column = block_motion_column(&interp->block), code = cycle->code / 10;
	double r = cycle->r - offset, z = cycle->bottom - offset;
	bool back = cycle_hole_bores_back(cycle);
	bool by_ij = cycle->code == G87 && cycle->traits->g87 == G87_BACK_BY_IJK;

	if (cycle->traits->any_order == ANSWER_YES && !by_ij) {
		if (!interp->cautioned_order)
			caution(&interp->at, column,
				"R of G%d, %.6g mm, is %s Z, %.6g mm: the control moves to R and then to Z, or stops "
				"with an alarm; both cases are checked, here and further on",
				code, r, back ? "above" : "below", z);
		interp->cautioned_order = true;
		return true;
	}
	if (back)
		return fault(&interp->at, column,
			     "R of G%d, %.6g mm, is above Z, %.6g mm: a back boring cycle moves down to R and bores "
			     "upwards to Z",
			     code, r, z);
	return fault(&interp->at, column, "R of G%d, %.6g mm, is below the depth, %.6g mm", code, r, z);
}

/*
 * Is R, or the depth (letter Z), an increment? On controls that keep the position of words this depends on the mode in
 * which the word was given. Manuals do not say what an increment means after G90.
 */
static bool find_mode(struct canned_cycle *cycle, char letter, bool given, bool *incremental)
{
	struct interp *interp = cycle->interp;
	struct state *state = &interp->state;
	uint32_t bit = letter_bit(letter);

	if (given)
		state->cycle.increments = (state->cycle.increments & ~bit) | (state->incremental ? bit : 0);
	*incremental = state->incremental;
	if (given || cycle->traits->words_keep_place == ANSWER_NO)
		return true;
	*incremental = state->cycle.increments & bit;
	if (!*incremental || state->incremental)
		return true;
	return fault(&interp->at, block_motion_column(&interp->block),
		     "%s of G%d was given as an increment (G91); controls differ in what it means in G90; write it "
		     "again",
		     letter == 'R' ? "R" : "the depth", cycle->code / 10);
}

bool cycle_heights_find(struct canned_cycle *cycle, bool kept)
{
	struct interp *interp = cycle->interp;
	struct state *state = &interp->state;
	double offset = state->offset.v[cycle->depth], scale = state->scale, r = 0, bottom = 0, level;
	bool back = cycle_hole_bores_back(cycle), r_counts = false, bottom_counts = false;

	if (!cycle_words_take(cycle, 'R', kept, &r) || !find_bottom(cycle, kept, &bottom) ||
	    !find_mode(cycle, 'R', block_has(&interp->block, 'R'), &r_counts) ||
	    !find_mode(cycle, 'Z', block_has(&interp->block, AXIS_LETTERS[cycle->depth]), &bottom_counts))
		return false;
	if (!state->cycle.has_level) {
		state->cycle.level = (cycle->at.v[cycle->depth] - offset) / scale;
		state->cycle.has_level = true;
		state->cycle.height = cycle->at.v[cycle->depth];
		state->cycle.scale = scale;
		state->cycle.turned = false;
	}
	level = state->cycle.level * scale + offset;
	if (!check_level(cycle, level))
		return false;
	cycle->r = r * scale + (r_counts ? level : offset);
	cycle->bottom = bottom * scale + (bottom_counts ? cycle->r : offset);
	cycle->crosses = back ? cycle->r > cycle->bottom : cycle->r < cycle->bottom;
	if (cycle->crosses && !cross_over(cycle, offset))
		return false;
	cycle->clear = back ? level : find_clear(cycle, level);
	return true;
}
