/* sinumerik_argument.h - the arguments of a cycle, and the heights among them. */
#ifndef FIVECHECK_GCODE_DIALECT_SINUMERIK_CYCLES_SINUMERIK_ARGUMENT_H
#define FIVECHECK_GCODE_DIALECT_SINUMERIK_CYCLES_SINUMERIK_ARGUMENT_H

#include "gcode/dialect/sinumerik/state/sinumerik_state.h"

/* The first arguments of every cycle here; only drilling and the older milling cycles have DPR. */
enum { SINUMERIK_RTP, SINUMERIK_RFP, SINUMERIK_SDIS, SINUMERIK_DP, SINUMERIK_DPR };

struct sinumerik_arguments {
	struct interp *interp;
	const char *cycle;
	int column;	/* of its call */
	const double *values;	/* NAN: left out */
	size_t count;
};

bool sinumerik_argument_given(const struct sinumerik_arguments *arguments, size_t i);

/* Is the argument given and not 0? For many arguments 0 is the same as none. */
bool sinumerik_argument_counts(const struct sinumerik_arguments *arguments, size_t i);

double sinumerik_argument_or(const struct sinumerik_arguments *arguments, size_t i, double otherwise);

/* A length in mm; 0 if it is left out. */
double sinumerik_argument_length(const struct sinumerik_arguments *arguments, size_t i);

/* A decimal digit of a whole number: 0 the units, 1 the tens ... */
int sinumerik_argument_digit(const struct sinumerik_arguments *arguments, size_t i, int place);

/* The indices of the three arguments of a cycle that define the meaning of the others; 0: there is none. */
struct sinumerik_modes {
	size_t geometry, display, alternative;	/* _GMODE, _DMODE, _AMODE */
	bool has_relative;	/* DPR */
};

/* Do the units of _DMODE select the active plane? False: reported. */
bool sinumerik_argument_plane(const struct sinumerik_arguments *arguments, size_t display);

/* Heights above the plane: coordinates of the axis perpendicular to the plane, mm. */
struct sinumerik_heights {
	double clear;	/* RTP */
	double safe;	/* RFP + SDIS */
	double reference;	/* RFP */
	double bottom;
};

/* False: the heights contradict each other, or are not for the active plane, which was reported. */
bool sinumerik_argument_heights(const struct sinumerik_arguments *arguments, const struct sinumerik_modes *modes,
				struct sinumerik_heights *heights);

#endif
