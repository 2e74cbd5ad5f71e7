#include "gcode/execute/path_control.h"

#include "base/same_double.h"

/* AI contour control and its predecessors follow the path only within the control's tolerances, like G64. */
static void switch_contour(struct state *state, bool on)
{
	if (on && !state->contour) {
		state->blend_before = state->blend;
		state->blend = true;
		state->blend_tolerance = 0;
	} else if (!on && state->contour) {
		state->blend = state->blend_before;
	}
	state->contour = on;
}

/*
 * B-64484EN-2, "Smooth Interpolation" (Q2) and "Nano Smoothing" (Q3): a smooth curve near the programmed points, which
 * leaves the programmed path as far as parameters of the control let it.
 */
static bool select_smoothing(struct interp *interp, int q)
{
	const struct block *block = &interp->block;

	if (block->motion != CODE_NONE)
		return fault(&interp->at, block->g_column[G_CONTOUR], "G5.1 Q%d needs a block without motion", q);
	for (const char *letter = AXIS_LETTERS; *letter; letter++)
		if (block_has(block, *letter) && !same_double(block_value(block, *letter), 0))
			return fault(&interp->at, block_column(block, *letter),
				     "%c in G5.1 selects an axis to smooth; its value must be 0", *letter);
	if (!(interp->config->controller.path_tolerance > 0))
		return fault(&interp->at, block->g_column[G_CONTOUR],
			     "G5.1 Q%d lets the control smooth the path: set path_tolerance=\"\" (largest deviation "
			     "from the programmed path) in the machine file's <controller>",
			     q);
	switch_contour(&interp->state, true);
	return true;
}

/* B-63944EN, AI contour control: Q1 on, Q0 off, R is the level of smoothness. */
static bool select_ai(struct interp *interp)
{
	const struct block *block = &interp->block;
	int q, r;

	if (!block_has(block, 'Q'))
		return fault(&interp->at, block->g_column[G_CONTOUR], "G5.1 needs Q");
	if (!block_integer(block, &interp->at, 'Q', 0, 3, &q))
		return false;
	if (block_has(block, 'R') && !block_integer(block, &interp->at, 'R', 1, 10, &r))
		return false;
	if (q > 1)
		return select_smoothing(interp, q);
	if (block->letters & AXIS_BITS)
		return fault(&interp->at, block->g_column[G_CONTOUR],
			     "axis words in G5.1 Q%d are not supported; leave them out", q);
	switch_contour(&interp->state, q == 1);
	return true;
}

/*
 * B-63944EN: "G05 P10000" on, "G05 P0" off, other P for high-speed cycle machining; "G08 P1" on, "G08 P0" off.
 * Mitsubishi's M700 (programming manual, "High-speed Machining Mode") and Mazak's controls: "G05 P1" and "G05 P2" on.
 */
static bool select_by_p(struct interp *interp)
{
	const struct block *block = &interp->block;
	bool g8 = block->g[G_CONTOUR] == G8;
	int p;

	if (!block_has(block, 'P'))
		return fault(&interp->at, block->g_column[G_CONTOUR], "G%d needs P", g8 ? 8 : 5);
	if (!block_integer(block, &interp->at, 'P', 0, g8 ? 1 : 10000, &p))
		return false;
	if (!g8 && p > 2 && p != 10000)
		return fault(&interp->at, block->g_column[G_CONTOUR],
			     "G5 P%d (high-speed cycle machining) is not supported; write its moves as G1", p);
	switch_contour(&interp->state, p != 0);
	return true;
}

/* Haas mill operator's manual, G187: E is the greatest rounding of corners; G187 alone restores the settings. */
static bool select_accuracy(struct interp *interp)
{
	const struct block *block = &interp->block;
	struct state *state = &interp->state;
	int p;

	if (block_has(block, 'P') && !block_integer(block, &interp->at, 'P', 1, 3, &p))
		return false;
	if (block_has(block, 'E') && block_value(block, 'E') < 0)
		return fault(&interp->at, block_column(block, 'E'), "the rounding of corners must not be negative");
	state->blend = true;
	state->blend_tolerance = block_has(block, 'E') ? block_value(block, 'E') * state->scale : 0;
	return true;
}

bool path_control_select(struct interp *interp)
{
	int p;

	switch (interp->block.g[G_CONTOUR]) {
	case CODE_NONE:
		return true;
	case G5_1:
		return select_ai(interp);
	case G5:
	case G8:
		return select_by_p(interp);
	case G187:
		return select_accuracy(interp);
	default:
		/* Haas, G103: the number of blocks to read ahead. No supported program depends on it. */
		return !block_has(&interp->block, 'P') || block_integer(&interp->block, &interp->at, 'P', 0, 15, &p);
	}
}
