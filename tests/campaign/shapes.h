/* shapes.h - closed surfaces of bodies, with faces outward, about the origin. */
#ifndef CAMPAIGN_SHAPES_H
#define CAMPAIGN_SHAPES_H

#include <string>
#include <vector>

#include "random.h"

using Surface = std::vector<triangle>;

/* A point of a profile: the distance from the axis of revolution, and the height, which rises along the profile. */
struct Ring {
	double radius, height;
};

/* `sides` facets about Z with their corners on the profile, so inside the true solid. The ends are closed. */
Surface revolved(std::vector<Ring> profile, int sides);

/* A box, prism, cone, ball, wall of 0.01 mm, angle, hollow box or torus of about that size (half extents, mm). */
Surface random_shape(Random &random, double size);

/* Binary STL; throws std::runtime_error. */
void write_stl(const std::string &path, const Surface &surface);

/* Is the point enclosed? By the solid angle of the surface as seen from there. */
bool encloses(const solid &body, vec point);

#endif
