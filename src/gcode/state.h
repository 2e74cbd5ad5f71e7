/* state.h - what the interpreter remembers between blocks: modes, offsets, where the axes are. */
#ifndef FIVECHECK_GCODE_STATE_H
#define FIVECHECK_GCODE_STATE_H

#include <stdbool.h>

#include "base/call_chain.h"
#include "base/units.h"
#include "gcode/canon.h"
#include "gcode/config.h"
#include "gcode/execute/cutter_comp/comp_corner.h"
#include "gcode/execute/cutter_comp/comp_queue.h"
#include "gcode/execute/tool_table.h"
#include "gcode/kinematics.h"
#include "gcode/program.h"
#include "gcode/text/block.h"
#include "gcode/text/fault.h"
#include "geom/xform.h"

/* G54 to G59.3 */
#define SYSTEM_COUNT 9
/* G54.1 P1 to P300 (Fanuc), G154 P1 to P99, of which G110 to G129 are the first (Haas); they follow G59.3 */
#define EXTENDED_COUNT 300

/* G505 to G599 (Sinumerik) follow those, and then comes the work offset that is none (G500). */
#define SETTABLE_COUNT 95
#define SYSTEM_SETTABLE (SYSTEM_COUNT + EXTENDED_COUNT)
#define SYSTEM_NONE (SYSTEM_SETTABLE + SETTABLE_COUNT)
#define SYSTEMS_ALL (SYSTEM_NONE + 1)

/* One value a slot, in mm and degrees: the units of programs, so that no conversion makes a position drift. */
typedef struct slot_values {
	double v[SLOT_COUNT];
} slot_values;

/* The tool change, where a G-code stands that may have taken the length back. */
#define DOUBT_M6 (-2)

enum feed_mode { FEED_PER_MINUTE, FEED_PER_REVOLUTION, FEED_INVERSE_TIME };

enum tcp_source { TCP_OFF, TCP_BY_LENGTH, TCP_BY_MCODE, TCP_BY_PLANE };	/* G43.4, a machine's own M-code, G53.1 */

enum spindle_turn { SPINDLE_STOPPED, SPINDLE_CLOCKWISE, SPINDLE_COUNTERCLOCKWISE };

/* A coordinate system turned by the program: execute/rotated_frame.h. */
struct rotated_frame {
	bool on;
	bool waits_for_tool;	/* G68.2 before its G53.1: where the control would move is not known here */
	mat3 turn;
	bool distorts;	/* the turn mirrors or scales, too, and then: */
	mat3 back;	/* its inverse */
	double growth;	/* by which it lengthens at most */
	bool scales;	/* by G51 */
	int conversions;	/* G68 with I, J and K: how many there were */
	bool turns_length;	/* with these: the tool's length acts along the turned Z */
	bool mirrors;	/* left becomes right */
	vec3 origin;	/* mm, from the offsets in force */
};

/* G68.2 P2 and P3, which take several blocks: execute/tilted_plane.h. */
struct plane_parts {
	int form;	/* 2 or 3: its blocks have begun; 0: none */
	int next;	/* the Q that comes next */
	vec3 point[4];	/* by Q, mm */
	vec3 direction[2];	/* of X and of Z */
	bool has_turn;
	double turn;	/* degrees, about the new Z */
};

/* The work zero carried along with the table: execute/dynamic_work_offset.h. */
struct dynamic_work_offset {
	bool on;
	slot_values zero;	/* X, Y and Z, in place of the work offset's */
	int unsure_code;	/* G254 or G255, or CODE_NONE: nothing is unsure */
	bool unsure[SLOT_COUNT];	/* its offset has changed and no absolute coordinate led the axis on since */
};

/* G7.1: execute/cylinder.h. */
struct cylinder {
	bool on;
	int slot;	/* the rotary axis whose angle is a way along the surface */
	double radius;	/* mm */
};

/* G12.1: execute/polar_interpolation.h. */
struct polar_interpolation {
	bool on;
	int rotary;	/* slot of the axis that turns to the point's angle; X goes to its distance */
	double zero[2];	/* mm: where the centre of the plane lies in positions of X and Y */
	double side;	/* -1: X stands on its negative side */
	double at[2];	/* mm, about the centre: the end of the last move that was told, and */
	axis_values told;	/* where the axes stand there */
	double angle;	/* radians: of the rotary axis there */
	double y;	/* what is back in force with G13.1: the position of Y, */
	int plane;	/* the plane */
	unsigned unknown_plane;	/* and whether it is known */
};

/* G150: execute/pocket_milling.h. Positions of axes, mm. */
struct pocket_milling {
	bool takes;	/* the outline is being read, and then: */
	slot_values here;	/* where the tool stands meanwhile */
	double hole[2];	/* where it begins, X and Y */
	double top, bottom;	/* of Z */
	struct canon_feed feed;
	int side;	/* 1: G41, -1: G42, 0: none */
	double beyond;	/* how far the tool may be outside of the outline */
	int points;	/* of the outline so far */
	double first[2], last[2], low[2], high[2];
	double area;	/* inside, counter-clockwise */
	/* behind it */
	bool compensated;	/* G40 has not come yet */
	bool open[3];	/* no absolute coordinate has led the axis out of the pocket */
};

/* G16: execute/polar_coordinates.h. */
struct polar_coordinates {
	bool on, has_radius, has_angle;
	double radius, angle;	/* of the last point, mm and degrees */
};

/* What canned cycles remember from block to block: the bare numbers, in the units of the block that gave them. */
struct cycle_memory {
	uint32_t known;	/* letter bits */
	double word[26];	/* Z is the depth, whatever the plane */
	uint32_t increments;	/* letter bits of R and Z: they were given in G91 */
	bool has_level;
	double level;	/* program coordinate of the drilling axis before the first cycle */
	double height;	/* its straight position there, mm */
	double scale;	/* mm per unit of length there */
	bool turned;	/* coordinates were turned since, or turned back */
};

struct state {
	slot_values position;	/* of the controller's axes, as canon.h has it */
	axis_values canonical;	/* the same in mm and radians */
	slot_values offset;	/* program coordinates + offset = position; derived */
	struct canon_origin origin;	/* what the offset is made of; derived, but for its length */
	int motion;	/* of the motion in force, or CODE_NONE */
	int path_motion;	/* G0 to G3, whichever was commanded last, or CODE_NONE */
	/* Bits 1 << enum g_group: neither the program nor its dialect has said what is in force. */
	unsigned unknown_modes;
	int plane;	/* G17, G18, G19 */
	bool incremental;
	bool arc_absolute;
	double scale;	/* mm per unit of length */
	enum feed_mode feed_mode;
	double feed_linear;	/* mm per minute or revolution; 0: none given */
	double feed_angular;	/* degrees per minute or revolution */
	double speed;	/* revolutions per minute */
	/* by S0: the spindle stands after M3, too. Without any S the control has a speed of its own */
	bool speed_is_zero;
	bool speed_missed;	/* M3 or M4 came before any S, which was said */
	enum spindle_turn spindle;
	int retract;	/* G98 or G99, or CODE_NONE: not said yet */
	struct cycle_memory cycle;
	struct rotated_frame frame;
	struct plane_parts plane_parts;
	struct polar_coordinates polar;
	struct polar_interpolation polar_interpolation;
	struct pocket_milling pocket_milling;
	struct cylinder cylinder;
	struct dynamic_work_offset dynamic;
	/* G68, or the code that took a frame back, which made coordinates unsure; or CODE_NONE */
	int unsure_code;
	bool unsure[SLOT_COUNT];	/* what the control takes the coordinate for: execute/coordinate_rotation.h */
	int system;	/* 0 is G54 */
	slot_values work[SYSTEMS_ALL];
	bool work_assigned;	/* the program assigned a value to the one in force, and has not selected it since */
	bool work_known[SYSTEMS_ALL];	/* by the setup or by G10; or else it was said that it is 0 */
	slot_values shift;	/* of G52 and G92 */
	slot_values saved_shift;	/* that G92.3 restores */
	bool shift_applied;	/* no G92.1 or G92.2 has taken it back */
	int shift_code;	/* G52 or G92, whichever made the shift */
	double length;	/* mm: length compensation in force */
	int length_code;	/* G43, G43.4 or G234 in force, or G49 */
	int length_doubt;	/* G28, G30, G53 or DOUBT_M6: what may have taken the length back, or CODE_NONE */
	bool length_moves;	/* in this block the change of length moves axes by length_shift */
	slot_values length_shift;	/* of X, Y and Z, in program coordinates */
	enum tcp_source tcp;
	axis_values rotary_zero;	/* as the sink was told last */
	slot_values reference[2];	/* machine positions of G28 and G30 */
	bool probed[SLOT_COUNT];	/* a probe stopped the axis somewhere, and no coordinate led it on since */
	bool probe_bounded[SLOT_COUNT];	/* and between which positions is known: execute/probed_axes.h */
	slot_values probe_low, probe_high;
	bool settles[SLOT_COUNT];	/* the block gives the axis an absolute coordinate */
	bool own_frame;	/* a frame that only the dialect knows lies between programmed coordinates and offsets */
	int tool;	/* in the spindle */
	bool tool_by_m61;	/* M61 has said that it is there */
	int selected;	/* by T, or -1 */
	int selected_next;	/* by the T of a block whose M6 loads another, or -1 */
	int length_number;	/* the H that was given last, or -1 */
	bool blend;
	double blend_tolerance;
	double blend_turn;	/* as in canon_move */
	bool blend_before;	/* and what G5.1 Q0, G8 P0 restore */
	bool contour;	/* G5.1 Q1, G8 P1 */
};

/* Cutter compensation: execute/cutter_comp/cutter_comp.h. */
struct cutter_comp {
	int side;	/* 1: left of the path (G41), -1: right of it (G42), 0: off */
	double radius;	/* mm */
	bool entered;	/* the entry move has been programmed */
	bool arc_refused;	/* after G40 the next move must be straight */
	struct plane_point current;	/* where the last move ends if no inside corner follows */
	struct comp_queue queue;
	/* Of controls that look ahead: cutter_comp/comp_lookahead.h. */
	bool looks_ahead;
	enum comp_start start_type;	/* while it is on */
	enum comp_corner_form corner_form;
	int number;	/* the D that was given last, or -1 */
	bool starting, leaving;	/* the first move waits; the block has G40 and moves out */
	struct comp_way waiting;	/* the programmed way of the move that waits */
	struct plane_point ahead;	/* its direction at its end, a unit */
	double across, idle_across;	/* mm: how far it moves across the plane, and the blocks behind it */
	int idle_blocks;	/* behind it, without a move in the plane */
	bool moved;	/* this block has moved in the plane */
	double loose[3];	/* mm, X Y Z: after G40 without a move, how far aside an axis may still be */
	bool keeps_loose;	/* the dialect itself takes `loose` back, not the words of each block */
};

/* ",C" and ",R": execute/corner_insert.h. */
struct pending_corner {
	bool on;	/* a block waits */
	bool fresh;	/* it is the one in hand */
	char letter;	/* 'C', 'L' or 'R' */
	double size;	/* mm */
	struct block block;
	struct line_place at;
	char *text;	/* of the line; owned */
	struct call_chain callers;
	struct canon_move move;	/* its kind and feed */
	slot_values start;	/* straight */
	struct comp_way way;
};

/* Splines: execute/spline_move.h. Lengths in mm. */
struct spline_memory {
	bool goes_on;	/* the last motion was a G5, which ended with P and Q */
	double p, q;
	bool open;	/* G5.2 or G6.2 has begun, and collects */
	int order;
	size_t count;
	struct spline_point *points;	/* owned */
	bool nurbs;	/* by G6.2, execute/nurbs_move.h, and then: */
	uint32_t axes;	/* letter bits: those of its points */
	size_t knot_count;
	double *knots;	/* owned */
};

struct interp {
	const struct gcode_config *config;
	const struct kinematics *kinematics;
	const struct canon_sink *sink;
	struct diag *diag;
	struct program program;
	void *dialect_state;	/* what the dialect's hooks remember; NULL: nothing */
	struct line_place at;	/* the block being carried out */
	struct call_chain callers;	/* of that block */
	struct block block;
	struct state state;
	struct tool_table tools;
	struct cutter_comp comp;
	struct pending_corner corner;
	struct spline_memory spline;
	struct block_cautions cautions;
	bool cautioned_feed, cautioned_order, cautioned_t;
	bool cautioned_retract, cautioned_by_hand, cautioned_probe, cautioned_no_shift, cautioned_line, cautioned_wear,
	     cautioned_common;
	bool percent;	/* the program is enclosed in '%' lines */
	bool begun;	/* a block has been read */
	bool ended;
	long furthest;	/* line of the main program that was carried out */
	bool faulty;	/* a fault was reported, and the program is read on to report the others */
	uint32_t lost;	/* bits of the axes whose position is not known since then (read_on.h) */
	int moves;	/* of the block so far */
};

static inline const struct dialect_traits *traits_of(const struct interp *interp)
{
	return &interp->config->dialect->traits;
}

/* Is this answer of the control known? False: reported at the column; dialect_answers says how. */
static inline bool is_answered(const struct interp *interp, int column, int answer, const char *question)
{
	return answer || dialect_answers(interp->config->dialect, &interp->at, column, answer, question);
}

/* At the start of a program: the modes that the dialect has at power-on; the axes at home. */
void state_init(struct state *state, const struct gcode_config *config);

/* What G93 to G95 switch to, and mm per unit of length of G20 and G21. */
enum feed_mode state_feed_mode(int code);
double state_unit(int code);

/* The motion that G80 leaves in force, or CODE_NONE. */
int state_motion_after_g80(const struct state *state, const struct dialect_traits *traits);

/* Recomputes state->offset after a change of anything that it is made of. */
void state_update_offset(struct state *state);

/* Puts an axis elsewhere. */
static inline void state_set_position(struct state *state, int slot, double value)
{
	state->position.v[slot] = value;
	state->canonical.v[slot] = slot_is_rotary(slot) ? radians(value) : value;
}

/*
 * "G54" for 0 ... "G59.3" for 8, "G54.1 P1" for 9 and on, "G505" and on for SYSTEM_SETTABLE and on, "G500" at the
 * end.
 */
const char *state_system_name(int system);

/* Degrees (or mm) of a value of the configuration: the short decimal that its file had, where there is one. */
double state_from_canonical(int slot, double value);

#endif
