/* tool_solid.h - makes triangles that enclose a holder, shank or cutter, which is described by sections. */
#ifndef FIVECHECK_MACHINE_TOOL_SOLID_H
#define FIVECHECK_MACHINE_TOOL_SOLID_H

#include <stdbool.h>
#include <stddef.h>

#include "base/arena.h"
#include "geom/mesh.h"
#include "geom/vec3.h"

/* mm: the largest distance of the triangles from the true solid. */
#define TOOL_SOLID_DEVIATION 0.01

/*
 * mm: the smallest length of a section, and the largest length and diameter of a tool. The first is many times the
 * float rounding at the second, so that rounding cannot exceed the permitted deviation.
 */
#define TOOL_SECTION_MIN 0.01
#define TOOL_DIAMETER_MIN 0.001
#define TOOL_SIZE_MAX 5000.0

/* A cylinder or a frustum, mm; diameter_end (the end nearer the tip) may be 0. */
struct tool_section {
	double length;
	double diameter, diameter_end;
};

enum tool_tip { TIP_FLAT, TIP_BALL, TIP_CONE, TIP_BULL };

/* Sections stacked from z = top downward; a tip that is not flat is cut from the last one, a cylinder. */
struct tool_solid {
	const struct tool_section *sections;
	size_t count;	/* at least 1 */
	double top;
	enum tool_tip tip;
	double angle;	/* CONE: included angle, radians, inside (0, pi) */
	double corner;	/* BULL: radius of the rounded edge, mm, at most the section's radius */
};

/*
 * Divides the solid `height` mm above its end: *upper has a flat end there, *lower has the tip. The height is at least
 * the tip's and less than the whole. The sections are in the arena.
 */
void tool_solid_cut(const struct tool_solid *solid, double height, struct arena *arena, struct tool_solid *upper,
		    struct tool_solid *lower);

/* mm: the height of the tip, which is cut from the last section; that section must be at least as long. */
double tool_solid_tip_height(const struct tool_solid *solid);

/* mm: the height of the solid's lower end, its tip. */
double tool_solid_bottom(const struct tool_solid *solid);

/*
 * The number of triangles that tool_solid_mesh makes, or a few more: it leaves out those that rounding has made lines.
 */
size_t tool_solid_triangles(const struct tool_solid *solid);

/*
 * One closed surface, counter-clockwise seen from outside, about the Z axis. It encloses the true solid as it is
 * stored, in floats (so its slop is 0), and every point of it is within TOOL_SOLID_DEVIATION of the solid. The
 * triangles are in the arena.
 */
void tool_solid_mesh(const struct tool_solid *solid, struct arena *arena, struct mesh *out);

/* The same with few triangles; the radii of the rings exceed those of the solid by less than a tenth. */
void tool_solid_coarse_mesh(const struct tool_solid *solid, struct arena *arena, struct mesh *out);

/* Is the point inside the solid above its tip, more than `margin` mm from the ends and the side of a section? */
bool tool_solid_contains(const struct tool_solid *solid, vec3 p, double margin);

#endif
