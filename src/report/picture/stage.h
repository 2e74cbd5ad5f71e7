/* stage.h - the content of a picture: the positions of the bodies, and which of them are important. */
#ifndef FIVECHECK_REPORT_PICTURE_STAGE_H
#define FIVECHECK_REPORT_PICTURE_STAGE_H

#include <stdbool.h>
#include <stdint.h>

#include "base/axes.h"
#include "report/picture/raster.h"
#include "scene/scene.h"

/* All pointers are borrowed. The trees of all bodies have been built. */
struct stage {
	const struct scene *scene;
	axis_values axes;
	int tool;	/* in the spindle */
	int a, b;	/* bodies that are shown in colour; -1: none */
	int moved;	/* a link: its bodies, and all that it carries, are shown in the colour of a; 0: none */
	bool alone;	/* only these are drawn */
	bool alarming;	/* they meet: in red and orange; else in blue and green */
	bool has_point;
	vec3 point;	/* where they meet or are nearest, machine coordinates */
	const struct mesh *stock;	/* the remaining stock, in its mesh coordinates; NULL: the blank is drawn */
	const vec3 (*triangles)[3];	/* of a and of b, shown in a separate colour; or NULL */
};

/* Parallel projection: pixels = scale * (right, -up) . (p - centre), from the middle of the picture. */
struct camera {
	vec3 right, up, toward;	/* unit vectors; `toward` points from the scene to the eye */
	vec3 centre;
	double scale;	/* pixels per mm, for a picture of width 1 */
};

/* Is the body drawn? */
bool stage_shows(const struct stage *stage, int body);

/* The part of the body that is drawn, in its mesh coordinates. */
const struct mesh *stage_mesh(const struct stage *stage, int body);

/* The middle of a body at its position, and the radius of a ball around it. */
vec3 stage_middle(const struct stage *stage, int body, double *radius);

/* Draws all bodies that are present with this tool. */
void stage_draw(const struct stage *stage, const struct camera *camera, struct raster *raster);

/* The position of a point in a raster of this size, pixels and depth. */
vec3 camera_project(const struct camera *camera, const struct raster *raster, vec3 p);

/* The map from mesh coordinates to the raster: rows of a matrix, and a translation. */
struct screen {
	vec3 x, y, z, shift;
};
struct screen screen_of(const struct camera *camera, const struct raster *raster, const xform *pose);

static inline vec3 screen_place(const struct screen *screen, vec3 p)
{
	return vec3_add(screen->shift, (vec3){vec3_dot(screen->x, p), vec3_dot(screen->y, p), vec3_dot(screen->z, p)});
}

/* Paints: a class and a brightness, 0 to PAINT_LEVELS - 1. */
enum paint_class {
	PAINT_NONE,
	PAINT_BASE,
	PAINT_MOVING,
	PAINT_FIXTURE,
	PAINT_PART,
	PAINT_TOOL,
	PAINT_A,
	PAINT_B,
	PAINT_CONTACT_A,
	PAINT_CONTACT_B,
	PAINT_NEAR_A,
	PAINT_NEAR_B,
	PAINT_CLASSES
};
enum { PAINT_LEVELS = 8 };

enum paint_class stage_class(const struct stage *stage, int body);

/* The class of bodies a and b. */
enum paint_class stage_class_a(const struct stage *stage);
enum paint_class stage_class_b(const struct stage *stage);

/* Red, green and blue, 0 to 255 each, in the lower bytes: 0xRRGGBB. */
uint32_t paint_colour(uint8_t paint);

#endif
