/* sinumerik_state.h - the state of the sinumerik dialect for a program: variables, modes, loops and calls. */
#ifndef FIVECHECK_GCODE_DIALECT_SINUMERIK_SINUMERIK_STATE_H
#define FIVECHECK_GCODE_DIALECT_SINUMERIK_SINUMERIK_STATE_H

#include "base/strbuf.h"
#include "gcode/execute/parallel_moves.h"
#include "gcode/state.h"

/* Siemens 840D sl, NC programming: 32 bytes a name, strings of 200 bytes, arrays of three dimensions, 16 levels. */
#define SINUMERIK_NAME 32
#define SINUMERIK_TEXT 200
#define SINUMERIK_DIMENSIONS 3
#define SINUMERIK_LEVELS_MAX 16
#define SINUMERIK_R_COUNT 1000
/* Nested loops in one program: eight by the manual; a loop that a jump has left may remain here. */
#define SINUMERIK_LOOPS_MAX 64
/* Parameters of a subprogram or of a cycle. */
#define SINUMERIK_ARGUMENTS_MAX 40

struct sinumerik_text {
	char bytes[SINUMERIK_TEXT + 1];
};

enum sinumerik_type { SINUMERIK_INT, SINUMERIK_REAL, SINUMERIK_BOOL, SINUMERIK_CHAR, SINUMERIK_STRING, SINUMERIK_AXIS };

/* Variables of the machine's maker and of users (GUD) belong to no program. */
#define SINUMERIK_LEVEL_OF_CONTROL (-1)

/* Made by DEF, as a parameter of PROC, or by the machine file. */
struct sinumerik_variable {
	char name[SINUMERIK_NAME + 1];	/* upper case */
	enum sinumerik_type type;
	int dimensions;	/* 0: one value */
	int size[SINUMERIK_DIMENSIONS];
	int length;	/* of STRING[length]; 0: none was given */
	size_t count;
	double *numbers;	/* owned; NULL: texts; AXIS: slots */
	struct sinumerik_text *texts;	/* owned */
	bool *given;	/* owned: the known values of a variable of the control; NULL: all are known */
	int refers_to;	/* a VAR parameter: the variable of the caller; or -1 */
	int level;	/* of the call whose program has made it */
};

enum sinumerik_loop_kind { SINUMERIK_WHILE, SINUMERIK_FOR, SINUMERIK_LOOP, SINUMERIK_REPEAT };

struct sinumerik_loop {
	enum sinumerik_loop_kind kind;
	struct position start;	/* of the line that begins it */
	long end;	/* line of its end; 0: not searched yet */
	int level;
	double last;	/* FOR: the value after TO */
	bool again;	/* its end was reached, and the next pass starts */
};

/*
 * The programmable frame: program coordinates p become matrix p + shift, before the work offset. Rotary axes and U V W
 * are shifted only.
 */
struct sinumerik_frame {
	mat3 matrix;
	slot_values shift;	/* X Y Z: translation after the matrix */
	slot_values fine;	/* the part of the shift from ATRANS and G59, which G58 does not change */
};

/* Polar coordinates: sinumerik_polar.h. */
struct sinumerik_polar {
	struct plane_point pole;	/* program coordinates, mm */
	int plane;	/* that it was given in */
	bool has_radius, has_angle;
	double radius, angle;	/* mm, degrees: given last */
};

/* The direction at the end of the last motion, in its plane; program coordinates. */
struct sinumerik_tangent {
	bool known;	/* false if the motion is too short */
	int plane;
	struct plane_point way;	/* mm: a vector in this direction */
	struct plane_point end;	/* the end of the motion, mm */
};

/* How TRAORI turns the tool between two orientations. */
enum sinumerik_orientation { SINUMERIK_ORI_UNKNOWN, SINUMERIK_ORI_AXES, SINUMERIK_ORI_VECTOR };

/* The modes that SAVE of PROC keeps for the return. */
struct sinumerik_saved {
	int motion, plane, system, path_code;
	int approach, corner, comp_side, orientation_angles;
	bool incremental, compresses, smooths_orientation, machine_orientation, turns_plane, tool_frame;
	bool frame_unsure;
	enum sinumerik_orientation orientation;
	unsigned unknown_modes;
	enum feed_mode feed_mode;
	enum tcp_source tcp;
	double scale, feed_scale, smoothing, rounding, rapid_rounding, rapid_factor, orientation_tolerance;
	struct sinumerik_frame frame, swivel;
};

/* REPEAT LABEL [LABEL] [P=n] that is being repeated, and calls. */
struct sinumerik_call {
	struct position back;	/* the line after the call */
	struct position entry;	/* the first line of the subprogram, or of the repeated part */
	long last_line;	/* of a repeated part: behind it, the next round starts or the call ends; 0: a subprogram */
	bool called;	/* the part, by CALL BLOCK, as a subprogram */
	int left;	/* remaining repetitions */
	const char *file;	/* of the call */
	long line;
	int column;
	char title[SINUMERIK_NAME + 1];
	bool saves;	/* PROC ... SAVE: the return restores G-codes and frames */
	struct sinumerik_saved saved;
	size_t loops;	/* open at the call */
	size_t argument_count;	/* of a repeated subprogram: each repetition starts with them */
	double arguments[SINUMERIK_ARGUMENTS_MAX];
	double begun[SINUMERIK_ARGUMENTS_MAX];	/* the initial values of its parameters */
	size_t begun_count;
};

/* The result of a search for a jump target or the end of a structure: this makes jumps in loops fast. */
struct sinumerik_jump {
	const struct source *source;
	long long from;
	char target[SINUMERIK_NAME + 2];	/* a byte for the kind of the search, and the name */
	struct position to;
};

#define SINUMERIK_JUMPS 256

/*
 * A modal call: MCALL CYCLE81(...) or MCALL NAME. There is one at a time; it also acts in subprograms and repeated
 * parts.
 */
struct sinumerik_modal {
	bool on;
	bool cycle;	/* that drills or mills; else a subprogram */
	bool running;	/* the subprogram is being carried out: it does not call itself */
	int depth;	/* of calls where the subprogram runs */
	int level;	/* of the program that has given it */
	char name[SINUMERIK_NAME + 1];
	size_t argument_count;
	double arguments[SINUMERIK_ARGUMENTS_MAX];	/* NAN: left out */
	long line;
};

/* A pattern of holes at which MCALL calls a subprogram: each return continues at its line, with the next hole. */
struct sinumerik_pattern {
	bool on;
	char name[SINUMERIK_NAME + 1];
	struct position line;
	int depth;	/* of calls at this line */
	int column, plane;
	double scale;	/* mm per unit of length */
	slot_values from;	/* program coordinates of the tool: a row begins at the nearer end */
	long done;	/* holes */
	struct sinumerik_saved before;	/* modes that are restored after the pattern */
	size_t argument_count;
	double arguments[SINUMERIK_ARGUMENTS_MAX];
};

/* A contour that CYCLE62 has selected, and the one that CYCLE72 follows. */
struct sinumerik_contour {
	int selected;	/* calls of CYCLE62 since the last contour was milled */
	struct sinumerik_text name;	/* of the subprogram, or "FIRST:LAST", two labels */
	bool on;
	struct position line;	/* of CYCLE72 */
	int depth;	/* of calls at this line */
	int column, plane;
	bool begun;	/* its first point is known: */
	bool names_point;	/* the current block gives both coordinates of the plane */
	slot_values from, start;	/* before the cycle, and the first point: program coordinates, mm */
	double clear, safe, bottom;	/* heights */
	double beside, ends;	/* mm: how far the tool may be from the contour, and from its ends */
	double drawn_out;	/* mm: how far the tool may be from a corner */
	vec3 heading;	/* unit, in the plane: of the end of the last move; 0: none yet */
	double rounded;	/* mm: the distance of a rounding or chamfer from the end of the last block */
	bool stays_low;	/* between two passes the tool may return inside the material */
	bool backward;	/* the tool starts at the last point */
	double feed;	/* mm/s */
	struct sinumerik_saved before;	/* modes and the feed (mm/min) that hold again behind the cycle */
	double feed_before;
};

/* Made by DEFINE. */
struct sinumerik_macro {
	char name[SINUMERIK_NAME + 1];	/* upper case */
	char *text;	/* owned */
	int level;	/* of the call whose program has made it */
};

struct sinumerik {
	struct sinumerik_variable *variables;	/* owned */
	size_t variable_count, variable_capacity;
	size_t elements;	/* of all of them */
	double r[SINUMERIK_R_COUNT];	/* NAN: the program has not assigned it */
	struct sinumerik_loop loops[SINUMERIK_LOOPS_MAX];
	size_t loop_count;
	struct sinumerik_call calls[SINUMERIK_LEVELS_MAX];
	int depth;	/* of calls */
	int level;	/* calls of subprograms among them: where variables belong to; 0: the main program */
	bool entering;	/* the next line may be the PROC of the subprogram that is called */
	size_t argument_count;	/* of the call */
	double arguments[SINUMERIK_ARGUMENTS_MAX];	/* NAN: left out */
	struct sinumerik_text argument_texts[SINUMERIK_ARGUMENTS_MAX];
	bool argument_is_text[SINUMERIK_ARGUMENTS_MAX];
	int argument_variable[SINUMERIK_ARGUMENTS_MAX];	/* the caller's variable that stands alone as argument, or -1 */
	bool compares, joins;	/* the current expression has a comparison; AND, OR or XOR */
	struct sinumerik_jump jumps[SINUMERIK_JUMPS];
	struct sinumerik_modal modal;
	struct sinumerik_pattern pattern;
	struct sinumerik_contour contour;
	struct sinumerik_frame frame;	/* TRANS, ROT, SCALE, MIRROR */
	struct sinumerik_frame swivel;	/* CYCLE800: under the programmable one */
	bool swivelled;
	bool tool_frame;	/* TOROT: `swivel` has the tool as its Z; its X and Y are not known */
	bool tool_upright;	/* while CYCLE800 has swivelled: the tool is parallel to the machine's Z */
	bool frame_is_even;	/* the frames scale all directions equally */
	/* Program coordinates of the position, mm and degrees; derived from the position while `placed` is false. */
	slot_values place;
	bool placed;
	/* An offset has changed since the axis was programmed last: its program coordinate then. */
	bool shifted[SLOT_COUNT];
	slot_values programmed;	/* NAN: not known */
	struct sinumerik_tangent tangent;
	struct sinumerik_macro *macros;	/* owned */
	size_t macro_count, macro_capacity;
	bool work_selected;	/* by the program: G500, G54 ... */
	bool frames_unsure;	/* TRAORI or TRAFOOF may have deleted the frames */
	bool frame_unsure;	/* CYCLE800() may have deleted the programmable frame */
	bool plane_unsure;	/* another work offset was selected while CYCLE800 has swivelled */
	bool cautioned_rotary_way;	/* the warning about the assumed shorter way of a modulo axis was given */
	bool edge_unsure;	/* since M6: a parameter decides whether D1 is active */
	bool t_waits;	/* T was read without an M6 since: a parameter decides whether T changes the tool */
	bool tool_changed;	/* by M6 */
	bool changes_ahead;	/* the program has an M6 after its first T */
	const struct source *no_change_ahead;	/* the last file without an M6 after T; NULL: none */
	int edge;	/* D */
	struct sinumerik_text *names;	/* of tools, without a setup; owned */
	size_t name_count, name_capacity;
	enum sinumerik_orientation orientation;
	int orientation_angles;	/* ORIEULER, ORIRPY, ORIRPY2; 0: none was given */
	bool machine_orientation;	/* ORIMKS */
	int master;	/* the number of the spindle that S and M3 mean, less 1 */
	double feed_scale;	/* mm per unit of F, and of lengths in variables of the control */
	double rounding, rapid_rounding;	/* mm: ADIS and ADISPOS, for G641 */
	double rapid_factor;	/* STOLF; 0: none was given */
	double orientation_tolerance;	/* degrees: OTOL or that of CYCLE832; 0: not known */
	int path_code;	/* G60, G64, G641 ... */
	double smoothing;	/* mm: the tolerance of CYCLE832 or CTOL; 0: not known */
	bool smooths_orientation;	/* ORISON */
	bool compresses;	/* COMPCAD and its like */
	struct sinumerik_polar polar;
	int approach;	/* NORM, KONT, or CODE_NONE: a parameter says */
	int corner;	/* G450, G451, or CODE_NONE */
	double disc;	/* DISC: 0 is a circle */
	double allowance;	/* mm: OFFN */
	bool turns_plane;	/* CUT2DF */
	bool left_open;	/* after a milling cycle the tool is somewhere above its region */
	struct parallel_box open;	/* then: this box about the position; cutter_comp.loose is its extent */
	bool begun;	/* the first line has been read */
	bool headed;	/* its head or its first block has been read */
	struct strbuf line;	/* the text of the current line while the file is searched */
};

static inline struct sinumerik *sinumerik_of(const struct interp *interp)
{
	return interp->dialect_state;
}

/* The innermost active call, or NULL. */
static inline struct sinumerik_call *sinumerik_top_call(struct sinumerik *sinumerik)
{
	return sinumerik->depth ? &sinumerik->calls[sinumerik->depth - 1] : NULL;
}

/* Is the modal call carried out after motions now? */
static inline bool sinumerik_modal_acts(const struct sinumerik *sinumerik)
{
	return sinumerik->modal.on && !(sinumerik->modal.running && sinumerik->depth > sinumerik->modal.depth);
}

/* An upper-case letter; other bytes stay as they are. */
static inline char sinumerik_upper(char byte)
{
	return byte >= 'a' && byte <= 'z' ? (char)(byte - 'a' + 'A') : byte;
}

static inline bool sinumerik_is_digit(char byte)
{
	return byte >= '0' && byte <= '9';
}

/* Letters and '_': what a name starts with. */
static inline bool sinumerik_is_letter(char byte)
{
	return (byte >= 'a' && byte <= 'z') || (byte >= 'A' && byte <= 'Z') || byte == '_';
}

static inline bool sinumerik_is_name(char byte)
{
	return sinumerik_is_letter(byte) || sinumerik_is_digit(byte);
}

#endif
