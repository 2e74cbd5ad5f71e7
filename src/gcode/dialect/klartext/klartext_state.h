/* klartext_state.h - the state of a Heidenhain control for a program, besides the modes of every control. */
#ifndef FIVECHECK_GCODE_DIALECT_KLARTEXT_KLARTEXT_STATE_H
#define FIVECHECK_GCODE_DIALECT_KLARTEXT_KLARTEXT_STATE_H

#include <stdbool.h>

#include "base/strbuf.h"
#include "gcode/execute/parallel_moves.h"
#include "gcode/state.h"
#include "gcode/text/label.h"
#include "geom/xform.h"

/* Q0 to Q1999; QL0 to QL499 of each program; QR0 to QR499. */
#define KLARTEXT_Q_COUNT 2000
#define KLARTEXT_QL_COUNT 500
/* TNC 640 user's manual, "Nesting": 19 nested calls. */
#define KLARTEXT_CALLS_MAX 19
/* Program section repeats that are active at the same time. */
#define KLARTEXT_REPEATS_MAX 100
/* Parameters of one CYCL DEF: Q200 and the like, or the lines 7.1, 7.2 of older cycles. */
#define KLARTEXT_CYCLE_WORDS 32
/* iTNC 530 user's manual, "CONTOUR GEOMETRY (Cycle 14)": up to 12 subprograms. */
#define KLARTEXT_CONTOURS_MAX 12
/* A label's or a program's name, or a string. */
#define KLARTEXT_NAME 128
#define KLARTEXT_STRINGS_MAX 64

/* The query of FN 18: ID, NR and IDX. */
struct klartext_query {
	int id, number, index;
	bool has_index;
};

/* One of Q, QL and QR. */
struct klartext_q {
	double value;
	bool given; /* by this program, or by the control */
	bool read; /* from the control, by FN 18 or FN 28: its value is not known here */
	bool undefined; /* by SET UNDEFINED */
	bool pole; /* read, of an axis whose angle is arbitrary: swivel_pole of the machine would give it */
	struct klartext_query query; /* of FN 18, if FN 18 read it; else the ID is 0 */
};

/* QS<number>. */
struct klartext_string {
	int number;
	char text[KLARTEXT_NAME];
};

enum klartext_call_kind { KLARTEXT_MAIN, KLARTEXT_LABEL, KLARTEXT_PROGRAM };

/* An active subprogram; the first one is the main program. */
struct klartext_call {
	enum klartext_call_kind kind;
	char title[KLARTEXT_NAME]; /* "LBL 5", "sub.h" */
	struct position back;
	const char *file; /* of the call */
	long line;
	int column;
};

/* An active CALL LBL ... REP. */
struct klartext_repeat {
	struct position at; /* of its line */
	int level; /* of calls */
	int left;
	long long start; /* offset of its label */
	bool left_by_jump; /* a jump left the section: whether the count restarts is not known */
};

/* A line of an older cycle: its letters, also those without values, and their values. */
struct klartext_cycle_word {
	char name[12]; /* "Q200", "X", "DEPTH" */
	int part; /* of an older cycle: the digit after the point in its line */
	double value;
	bool given; /* the name has a value */
	int column;
	long line;
};

struct klartext_cycle {
	int number; /* 200, 7, ...; 0: none */
	int part; /* the digit after the point in the last line of an older cycle */
	bool open; /* further lines may follow */
	bool refused; /* and reported: the rest is read, and has no effect */
	bool by_q; /* its words are Q parameters */
	bool continued; /* by '~' after parameters: the first line without '~' is the last one */
	bool numbered; /* CYCL DEF has a block number: lines without one continue it */
	long line; /* of CYCL DEF */
	int column;
	struct klartext_cycle_word words[KLARTEXT_CYCLE_WORDS];
	int count;
};

/*
 * The position of a point of the program is offset + origin + turn (scale point), for X, Y and Z. The parts, from the
 * inside: mirror, rotation, scaling and a shift of the tilted coordinates; the tilted plane; a datum shift.
 */
struct klartext_frame {
	vec3 shift; /* CYCL DEF 7, in coordinates that are not tilted, mm */
	bool tilted;
	mat3 tilt;
	vec3 inner; /* CYCL DEF 7 in tilted coordinates, mm */
	bool mirror[3];
	double rotation; /* degrees about Z */
	vec3 factor; /* of CYCL DEF 11 and 26 */
	vec3 centre; /* of CYCL DEF 26, mm */
	int scaled_by; /* the number of the last cycle that has set the factors */
	/* Derived: */
	bool any;
	mat3 turn; /* orthogonal; its determinant is -1 while mirrored */
	vec3 scale, origin;
};

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

/* Of PATTERN DEF, CYCL DEF 220 and 221. */
#define KLARTEXT_POINTS_MAX 1000

/* The points at which a cycle is called; z is added to its surface. mm. */
struct klartext_points {
	vec3 items[KLARTEXT_POINTS_MAX];
	int count;
	long line; /* the last line of their definition; 0: none */
	bool any_order; /* the control's order of the points is not known */
	bool surface; /* z is the surface itself, in a point table */
	bool single; /* POS of PATTERN DEF has given the last one */
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

/* The words of the current FK block, mm and degrees; the pole is that of FPOL. */
struct klartext_free {
	bool has[KLARTEXT_FREE_COUNT];
	double value[KLARTEXT_FREE_COUNT];
	bool has_pole;
	double pole[2];
};

struct klartext {
	bool begun; /* BEGIN PGM has been read */
	bool numbered; /* the current line has a block number */
	bool cycle_in_full; /* CYCLE has been read, and was reported */
	bool comment_goes_on; /* '~' at the end of a comment */
	bool tail_goes_on; /* the block before ends with a comment that ends with '~' */
	bool skips, skips_next; /* a definition with '/' is skipped: also its parameters; the next line in any case */
	bool behind_end; /* M2 or M30 has been carried out: only END PGM may follow */
	bool inch;
	bool jumped; /* blocks are counted from the first jump on */
	struct klartext_q q[KLARTEXT_Q_COUNT], qr[KLARTEXT_QL_COUNT], ql[KLARTEXT_CALLS_MAX + 1][KLARTEXT_QL_COUNT];
	struct klartext_string strings[KLARTEXT_STRINGS_MAX];
	int string_count;
	bool synchronised; /* no block has moved since FN 20: WAIT FOR SYNC, with the axes here */
	slot_values synchronised_at;
	bool strings_read; /* FN 28 has read texts that are not known here */
	struct klartext_call calls[KLARTEXT_CALLS_MAX + 1];
	int level, programs; /* nested calls; those of programs among them */
	struct klartext_repeat repeats[KLARTEXT_REPEATS_MAX];
	int repeat_count;
	struct labels labels; /* of every source that was searched */
	char selected[KLARTEXT_NAME]; /* by SEL PGM; empty: none */
	char cycle_program[KLARTEXT_NAME]; /* of CYCL DEF 12 */
	char table[KLARTEXT_NAME]; /* of SEL TABLE */
	struct strbuf line; /* the current line, while other lines are read */
	struct strbuf folders; /* of the files that were called */
	struct strbuf joined; /* a block or a formula of several lines */
	/* Tools. */
	bool change_pending; /* TOOL CALL was the last block: M6 belongs to it */
	bool moved; /* axes have moved since TOOL CALL */
	bool called; /* the program has called a tool */
	bool shifted[SLOT_COUNT]; /* CYCL DEF 7 shifted this rotary axis, and no absolute word was read since */
	bool oversize; /* TOOL CALL has given DL, DR or DR2 */
	double delta_radius, delta_length; /* mm: DR and DL of TOOL CALL */
	int defined_tool; /* TOOL DEF has given this tool a radius; 0: none */
	double defined_radius; /* mm */
	bool per_revolution; /* M136 */
	double call_feed, call_feed_bare; /* of TOOL CALL, for F AUTO: mm/min, and without conversion; 0: none */
	/* Path. */
	vec3 programmed; /* the end of the last move in the coordinates of that time, mm: the start of increments */
	vec3 pole;
	vec3 pole_place; /* the place of the pole when CC was read, without the tool's length */
	bool has_pole[3];
	struct {
		bool given;
		double radius, angle; /* mm, degrees */
	} polar; /* of the last block in polar coordinates */
	int across; /* slot of the axis perpendicular to the plane of CC: Z, or X or Y */
	bool spatial_pole; /* CC has X, Y and Z: the plane is that of the tool axis, if the circle fits */
	struct klartext_path last; /* the move before, for CT and corners */
	struct klartext_free free;
	struct klartext_corner corner;
	struct klartext_approach approach;
	bool height_open; /* after a cycle that is not followed the height is not known, until a word sets it */
	bool left_open; /* after a milling cycle the tool is anywhere in the box `open`; cutter_comp.loose covers it */
	struct parallel_box open;
	bool looks_ahead; /* M120 LA: radius compensation omits moves that the tool cannot reach */
	bool open_crossing; /* M97 was in the last path block under radius compensation */
	bool shortest; /* M126 */
	bool spatial; /* TCPM with AXIS SPAT: A, B and C are spatial angles */
	bool by_vector; /* TCPM with PATHCTRL VECTOR: the tool turns in the plane of its directions */
	bool spatial_given[3];
	double spatial_angle[3]; /* degrees */
	bool cautioned_wrap, cautioned_teeth, preset_settled;
	int preset_row; /* that the program has selected; 0: none, or the datum that was set by hand */
	struct klartext_frame frame;
	/*
	 * Bits of X, Y and Z: a shift in the tilted plane names an axis that an earlier shift moves, too; after the end
	 * of the plane it is not known whether the earlier shift is still active.
	 */
	unsigned shift_in_plane, shift_open;
	bool preset_in_plane; /* CYCL DEF 247 in a tilted plane: whether the plane stays tilted is not known */
	/* PLANE ... STAY: linear axes must wait until the rotary axes are at the positions of the plane. */
	bool waits;
	bool rotary_needed[SLOT_COUNT];
	axis_values rotary; /* radians */
	double cycle_19[3]; /* A, B and C of CYCL DEF 19, degrees */
	bool cycle_19_counts; /* neither PLANE nor an empty CYCL DEF 19 was read since */
	struct klartext_cycle definition; /* the one that is being read */
	struct klartext_cycle cycle; /* the one that M99 and CYCL CALL carry out */
	bool modal_call; /* M89 */
	int contours[KLARTEXT_CONTOURS_MAX]; /* labels of CYCL DEF 14 */
	int contour_count;
	struct klartext_cycle contour_data; /* CYCL DEF 20 */
	struct klartext_points points;
};

static inline struct klartext *klartext_of(const struct interp *interp)
{
	return interp->dialect_state;
}

void *klartext_state_new(void);
void klartext_state_free(void *state);

#endif
