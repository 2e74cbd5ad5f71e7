#include "gcode/execute/path_rounding.h"

double path_rounding(const struct interp *interp, const struct canon_move *move)
{
	return move->blend && move->blend_tolerance > 0 ? move->blend_tolerance
							: interp->config->controller.path_tolerance;
}
