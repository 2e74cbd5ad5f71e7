/* klartext_paths.h - the path before, and blocks that wait for the path after them. */
#ifndef FIVECHECK_GCODE_DIALECT_KLARTEXT_STATE_KLARTEXT_PATHS_H
#define FIVECHECK_GCODE_DIALECT_KLARTEXT_STATE_KLARTEXT_PATHS_H

#include <stdbool.h>

#include "base/strbuf.h"
#include "gcode/execute/parallel_moves.h"
#include "gcode/state.h"
#include "geom/vec3.h"

enum klartext_comp { KLARTEXT_R_NONE, KLARTEXT_R0, KLARTEXT_RL, KLARTEXT_RR };

/* A straight line or a circle in program coordinates, mm. */
struct klartext_path {
	bool known;
	bool arc;
	vec3 start, end;
	vec3 centre, normal;
	double sweep; /* radians about the normal */
	bool rapid;
	struct canon_feed feed;
	bool open; /* a circle with an unknown plane: the tool is at most `half` mm from this straight line */
	double half[3];
	bool crossing; /* M97: under radius compensation it is extended to its intersection with the next one */
	int column; /* of its words */
};

/* CC, and the last block in polar coordinates. */
struct klartext_pole {
	vec3 point;
	vec3 place; /* the place of the pole when CC was read, without the tool's length */
	bool has[3]; /* this coordinate was given */
	int across; /* slot of the axis perpendicular to the plane of CC: Z, or X or Y */
	bool spatial; /* CC has X, Y and Z: the plane is that of the tool axis, if the circle fits */
	struct {
		bool given;
		double radius, angle; /* mm, degrees */
	} polar; /* of the last block in polar coordinates */
};

enum klartext_way { KLARTEXT_WAY_LT, KLARTEXT_WAY_LN, KLARTEXT_WAY_CT, KLARTEXT_WAY_LCT };

/* LEN, R and CCA of APPR and DEP. */
struct klartext_way_words {
	double length, size; /* mm */
	double centre_angle; /* degrees */
	enum klartext_comp comp;
	int comp_column, size_column, first_column;
};

/* APPR, which waits for the first path of the contour. */
struct klartext_approach {
	bool waits;
	enum klartext_way kind;
	struct klartext_way_words words;
	struct klartext_path path; /* from PS to PA: its ends, feed and column count */
	bool rapid_before; /* the block before moved at FMAX */
	long line;
	struct strbuf text; /* of the line */
};

/* A path block that is held until RND or CHF and the block after it determine its end. */
struct klartext_corner {
	bool waits;
	bool chamfer;
	double size; /* mm; 0: RND or CHF has not been read yet */
	double feed; /* mm/s, only for the corner; 0: that of the block before */
	int column;
	long line;
	struct klartext_path path; /* of the held block */
	long path_line;
	enum spindle_turn spindle; /* during its move */
	bool speed_is_zero;
	struct strbuf path_text, text; /* of both lines */
};

/* Words of FK: gradient angle, length, end, centre and angle of a circle, closed contour. */
enum klartext_free_word {
	KLARTEXT_FREE_AN,
	KLARTEXT_FREE_IAN,
	KLARTEXT_FREE_LEN,
	KLARTEXT_FREE_PR,
	KLARTEXT_FREE_PA,
	KLARTEXT_FREE_CCX,
	KLARTEXT_FREE_CCY,
	KLARTEXT_FREE_CCPR,
	KLARTEXT_FREE_CCPA,
	KLARTEXT_FREE_CCA,
	KLARTEXT_FREE_CLOSED,
	KLARTEXT_FREE_COUNT
};

/* The words of the current FK block, mm and degrees; the value of CLSD is 1 for CLSD+ and -1 for CLSD-. */
struct klartext_free {
	bool has[KLARTEXT_FREE_COUNT];
	double value[KLARTEXT_FREE_COUNT];
	bool has_pole;
	double pole[2]; /* of FPOL */
	bool has_begin;
	double begin[2]; /* where the element with CLSD+ has begun */
};

/* Radius compensation. */
struct klartext_crossing {
	bool looks_ahead; /* M120 LA: moves that the tool cannot reach are omitted */
	bool open; /* M97 was in the last path block */
	bool on_path; /* RL or RR is in force with a radius of 0: the tool is on the path */
};

/* Where the tool is after a cycle of which only the region is known. */
struct klartext_open {
	bool height; /* the height is not known until a word sets it */
	bool aside; /* the tool is anywhere in the box; cutter_comp.loose covers it */
	struct parallel_box box;
};

#endif
