/*
 * math_functions.h - the elementary functions, made of IEEE 754 basic operations alone.
 *
 * C libraries differ in the last bits of sin, atan2 and the like, and a verdict must not. These functions add,
 * subtract, multiply, divide, take square roots and round to whole numbers, in double precision, to nearest and
 * without contraction: they return the same bits with every compiler, C library and processor. scripts/check-layers
 * keeps those of the C library out of src. What IEEE 754 defines to the last bit comes from <math.h>: fabs, floor,
 * fmod, remainder, round, sqrt and their like.
 *
 * Every result is within 0.51 units in the last place of the true value, for all arguments; where the true value is a
 * double, that is the result. Special values are those of C17, annex F. errno is left alone. make check-math holds
 * all of this against MPFR.
 *
 * Method: tables, short polynomials, and sums of two doubles. Muller, "Elementary Functions", 3rd edition, 2016; Tang,
 * "Table-driven implementation of the exponential function in IEEE floating-point arithmetic", 1989; Payne and Hanek,
 * "Radian reduction for trigonometric functions", 1983.
 */
#ifndef FIVECHECK_BASE_MATH_MATH_FUNCTIONS_H
#define FIVECHECK_BASE_MATH_MATH_FUNCTIONS_H

/* Of an angle in radians. The third is cheaper than both of the others. */
double math_sin(double angle);
double math_cos(double angle);
void math_sin_cos(double angle, double *sine, double *cosine);
double math_tan(double angle);

/* Of an angle in degrees, which is not rounded to radians first: sin 30 is 0.5, cos 90 is 0, tan 90 is infinite. */
double math_sin_degrees(double angle);
double math_cos_degrees(double angle);
double math_tan_degrees(double angle);

/* In radians. */
double math_asin(double x);
double math_acos(double x);
double math_atan2(double y, double x);

/* In degrees. */
double math_asin_degrees(double x);
double math_acos_degrees(double x);
double math_atan2_degrees(double y, double x);

double math_exp(double x);
double math_log(double x);
double math_log10(double x);
double math_pow(double x, double y);

/* The length of (x, y), without overflow on the way. */
double math_hypot(double x, double y);

#endif
