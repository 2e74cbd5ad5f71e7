/* klartext_parameter.h - the Q parameters of a cycle that is being carried out. */
#ifndef FIVECHECK_GCODE_DIALECT_KLARTEXT_CYCLES_KLARTEXT_PARAMETER_H
#define FIVECHECK_GCODE_DIALECT_KLARTEXT_CYCLES_KLARTEXT_PARAMETER_H

#include <stdbool.h>

#include "gcode/dialect/klartext/state/klartext_state.h"

/* A cycle that is being carried out. */
struct klartext_call_of {
	struct interp *interp;
	const struct klartext_cycle *cycle;
	int column; /* of the call */
};

/* The value of Q<q>. False: the cycle has none. */
bool klartext_parameter_find(const struct klartext_call_of *call, int q, double *value);

/* The same, and as a length in mm, for a parameter that the cycle must have. False: reported. */
bool klartext_parameter_need(const struct klartext_call_of *call, int q, double *value);
bool klartext_parameter_length(const struct klartext_call_of *call, int q, double *value);

/* The value, or a length in mm, of an optional parameter. */
double klartext_parameter_or(const struct klartext_call_of *call, int q, double otherwise);
double klartext_parameter_length_or(const struct klartext_call_of *call, int q, double otherwise);

/* Converts F in mm/min or tenths of an inch per minute to mm/s. */
double klartext_parameter_per_second(const struct klartext_call_of *call, double feed);

/* The first value of line n.<part> of an older cycle, without conversion; 0: there is none. */
double klartext_parameter_part(const struct klartext_call_of *call, int part);

/* The heights along the tool of nearly all cycles, mm. */
struct klartext_heights {
	double start, bottom, clear; /* set-up clearance, bottom, second set-up clearance */
	double clearance; /* of `start` above the surface */
	bool nothing; /* a depth of 0: the cycle is not carried out */
};

/*
 * Q200, Q201, Q203 and Q204 of the cycle. iTNC 530 user's manual, cycles 200 to 209, 240, 241: Q203 is the workpiece's
 * surface, Q200 the set-up clearance above it, Q204 the second one, Q201 the depth below the surface. False: reported.
 */
bool klartext_parameter_heights(const struct klartext_call_of *call, struct klartext_heights *heights);

/* The feed Q<q>, mm/s. False: reported. */
bool klartext_parameter_feed(const struct klartext_call_of *call, int q, double *feed);

#endif
