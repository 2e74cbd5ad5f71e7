/* tolerance.h - every tolerance of the program, with its unit and its reason. */
#ifndef FIVECHECK_GEOM_TOLERANCE_H
#define FIVECHECK_GEOM_TOLERANCE_H

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
 * mm, and degrees of rotary axes: a position this near to an axis limit is inside (the contract with the user). Written
 * and computed positions differ from the exact ones by some 1e-9; machines are repeatable to 1e-3.
 */
#define LIMIT_TOLERANCE 1e-6

/* mm: what a setup file gives twice (a tool's length and its sections) must agree to this. Files have 3 to 6 decimals. */
#define TOOL_SUM_TOLERANCE 1e-6

/*
 * Seconds a second: axes of a dogleg that arrive within this share of the time arrive together. Rounding leaves
 * some 1e-16 of it; a leg that is shorter than this moves nothing that could be seen.
 */
#define ARRIVAL_ROUNDING 1e-12

/* Sine of the angle between directions below which they count as parallel: rounding leaves some 1e-16 of it. */
#define PARALLEL_SINE 1e-12

/* mm: a coordinate in a mesh beyond this is no machine; its float granularity is 64 mm. */
#define COORDINATE_MAX 1e9

#endif
