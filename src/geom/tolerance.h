/* tolerance.h - every tolerance of the program, with its unit and its reason. */
#ifndef FIVECHECK_GEOM_TOLERANCE_H
#define FIVECHECK_GEOM_TOLERANCE_H

#include <float.h>

/*
 * Box tests run in float. A box's centre and half size pass through a rotation (each entry off by 2^-24), three
 * products and four sums, a difference and a square: below 32 roundings of 2^-24 of the largest number, the sum of both
 * bodies' radii and their distance. 2^-18 leaves a factor of two; the test uses 0.3 of it.
 */
#define BOX_ROUNDING 0x1p-18

/*
 * Support functions run in float: a direction rounded to it, three products and two sums are off by
 * less than 6 times 2^-24 of |n_x p_x| + |n_y p_y| + |n_z p_z|, which is at most |p|. 2^-20 leaves a factor of two.
 */
#define SUPPORT_ROUNDING 0x1p-20

/*
 * Poses and projections run in double: nine joints of a dozen operations each, and a projection of six. 2^-44 of the
 * largest length is 256 units in the last place; 5 m give 0.3 nm. The test uses 1/170 of it, because the errors belong
 * to each length alone, not to the sum of all, and cancel.
 */
#define POSE_ROUNDING 0x1p-44

/*
 * mm: how deep a cutter that does not cut may enter the finished part. A retract begins on the surface that was just
 * cut, and the mesh of the part deviates from the true surface by some hundredths.
 */
#define RAPID_ALLOWANCE 0.1

/*
 * mm: the same for the stock. A retract begins on the surface that was just cut, and the cells of the stock across that
 * surface remain: their diagonal, 0.18 mm with an edge of 0.1 mm, must not cause a finding.
 */
#define STOCK_RAPID_ALLOWANCE 0.25

/* mm: how exactly the remaining stock is known (--stock-tolerance). */
#define STOCK_TOLERANCE 0.1

/*
 * mm, and degrees of rotary axes: a position this near to an axis limit is inside (the contract with the user). Written
 * and computed positions differ from the exact ones by some 1e-9; machines are repeatable to 1e-3.
 */
#define LIMIT_TOLERANCE 1e-6

/*
 * mm: values that a setup file gives twice (a tool's length and its sections) must agree to this. Files have 3 to 6
 * decimals.
 */
#define TOOL_SUM_TOLERANCE 1e-6

/*
 * Share of the time of a dogleg: axes that arrive within this share of each other arrive together. Rounding is about
 * 1e-16 of it; a shorter leg moves nothing visible.
 */
#define ARRIVAL_ROUNDING 1e-12

/* Sine of the angle below which directions count as parallel: rounding is about 1e-16. */
#define PARALLEL_SINE 1e-12

/*
 * A number that is rounded to float, or is a product or a root of such numbers, has an error of a few times 2^-24 of
 * itself: bounds in float are enlarged (or, below, reduced) by this share.
 */
#define FLOAT_MARGIN 0x1p-20f

/*
 * A triple product d.(a x b) of vectors in double has an error below 12 roundings of 2^-53 of |d||a||b|, including the
 * differences from the point; 2^-48 leaves a factor of two.
 */
#define TRIPLE_ROUNDING 0x1p-48

/*
 * The boxes that a ray meets are already rounded outward: this covers the rounding of the ray, as a share of the
 * lengths.
 */
#define SLAB_ROUNDING 0x1p-40

/* mm^2: edges with a smaller square count as points: the reciprocals of such squares would overflow in products. */
#define POINT_LENGTH2 1e-140

/* A cross product this small compared with its factors is mostly the rounding of the edges. */
#define CROSS_VANISHING (16 * DBL_EPSILON)

/*
 * A face whose height is this small compared with its longest edge is not a face, to within rounding: its edges replace
 * it.
 */
#define FACE_FLAT (4 * DBL_EPSILON)

/*
 * A position of an axis is the result of about a dozen rotations and sums, each exact to a few units in the last place
 * of the largest number in it. The tests compare with long double; the largest ratio found is a hundredth under TCP and
 * a twelfth on arcs.
 */
#define POSITION_ROUNDING (16 * DBL_EPSILON)

/* Bounds of derivatives are themselves computed with about a hundred roundings; this is a factor for the bound. */
#define BOUND_SLACK (1 + 1e-13)

/* If |det| of three unit directions of axes is below this, they lie in one plane, as far as a machine file can say. */
#define LEAST_DETERMINANT 1e-6

/*
 * mm, radians: an axis that is sent to a position this close to its current one stays. The difference is the remainder
 * of offsets that were added and subtracted again: a few units in the last place of a thousand.
 */
#define OFFSET_DUST 1e-10

/* mm, radians: positions that differ by less are equal: the error of the interpreter's sums of offsets. */
#define SAME_POINT 1e-9

/* Degrees: the same for positions of rotary axes, and for two directions that are both half a turn. */
#define SAME_DEGREES 1e-9

/* mm: coordinates that differ by less are equal for a program with its few decimals. */
#define SAME_COORDINATE 1e-6

/* The error of computed unit vectors, and of their projections. */
#define DIRECTION_TOLERANCE 1e-9

/*
 * The same for directions from machine files and programs with few decimals: a direction this near counts as reached.
 */
#define DIRECTION_REACHED 1e-6

/* Radians: rotations, and angles from zero, that differ by less are equal: no control decides by less. */
#define TIE_TOLERANCE 1e-6

/* mm and radians: proofs of "out of reach" include path tolerances up to this. */
#define REACH_PATH_TOLERANCE 1e-3

/*
 * mm and radians: such proofs extend this far past the limits, to include that tolerance, positions that are less than
 * LIMIT_TOLERANCE outside, and the rounding of positions.
 */
#define REACH_MARGIN (REACH_PATH_TOLERANCE + 10 * LIMIT_TOLERANCE)

/* mm: larger coordinates in a mesh cannot be those of a machine; the granularity of float is 64 mm there. */
#define COORDINATE_MAX 1e9

#endif
