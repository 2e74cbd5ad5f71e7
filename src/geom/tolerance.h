/* tolerance.h - every tolerance of the program, with its unit and its reason. */
#ifndef FIVECHECK_GEOM_TOLERANCE_H
#define FIVECHECK_GEOM_TOLERANCE_H

#include <float.h>

/*
 * Box tests run in float. A box's centre and half size pass through a rotation
 * (each entry off by 2^-24), three products and four sums, a difference and a
 * square: below 32 roundings of 2^-24 of the largest number that occurs, the
 * sum of both bodies' radii and their distance. 2^-18 leaves a factor of two;
 * the test sees 0.3 of it used.
 */
#define BOX_ROUNDING 0x1p-18

/*
 * Support functions run in float: a direction rounded to it, three products and two sums are off by
 * less than 6 times 2^-24 of |n_x p_x| + |n_y p_y| + |n_z p_z|, which is at most |p|. 2^-20 leaves a factor of two.
 */
#define SUPPORT_ROUNDING 0x1p-20

/*
 * Poses and projections run in double: nine joints of a dozen operations each,
 * and a projection of six. 2^-44 of the largest length that occurs is 256 units
 * in the last place; 5 m give 0.3 nm. The test sees 1/170 of it used: errors
 * are of each length alone, not of the sum of all, and cancel.
 */
#define POSE_ROUNDING 0x1p-44

/*
 * mm: how deep a cutter that does not cut may enter the finished part. A retract begins on the surface
 * that was just cut, and the part's mesh leaves its true surface by some hundredths.
 */
#define RAPID_ALLOWANCE 0.1

/*
 * mm: the same for the stock. A retract begins on the surface that was just cut, and the cells of the stock that lie
 * across that surface remain: their diagonal, 0.18 mm with an edge of 0.1 mm, must not be an alarm.
 */
#define STOCK_RAPID_ALLOWANCE 0.25

/* mm: how exactly the stock is known that cutters leave behind (--stock-tolerance). */
#define STOCK_TOLERANCE 0.1

/*
 * mm, and degrees of rotary axes: a position this near to an axis limit is inside (the contract with the user). Written
 * and computed positions differ from the exact ones by some 1e-9; machines are repeatable to 1e-3.
 */
#define LIMIT_TOLERANCE 1e-6

/*
 * mm: what a setup file gives twice (a tool's length and its sections) must agree to this. Files have 3 to 6
 * decimals.
 */
#define TOOL_SUM_TOLERANCE 1e-6

/*
 * Seconds a second: axes of a dogleg that arrive within this share of the time arrive together. Rounding leaves
 * some 1e-16 of it; a leg that is shorter than this moves nothing that could be seen.
 */
#define ARRIVAL_ROUNDING 1e-12

/* Sine of the angle between directions below which they count as parallel: rounding leaves some 1e-16 of it. */
#define PARALLEL_SINE 1e-12

/*
 * A number that is rounded to float, or is a product or a root of such, is off by a few times 2^-24 of itself: bounds
 * in float are enlarged (or, below, reduced) by this share.
 */
#define FLOAT_MARGIN 0x1p-20f

/*
 * A triple product d.(a x b) of vectors in double is off by less than 12 roundings of 2^-53 of |d||a||b|, the
 * differences from the point included; 2^-48 leaves a factor of two.
 */
#define TRIPLE_ROUNDING 0x1p-48

/* Boxes that a ray meets are rounded outward already: this covers the ray's own rounding, as a share of the lengths. */
#define SLAB_ROUNDING 0x1p-40

/* mm^2: edges whose square is below this are points: the reciprocals of such squares would overflow in products. */
#define POINT_LENGTH2 1e-140

/* A cross product this small against its factors is mostly the rounding of the edges that went into it. */
#define CROSS_VANISHING (16 * DBL_EPSILON)

/* A face this low against its longest edge is no face, to within rounding: its edges stand for it. */
#define FACE_FLAT (4 * DBL_EPSILON)

/*
 * A position of an axis is the result of some dozen rotations and sums, each good to a few units in the last place of
 * the largest number in it. The tests compare with long double; the largest ratio found is a hundredth under TCP and a
 * twelfth on arcs.
 */
#define POSITION_ROUNDING (16 * DBL_EPSILON)

/* Bounds on derivatives are themselves computed: some hundred roundings, as a factor of the bound. */
#define BOUND_SLACK (1 + 1e-13)

/* |det| of three unit directions of axes below this: they lie in a plane for all that a machine can tell. */
#define LEAST_DETERMINANT 1e-6

/*
 * mm, radians: where an axis is sent this near to where it stands, it stays. The difference is what remains of offsets
 * that were added and taken away again: a few units in the last place of a thousand.
 */
#define OFFSET_DUST 1e-10

/* mm, radians: positions that differ by less are one: what the interpreter's sums of offsets can be off by. */
#define SAME_POINT 1e-9

/* Degrees: the same for positions of rotary axes, and for a way that is as good as half a turn. */
#define SAME_DEGREES 1e-9

/* mm: coordinates that differ by less are the same for all that a program, with its few decimals, can mean. */
#define SAME_COORDINATE 1e-6

/* Unit vectors are good to this where they were computed, and so are their projections. */
#define DIRECTION_TOLERANCE 1e-9

/*
 * The same for directions from machine files and programs, with their few decimals: one so nearly reached is reached.
 */
#define DIRECTION_REACHED 1e-6

/* Radians: ways, and angles from zero, that differ by less are equally good: no control chooses by less. */
#define TIE_TOLERANCE 1e-6

/*
 * mm and radians: proofs of "out of reach" go this far past the limits, so that the rounding of positions and small
 * path tolerances stay inside them.
 */
#define REACH_MARGIN 1e-3

/* mm: a coordinate in a mesh beyond this is no machine; its float granularity is 64 mm. */
#define COORDINATE_MAX 1e9

#endif
