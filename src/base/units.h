/* units.h - the conversions between files (degrees, inches, minutes) and internal units (radians, mm, seconds). */
#ifndef FIVECHECK_BASE_UNITS_H
#define FIVECHECK_BASE_UNITS_H

#define PI 3.14159265358979323846
#define MM_PER_INCH 25.4
#define SECONDS_PER_MINUTE 60.0

static inline double radians(double degrees)
{
	return degrees * (PI / 180.0);
}

static inline double degrees(double radians)
{
	return radians * (180.0 / PI);
}

#endif
