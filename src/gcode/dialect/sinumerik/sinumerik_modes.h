/* sinumerik_modes.h - the modes that the program sets, and what SAVE keeps of them. */
#ifndef FIVECHECK_GCODE_DIALECT_SINUMERIK_SINUMERIK_MODES_H
#define FIVECHECK_GCODE_DIALECT_SINUMERIK_SINUMERIK_MODES_H

#include "gcode/dialect/sinumerik/sinumerik_frames.h"
#include "gcode/dialect/sinumerik/sinumerik_values.h"
#include "gcode/state.h"

struct sinumerik_path {
	int code;	/* G60, G64, G641 ... */
	double rounding, rapid_rounding;	/* mm: ADIS and ADISPOS, for G641 */
	double rapid_factor;	/* STOLF; 0: none was given */
	double smoothing;	/* mm: the tolerance of CYCLE832 or CTOL; 0: not known */
	double orientation_tolerance;	/* degrees: OTOL or that of CYCLE832; 0: not known */
	bool smooths_orientation;	/* ORISON */
	bool compresses;	/* COMPCAD and its like */
};

/* How TRAORI turns the tool between two orientations. */
enum sinumerik_orientation_way { SINUMERIK_ORI_UNKNOWN, SINUMERIK_ORI_AXES, SINUMERIK_ORI_VECTOR };

struct sinumerik_orientation {
	enum sinumerik_orientation_way way;
	int angles;	/* ORIEULER, ORIRPY, ORIRPY2; 0: none was given */
	bool in_machine;	/* ORIMKS */
};

struct sinumerik_comp {
	int approach;	/* NORM, KONT, or CODE_NONE: a parameter says */
	int corner;	/* G450, G451, or CODE_NONE */
	double disc;	/* DISC: 0 is a circle */
	double allowance;	/* mm: OFFN */
	bool turns_plane;	/* CUT2DF */
};

struct sinumerik_tools {
	int edge;	/* D */
	bool edge_unsure;	/* since M6: a parameter decides whether D1 is active */
	bool t_waits;	/* T was read without an M6 since: a parameter decides whether T changes the tool */
	bool changed;	/* by M6 */
	bool changes_ahead;	/* the program has an M6 after its first T */
	const struct source *no_change_ahead;	/* the last file without an M6 after T; NULL: none */
	struct sinumerik_text *names;	/* of tools, without a setup; owned */
	size_t name_count, name_capacity;
};

/* The modes that SAVE of PROC keeps for the return. */
struct sinumerik_saved {
	int motion, plane, system;
	int comp_side;
	bool incremental;
	unsigned unknown_modes;
	enum feed_mode feed_mode;
	enum tcp_source tcp;
	double scale, feed_scale;
	struct sinumerik_path path;
	struct sinumerik_orientation orientation;
	struct sinumerik_comp comp;
	struct sinumerik_frames frames;
};

#endif
