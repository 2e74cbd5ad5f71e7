/* klartext_state.h - what a Heidenhain control remembers of a program beside the modes of every control. */
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
/* TNC 640 user's manual, "Nesting": 19 calls inside each other. */
#define KLARTEXT_CALLS_MAX 19
/* Program section repeats under way at once. */
#define KLARTEXT_REPEATS_MAX 100
/* Parameters of one CYCL DEF: Q200 and the like, or the lines 7.1, 7.2 of older cycles. */
#define KLARTEXT_CYCLE_WORDS 32
/* iTNC 530 user's manual, "CONTOUR GEOMETRY (Cycle 14)": up to 12 subprograms. */
#define KLARTEXT_CONTOURS_MAX 12
/* A label's or a program's name, or a string. */
#define KLARTEXT_NAME 128
#define KLARTEXT_STRINGS_MAX 64

/* What FN 18 asks for: ID, NR and IDX. */
struct klartext_query {
	int id, number, index;
	bool has_index;
};

/* One of Q, QL and QR. */
struct klartext_q {
	double value;
	bool given; /* by this program, or by the control */
	bool read; /* from the control, by FN 18 or FN 28: it has a value, which is not known here */
	bool undefined; /* by SET UNDEFINED */
	bool pole; /* read, of an axis that any angle suits: swivel_pole of the machine would say it */
	struct klartext_query query; /* of FN 18, if it was read by that; an ID of 0: it was not */
};

/* QS<number>. */
struct klartext_string {
	int number;
	char text[KLARTEXT_NAME];
};

enum klartext_call_kind { KLARTEXT_MAIN, KLARTEXT_LABEL, KLARTEXT_PROGRAM };

/* A subprogram under way; the first one is the program itself. */
struct klartext_call {
	enum klartext_call_kind kind;
	char title[KLARTEXT_NAME]; /* "LBL 5", "sub.h" */
	struct position back;
	const char *file; /* of the call */
	long line;
	int column;
};

/* CALL LBL ... REP, under way. */
struct klartext_repeat {
	struct position at; /* of its line */
	int level; /* of calls */
	int left;
	long long start; /* offset of its label */
	bool left_by_jump; /* out of the section: whether the count begins anew is not known */
};

/* A line of an older cycle: its letters, bare ones included, and their values. */
struct klartext_cycle_word {
	char name[12]; /* "Q200", "X", "DEPTH" */
	int part; /* of an older cycle: the digit behind the point of its line */
	double value;
	bool given; /* a value stood behind the name */
	int column;
	long line;
};

struct klartext_cycle {
	int number; /* 200, 7, ...; 0: none */
	int part; /* the digit behind the point of an older cycle's line, the last one */
	bool open; /* further lines may follow */
	bool refused; /* which was reported: it is read on, and nothing comes of it */
	bool by_q; /* its words are Q parameters */
	bool continued; /* by '~' behind parameters: the first line without it is the last one */
	bool numbered; /* CYCL DEF has a block number: lines without one go on */
	long line; /* of CYCL DEF */
	int column;
	struct klartext_cycle_word words[KLARTEXT_CYCLE_WORDS];
	int count;
};

/*
 * From a point of the program to the position: offset + origin + turn (scale point), for X, Y and Z. What it is made
 * of: mirror, rotation, scaling and a shift of the tilted coordinates inside; the tilted plane; a datum shift outside.
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
	int scaled_by; /* the number of the cycle that has set the factors, the last one */
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
	bool open; /* a circle whose plane is open: the tool is at most `half` mm beside this straight line */
	double half[3];
	bool crossing; /* M97: under radius compensation it is drawn out to where it crosses the next one */
	int column; /* of its words */
};

/* Of PATTERN DEF, CYCL DEF 220 and 221. */
#define KLARTEXT_POINTS_MAX 1000

/* Where a cycle is called; z is added to its surface. mm. */
struct klartext_points {
	vec3 items[KLARTEXT_POINTS_MAX];
	int count;
	long line; /* that defines them, the last one; 0: none */
	bool any_order; /* in which order the control takes them is not known */
	bool surface; /* z is the surface itself, of a point table */
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
	bool rapid_before; /* the block before went at FMAX */
	long line;
	struct strbuf text; /* of the line */
};

/* A path block that is kept back until RND or CHF and the block behind it say where it ends. */
struct klartext_corner {
	bool waits;
	bool chamfer;
	double size; /* mm; 0: RND or CHF has not been read yet */
	double feed; /* mm/s of the corner alone; 0: that of the block before */
	int column;
	long line;
	struct klartext_path path; /* of the block kept back */
	long path_line;
	enum spindle_turn spindle; /* while it moves */
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

/* Of the FK block in hand, mm and degrees; the pole is that of FPOL. */
struct klartext_free {
	bool has[KLARTEXT_FREE_COUNT];
	double value[KLARTEXT_FREE_COUNT];
	bool has_pole;
	double pole[2];
};

struct klartext {
	bool begun; /* BEGIN PGM has been met */
	bool numbered; /* the line in hand has a block number */
	bool cycle_in_full; /* CYCLE has been met, and was told */
	bool comment_goes_on; /* '~' at the end of a comment */
	bool tail_goes_on; /* the block before ends with a comment, and that with '~' */
	bool skips, skips_next; /* a definition with '/' was left out: its parameters; the next line in any case */
	bool behind_end; /* M2 or M30 has been met: only END PGM counts */
	bool inch;
	bool jumped; /* blocks are counted from the first jump on */
	struct klartext_q q[KLARTEXT_Q_COUNT], qr[KLARTEXT_QL_COUNT], ql[KLARTEXT_CALLS_MAX + 1][KLARTEXT_QL_COUNT];
	struct klartext_string strings[KLARTEXT_STRINGS_MAX];
	int string_count;
	bool synchronised; /* no block has moved since FN 20: WAIT FOR SYNC, with the axes here */
	slot_values synchronised_at;
	bool strings_read; /* FN 28 has read texts that are not known here */
	struct klartext_call calls[KLARTEXT_CALLS_MAX + 1];
	int level, programs; /* calls inside each other; of these, of programs */
	struct klartext_repeat repeats[KLARTEXT_REPEATS_MAX];
	int repeat_count;
	struct labels labels; /* of every source that was searched */
	char selected[KLARTEXT_NAME]; /* by SEL PGM; empty: none */
	char cycle_program[KLARTEXT_NAME]; /* of CYCL DEF 12 */
	char table[KLARTEXT_NAME]; /* of SEL TABLE */
	struct strbuf line; /* the line in hand, while others are read */
	struct strbuf folders; /* in which the files that were called lie */
	struct strbuf joined; /* a block or a formula of several lines */
	/* Tools. */
	bool change_pending; /* TOOL CALL was the last block: M6 belongs to it */
	bool moved; /* axes have moved since TOOL CALL */
	bool called; /* the program has called a tool */
	bool shifted[SLOT_COUNT]; /* CYCL DEF 7 has shifted this rotary axis, and no absolute word came since */
	bool oversize; /* TOOL CALL has given DL, DR or DR2 */
	double delta_radius, delta_length; /* mm: DR and DL of TOOL CALL */
	int defined_tool; /* TOOL DEF has given this tool a radius; 0: none */
	double defined_radius; /* mm */
	bool per_revolution; /* M136 */
	double call_feed, call_feed_bare; /* of TOOL CALL, for F AUTO: mm/min, and as written; 0: none */
	/* Path. */
	vec3 programmed; /* where the last move has led, in the coordinates of then, mm: increments count from there */
	vec3 pole;
	vec3 pole_place; /* where it lay when CC gave it, without the tool's length */
	bool has_pole[3];
	struct {
		bool given;
		double radius, angle; /* mm, degrees */
	} polar; /* of the last block in polar coordinates */
	int across; /* slot of the axis across the plane of CC: Z, or X or Y */
	bool spatial_pole; /* CC has named X, Y and Z: the plane is that of the tool axis, if its circle fits */
	struct klartext_path last; /* the move before, for CT and corners */
	struct klartext_free free;
	struct klartext_corner corner;
	struct klartext_approach approach;
	bool height_open; /* a cycle that is not followed has left the tool at a height that no word has set since */
	bool left_open; /* a milling cycle has left the tool anywhere in the box `open`; cutter_comp.loose covers it */
	struct parallel_box open;
	bool looks_ahead; /* M120 LA: radius compensation leaves out what the tool cannot reach */
	bool open_crossing; /* M97 was in the last path block under radius compensation */
	bool shortest; /* M126 */
	bool spatial; /* TCPM with AXIS SPAT: A, B and C are spatial angles */
	bool by_vector; /* TCPM with PATHCTRL VECTOR: the tool turns in the plane of its directions */
	bool spatial_given[3];
	double spatial_angle[3]; /* degrees */
	bool cautioned_wrap, cautioned_teeth, preset_settled;
	struct klartext_frame frame;
	/*
	 * Bits of X, Y and Z: a shift in the tilted plane names an axis that one from before shifts, too; behind the
	 * plane it is open whether that one still counts.
	 */
	unsigned shift_in_plane, shift_open;
	bool preset_in_plane; /* CYCL DEF 247 while the plane is tilted: whether it stays so is not known */
	/* PLANE ... STAY: linear axes wait until the rotary axes stand where the plane needs them. */
	bool waits;
	bool rotary_needed[SLOT_COUNT];
	axis_values rotary; /* radians */
	double cycle_19[3]; /* A, B and C as CYCL DEF 19 has given them, degrees */
	bool cycle_19_counts; /* neither PLANE nor an empty CYCL DEF 19 has come since */
	struct klartext_cycle definition; /* under way */
	struct klartext_cycle cycle; /* that M99 and CYCL CALL carry out */
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
