#include "motion/blend.h"

#include "base/units.h"

void blend_change(struct blend *blend, const struct machine *machine, const struct axis_table *axes,
		  const struct canon_move *move)
{
	double own = machine->controller.path_tolerance;
	double programmed = move->blend ? move->blend_tolerance : 0;
	double linear = programmed > 0 ? programmed : own, rotary = radians(own > 0 ? own : programmed);

	if (move->blend && move->blend_turn > 0)
		rotary = move->blend_turn;
	blend->taken = true;
	blend->on = move->blend;
	blend->programmed = move->blend_tolerance;
	blend->turn = move->blend_turn;
	for (size_t i = 0; i < axes->count; i++)
		blend->tolerance.v[axes->rows[i].slot] = axes->rows[i].rotary ? rotary : linear;
}

bool blend_is_unbounded(const struct machine *machine, const struct canon_move *move)
{
	return move->blend && !(move->blend_tolerance > 0) && !(machine->controller.path_tolerance > 0);
}
