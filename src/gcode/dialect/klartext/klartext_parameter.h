/* klartext_parameter.h - the Q parameters of a cycle that is being carried out. */
#ifndef FIVECHECK_GCODE_DIALECT_KLARTEXT_KLARTEXT_PARAMETER_H
#define FIVECHECK_GCODE_DIALECT_KLARTEXT_KLARTEXT_PARAMETER_H

#include <stdbool.h>

#include "gcode/dialect/klartext/klartext_state.h"

/* A cycle that is being carried out. */
struct klartext_call_of {
	struct interp *interp;
	const struct klartext_cycle *cycle;
	int column; /* of what calls it */
};

/* The value of Q<q>. False: the cycle has none. */
bool klartext_parameter_find(const struct klartext_call_of *call, int q, double *value);

/* The same, and a length in mm, of a parameter that the cycle must have. False: reported. */
bool klartext_parameter_need(const struct klartext_call_of *call, int q, double *value);
bool klartext_parameter_length(const struct klartext_call_of *call, int q, double *value);

/* The value, or a length in mm, of a parameter that may be left out. */
double klartext_parameter_or(const struct klartext_call_of *call, int q, double otherwise);
double klartext_parameter_length_or(const struct klartext_call_of *call, int q, double otherwise);

/* mm/s, of F in mm/min or tenths of an inch a minute. */
double klartext_parameter_per_second(const struct klartext_call_of *call, double feed);

/* The feed Q<q>, mm/s. False: reported. */
bool klartext_parameter_feed(const struct klartext_call_of *call, int q, double *feed);

#endif
