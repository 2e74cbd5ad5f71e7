#include "gcode/execute/probed_axes.h"

#include <math.h>

#include "base/same_double.h"

static bool is_open(const struct state *state, int slot)
{
	return state->probed[slot] && state->probe_bounded[slot];
}

bool probed_axes_any(const struct state *state)
{
	for (int slot = SLOT_X; slot <= SLOT_Z; slot++) {
		if (is_open(state, slot))
			return true;
	}
	return false;
}

bool probed_axes_is_known(struct interp *interp, int slot, int column)
{
	if (!interp->state.probed[slot])
		return true;
	return fault(&interp->at, column,
		     "the position where the probe stopped %c is not known before the program runs; move the axis to "
		     "an absolute coordinate (G90) first",
		     AXIS_LETTERS[slot]);
}

static void add_via(struct probed_plan *plan, const struct state *state, int slot, double value)
{
	slot_values place = plan->via_count > 0 ? plan->via[plan->via_count - 1] : state->position;

	if (same_double(place.v[slot], value))
		return;
	place.v[slot] = value;
	plan->via[plan->via_count++] = place;
}

/* The axis moves alone: through the far end, or through both ends if its end is between them. */
static void plan_alone(const struct state *state, int slot, struct probed_plan *plan)
{
	double low = state->probe_low.v[slot], high = state->probe_high.v[slot];
	double way = plan->end.v[slot] - state->position.v[slot];
	bool above, below;

	if (!state->settles[slot]) {
		if (same_double(way, 0))
			return;
		add_via(plan, state, slot, way > 0 ? low : high);
		plan->end.v[slot] = way > 0 ? high + way : low + way;
		return;
	}
	above = plan->end.v[slot] > low;
	below = plan->end.v[slot] < high;
	if (above && !(below && same_double(state->position.v[slot], low)))
		add_via(plan, state, slot, low);
	if (below && !(above && same_double(state->position.v[slot], high)))
		add_via(plan, state, slot, high);
}

/* Do all uncertain axes return to the start of the probe's move? That move has covered this path from every place. */
static bool goes_back(const struct state *state, const slot_values *target)
{
	for (int slot = SLOT_X; slot <= SLOT_Z; slot++) {
		double here = state->position.v[slot], low = state->probe_low.v[slot], high = state->probe_high.v[slot];
		double start = same_double(here, low) ? high : low;

		if (is_open(state, slot) && ((!same_double(here, low) && !same_double(here, high)) ||
					     !state->settles[slot] || !same_double(target->v[slot], start)))
			return false;
	}
	return true;
}

static bool plan_beside(const struct state *state, struct probed_plan *plan, int *open)
{
	slot_values middle = state->position;

	for (int slot = SLOT_X; slot <= SLOT_Z; slot++) {
		double low = state->probe_low.v[slot], high = state->probe_high.v[slot];
		bool moves = !same_double(plan->end.v[slot], state->position.v[slot]);

		if (!is_open(state, slot))
			continue;
		if (moves && !state->settles[slot]) {
			*open = slot;
			return false;
		}
		middle.v[slot] = low + (high - low) / 2;
		/* The rounding of the middle must not exclude an end. */
		plan->spread[slot] = fmax(high - middle.v[slot], middle.v[slot] - low);
		plan->via_count = 1;
		if (!state->settles[slot])
			plan->end.v[slot] = middle.v[slot];
	}
	plan->via[0] = middle;
	return true;
}

bool probed_axes_plan(const struct state *state, const slot_values *target, bool arc, struct probed_plan *plan,
		      int *open)
{
	bool others = arc;
	int count = 0, last = SLOT_X;

	*plan = (struct probed_plan){.end = *target};
	for (int slot = 0; slot < SLOT_COUNT; slot++) {
		if (is_open(state, slot)) {
			count++;
			last = slot;
		} else {
			others |= !same_double(target->v[slot], state->position.v[slot]);
		}
	}
	if (count == 0 || (!others && goes_back(state, target)))
		return true;
	if (others || count > 1)
		return plan_beside(state, plan, open);
	plan_alone(state, last, plan);
	return true;
}

void probed_axes_arrive(struct state *state, const struct probed_plan *plan)
{
	for (int slot = SLOT_X; slot <= SLOT_Z; slot++) {
		double end = plan->end.v[slot], size = state->probe_high.v[slot] - state->probe_low.v[slot];

		if (!is_open(state, slot))
			continue;
		if (state->settles[slot]) {
			state->probed[slot] = state->probe_bounded[slot] = state->settles[slot] = false;
		} else if (end > state->probe_high.v[slot]) {
			/* The axis moved alone, by an increment, from one end to the other. */
			state->probe_high.v[slot] = end;
			state->probe_low.v[slot] = end - size;
		} else if (end < state->probe_low.v[slot]) {
			state->probe_low.v[slot] = end;
			state->probe_high.v[slot] = end + size;
		}
	}
}

void probed_axes_stop(struct state *state, const bool moved[SLOT_COUNT], const struct state *before, bool bounded)
{
	for (int slot = 0; slot < SLOT_COUNT; slot++) {
		bool was_open = is_open(before, slot);
		double low = was_open ? before->probe_low.v[slot] : before->position.v[slot];
		double high = was_open ? before->probe_high.v[slot] : before->position.v[slot];

		if (!moved[slot])
			continue;
		if (is_open(state, slot)) {
			low = fmin(low, state->probe_low.v[slot]);
			high = fmax(high, state->probe_high.v[slot]);
		}
		state->probed[slot] = true;
		state->settles[slot] = false;
		state->probe_bounded[slot] = bounded;
		state->probe_low.v[slot] = fmin(low, state->position.v[slot]);
		state->probe_high.v[slot] = fmax(high, state->position.v[slot]);
	}
}

void probed_axes_forget_turned(struct state *state)
{
	for (int slot = 0; slot < SLOT_COUNT && (state->tcp != TCP_OFF || state->frame.on); slot++)
		state->probe_bounded[slot] = false;
}
