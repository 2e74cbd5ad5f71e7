#include "motion/blend.h"

#include "base/units.h"

axis_values blend_path_tolerance(const struct machine *machine, const struct canon_move *move)
{
	double own = machine->controller.path_tolerance;
	double programmed = move->blend ? move->blend_tolerance : 0;
	double linear = programmed > 0 ? programmed : own, rotary = radians(own > 0 ? own : programmed);
	axis_values tolerance = {{0}};

	if (move->blend && move->blend_turn > 0)
		rotary = move->blend_turn;
	for (size_t i = 0; i < machine->axis_count; i++) {
		const struct axis *axis = &machine->axes[i];

		tolerance.v[axis->slot] = axis->rotary ? rotary : linear;
	}
	return tolerance;
}

bool blend_is_unbounded(const struct machine *machine, const struct canon_move *move)
{
	return move->blend && !(move->blend_tolerance > 0) && !(machine->controller.path_tolerance > 0);
}
