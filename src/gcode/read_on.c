#include "gcode/read_on.h"

#include "gcode/canon.h"
#include "gcode/state.h"

static bool hear_nothing(void *context, const struct canon_event *event)
{
	(void)context;
	(void)event;
	return true;
}

bool read_on(struct interp *interp, size_t errors_before)
{
	static const struct canon_sink deaf = {NULL, hear_nothing};

	if (!interp->config->read.all_faults || interp->diag->errors == errors_before)
		return false;
	if (!interp->faulty)
		interp->program.faulty_from = interp->program.blocks;
	interp->program.faulty = interp->faulty = true;
	interp->sink = &deaf;
	return true;
}

/* Takes the block's modes, because later blocks depend on them. */
static void take_modes(struct state *state, const struct block *block)
{
	const int *g = block->g;

	for (int group = 0; group < G_GROUPS; group++)
		state->unknown_modes &= ~(g[group] == CODE_NONE ? 0U : 1U << group);
	if (g[G_MOTION] >= G0 && g[G_MOTION] <= G3)
		state->motion = state->path_motion = g[G_MOTION];
	if (g[G_UNITS] != CODE_NONE)
		state->scale = state_unit(g[G_UNITS]);
	if (g[G_PLANE] != CODE_NONE)
		state->plane = g[G_PLANE];
	if (g[G_DISTANCE] != CODE_NONE)
		state->incremental = g[G_DISTANCE] == G91;
}

void read_on_lose(struct interp *interp)
{
	const struct block *block = &interp->block;

	/* A statement, a call or a code that moves axes without words of them may move any axis. */
	if (block->words == 0 || block->m[M_STOP] >= 97 || block->g[G_NONMODAL] != CODE_NONE)
		interp->lost = AXIS_BITS;
	else
		interp->lost |= block->letters & AXIS_BITS;
	if (block->words > 0)
		take_modes(&interp->state, block);
}
