/* sinumerik_modes.h - the modes that the program sets, and what SAVE keeps of them. */
#ifndef FIVECHECK_GCODE_DIALECT_SINUMERIK_STATE_SINUMERIK_MODES_H
#define FIVECHECK_GCODE_DIALECT_SINUMERIK_STATE_SINUMERIK_MODES_H

#include "gcode/dialect/sinumerik/state/sinumerik_frames.h"
#include "gcode/dialect/sinumerik/state/sinumerik_values.h"
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
	int selected;	/* the last G40, G41 or G42; 0: none was given */
	int soft_side;	/* G140 to G143; 0: none was given */
	int soft_way;	/* G340, G341; 0: none was given */
};

/* DISCL or DISRP. */
struct sinumerik_soft_height {
	bool given, absolute;
	double value;	/* mm: above the contour; absolute: a straight position (rotated_frame.h) */
};

/* What a block with G147, G148 and the like has said. */
struct sinumerik_soft_words {
	int code, column;
	double size;	/* mm: DISR */
	struct sinumerik_soft_height clearance, retract;
	bool rapid_before;	/* the block before moved with G0 */
	bool has_slow, has_feed;	/* FAD, F */
	struct canon_feed before, slow, own;	/* of the block before, FAD, F */
	struct canon_feed path;	/* of the path that touches the contour; on retraction of the way behind P2 */
};

/* A block that waits; the line and its text are copies. */
struct sinumerik_soft_block {
	bool kept;
	struct block block;
	struct line_place at;
	struct call_chain callers;
	char *text;	/* owned */
};

/* G147, G247 and G347 wait for the path that gives the direction of the contour at its start. */
struct sinumerik_soft {
	bool waits;
	bool fresh;	/* the current block waits */
	bool needs_end;	/* the next path gives P4 */
	bool cautioned;	/* the warning that MD20150 decides between G340 and G341 was given */
	struct sinumerik_soft_words words;
	slot_values start, end;	/* P0 and P4, straight */
	struct sinumerik_soft_block first, second;	/* that of the code, and that which has given P4 */
	int motion_before;	/* of the block before the current one that has such a code */
	double linear_before, angular_before;	/* its feed: mm and degrees a minute or a turn */
	enum feed_mode mode_before;
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
