#include "stock/passage.h"

#include <math.h>

#include "base/math/math_functions.h"

bool passage_init(struct passage *passage, const struct obstacle *obstacle, const xform *from, const xform *to,
		  double error)
{
	const vec3 way = mat3_apply_transposed(&from->rotation, vec3_sub(to->translation, from->translation));
	const double sideways = math_hypot(way.x, way.y);

	if (!obstacle->revolved)
		return false;
	*passage = (struct passage){.obstacle = *obstacle, .pose = *from, .error = fabs(way.z)};
	passage->obstacle.way_x = way.x;
	passage->obstacle.way_y = way.y;
	if (fabs(way.z) < error)
		return true;
	if (sideways >= error || !revolved_widens_upward(obstacle->revolved))
		return false;
	*passage = (struct passage){.obstacle = *obstacle, .pose = way.z > 0 ? *from : *to, .error = sideways};
	revolved_init_stretched(&passage->stretched, obstacle->revolved, fabs(way.z));
	passage->obstacle.revolved = &passage->stretched;
	return true;
}

void passage_release(struct passage *passage)
{
	revolved_release(&passage->stretched);
}
