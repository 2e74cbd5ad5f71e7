/* state.h - the interpreter's state between blocks: modes, offsets, positions of the axes. */
#ifndef FIVECHECK_GCODE_STATE_H
#define FIVECHECK_GCODE_STATE_H

#include <stdbool.h>

#include "base/call_chain.h"
#include "base/same_double.h"
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
/* after G59.3: G54.1 P1 to P300 (Fanuc); G154 P1 to P99, the first of which are also G110 to G129 (Haas) */
#define EXTENDED_COUNT 300

/* G505 to G599 (Sinumerik) are next; the last one is G500, no work offset. */
#define SETTABLE_COUNT 95
#define SYSTEM_SETTABLE (SYSTEM_COUNT + EXTENDED_COUNT)
#define SYSTEM_NONE (SYSTEM_SETTABLE + SETTABLE_COUNT)
#define SYSTEMS_ALL (SYSTEM_NONE + 1)

/* One value for each slot, in mm and degrees: the units of programs, so that positions do not drift by conversion. */
typedef struct slot_values {
	double v[SLOT_COUNT];
} slot_values;

/* See same_double: exactly equal. */
static inline bool slot_values_same(const slot_values *a, const slot_values *b)
{
	for (int slot = 0; slot < SLOT_COUNT; slot++) {
		if (!same_double(a->v[slot], b->v[slot]))
			return false;
	}
	return true;
}

/* X, Y and Z. */
static inline vec3 slot_values_linear(const slot_values *values)
{
	return (vec3){values->v[SLOT_X], values->v[SLOT_Y], values->v[SLOT_Z]};
}

static inline void slot_values_set_linear(slot_values *values, vec3 point)
{
	values->v[SLOT_X] = point.x;
	values->v[SLOT_Y] = point.y;
	values->v[SLOT_Z] = point.z;
}

/* The tool change, as a value of length_doubt. */
#define DOUBT_M6 (-2)

enum feed_mode { FEED_PER_MINUTE, FEED_PER_REVOLUTION, FEED_INVERSE_TIME };

enum tcp_source { TCP_OFF, TCP_BY_LENGTH, TCP_BY_MCODE, TCP_BY_PLANE };	/* G43.4, a machine's own M-code, G53.1 */

enum spindle_turn { SPINDLE_STOPPED, SPINDLE_CLOCKWISE, SPINDLE_COUNTERCLOCKWISE };

/* A coordinate system turned by the program: execute/rotated_frame.h. */
struct rotated_frame {
	bool on;
	bool waits_for_tool;	/* G68.2 before its G53.1: the control's motion is not known in between */
	mat3 turn;
	bool distorts;	/* `turn` also mirrors or scales; then: */
	mat3 back;	/* the inverse of `turn` */
	double growth;	/* the greatest scale factor of a length */
	bool scales;	/* by G51 */
	int conversions;	/* the number of G68 with I, J and K */
	bool turns_length;	/* with these: the tool's length acts along the turned Z */
	bool mirrors;	/* left becomes right */
	vec3 origin;	/* mm, relative to the active offsets */
};

/* G68.2 P2 and P3, which take several blocks: execute/tilted_plane.h. */
struct plane_parts {
	int form;	/* 2 or 3: some of its blocks have been read; 0: none */
	int next;	/* the expected Q of the next block */
	vec3 point[4];	/* by Q, mm */
	vec3 direction[2];	/* of X and of Z */
	bool has_turn;
	double turn;	/* degrees, about the new Z */
};

/* The work zero that moves with the table: execute/dynamic_work_offset.h. */
struct dynamic_work_offset {
	bool on;
	slot_values zero;	/* X, Y and Z, instead of the work offset's */
	int unsure_code;	/* G254 or G255, or CODE_NONE: nothing is unsure */
	bool unsure[SLOT_COUNT];	/* the offset has changed, and no absolute coordinate moved the axis since */
};

/* G7.1: execute/cylinder.h. */
struct cylinder {
	bool on;
	int slot;	/* the rotary axis whose angle is a distance along the surface */
	double radius;	/* mm */
};

/* G12.1: execute/polar_interpolation.h. */
struct polar_interpolation {
	bool on;
	int rotary;	/* slot of the axis that turns to the point's angle; X moves to the point's distance */
	double zero[2];	/* mm: the centre of the plane, in positions of X and Y */
	double side;	/* -1: X is on its negative side */
	double at[2];	/* mm, relative to the centre: the end of the last move sent to the sink */
	axis_values told;	/* the positions of the axes at that end */
	double angle;	/* radians: of the rotary axis at that end */
	double y;	/* G13.1 restores: the position of Y, */
	int plane;	/* the plane, */
	unsigned unknown_plane;	/* and whether the plane is known */
};

/* G150: execute/pocket_milling.h. Positions of axes, mm. */
struct pocket_milling {
	bool takes;	/* the outline is being read; then: */
	slot_values here;	/* the position of the tool meanwhile */
	double hole[2];	/* the start, X and Y */
	double top, bottom;	/* of Z */
	struct canon_feed feed;
	int side;	/* 1: G41, -1: G42, 0: none */
	double beyond;	/* how far the tool may be outside of the outline */
	int points;	/* of the outline so far */
	double first[2], last[2], low[2], high[2];
	double area;	/* inside, counter-clockwise */
	/* after the pocket */
	bool compensated;	/* G40 was not read yet */
	bool open[3];	/* no absolute coordinate has moved the axis out of the pocket */
};

/* G16: execute/polar_coordinates.h. */
struct polar_coordinates {
	bool on, has_radius, has_angle;
	double radius, angle;	/* of the last point, mm and degrees */
};

/* The words that canned cycles keep from block to block: the numbers in the units of their block. */
struct cycle_memory {
	uint32_t known;	/* letter bits */
	double word[26];	/* Z is the depth in every plane */
	uint32_t increments;	/* letter bits of R and Z: they were given in G91 */
	bool has_level;
	double level;	/* initial level: program coordinate of the drilling axis before the first cycle */
	double height;	/* straight position (execute/rotated_frame.h) at the initial level, mm */
	double scale;	/* mm per unit of length at that time */
	bool turned;	/* a coordinate rotation was switched on or off since */
};

struct state {
	slot_values position;	/* of the controller's axes, as defined in canon.h */
	axis_values canonical;	/* the same in mm and radians */
	slot_values offset;	/* program coordinates + offset = position; derived */
	struct canon_origin origin;	/* the parts of the offset; derived, except the length */
	int motion;	/* the active motion code, or CODE_NONE */
	int path_motion;	/* the last G0 to G3, or CODE_NONE */
	/* Bits 1 << enum g_group: neither the program nor its dialect determines the active code of the group. */
	unsigned unknown_modes;
	int plane;	/* G17, G18, G19 */
	bool incremental;
	bool arc_absolute;
	double scale;	/* mm per unit of length */
	enum feed_mode feed_mode;
	double feed_linear;	/* mm per minute or revolution; 0: none given */
	double feed_angular;	/* degrees per minute or revolution */
	double speed;	/* revolutions per minute */
	/* by S0: the spindle does not turn after M3 either. Without any S the control uses its own speed */
	bool speed_is_zero;
	bool speed_missed;	/* the warning that M3 or M4 came before any S was given */
	enum spindle_turn spindle;
	int retract;	/* G98 or G99, or CODE_NONE: none was read yet */
	struct cycle_memory cycle;
	struct rotated_frame frame;
	struct plane_parts plane_parts;
	struct polar_coordinates polar;
	struct polar_interpolation polar_interpolation;
	struct pocket_milling pocket_milling;
	struct cylinder cylinder;
	struct dynamic_work_offset dynamic;
	/* G68, or the code that cancelled a frame, if it made coordinates unsure; or CODE_NONE */
	int unsure_code;
	bool unsure[SLOT_COUNT];	/* the control's value of the coordinate: execute/coordinate_rotation.h */
	int system;	/* the active work offset; 0 is G54 */
	slot_values work[SYSTEMS_ALL];
	bool work_assigned;	/* the program assigned to the active offset and has not selected it since */
	bool work_known[SYSTEMS_ALL];	/* by the setup or by G10; or a warning has said that it counts as 0 */
	slot_values shift;	/* of G52 and G92 */
	slot_values saved_shift;	/* that G92.3 restores */
	bool shift_applied;	/* no G92.1 or G92.2 has cancelled the shift */
	int shift_code;	/* G52 or G92, the code that set the shift */
	double length;	/* mm: the active length compensation */
	int length_code;	/* the active code: G43, G43.4, G234 or G49 */
	int length_doubt;	/* G28, G30, G53 or DOUBT_M6, which may have cancelled the length, or CODE_NONE */
	bool length_moves;	/* in this block the change of length moves axes by length_shift */
	slot_values length_shift;	/* of X, Y and Z, in program coordinates */
	enum tcp_source tcp;
	axis_values rotary_zero;	/* as last given to the kinematics */
	slot_values reference[2];	/* machine positions of G28 and G30 */
	bool probed[SLOT_COUNT];	/* a probe stopped the axis, and no absolute coordinate moved it since */
	bool probe_bounded[SLOT_COUNT];	/* the interval of its position is known: execute/probed_axes.h */
	slot_values probe_low, probe_high;
	bool settles[SLOT_COUNT];	/* the block gives the axis an absolute coordinate */
	bool own_frame;	/* a frame of the dialect's own is between programmed coordinates and offsets */
	int tool;	/* in the spindle */
	bool tool_by_m61;	/* M61 has set the tool */
	int selected;	/* by T, or -1 */
	int selected_next;	/* by the T of a block whose M6 loads another tool, or -1 */
	int length_number;	/* the last H, or -1 */
	bool blend;
	double blend_tolerance;
	double blend_turn;	/* as in canon_move */
	bool blend_before;	/* the mode that G5.1 Q0 and G8 P0 restore */
	bool contour;	/* G5.1 Q1, G8 P1 */
};

/* Cutter compensation: execute/cutter_comp/cutter_comp.h. */
struct cutter_comp {
	int side;	/* 1: left of the path (G41), -1: right of it (G42), 0: off */
	double radius;	/* mm */
	bool entered;	/* the entry move has been programmed */
	bool arc_refused;	/* after G40 the next move must be straight */
	struct plane_point current;	/* the end of the last move if no inside corner follows */
	struct comp_queue queue;
	/* For controls that look ahead: cutter_comp/comp_lookahead.h. */
	bool looks_ahead;
	enum comp_start start_type;	/* while compensation is on */
	enum comp_corner_form corner_form;
	int number;	/* the last D, or -1 */
	bool starting, leaving;	/* the first move waits; the block has G40 and moves out */
	struct comp_way waiting;	/* the programmed path of the move that waits */
	struct plane_point ahead;	/* unit vector: the direction of `waiting` at its end */
	double across, idle_across;	/* mm perpendicular to the plane: of `waiting`, and of idle blocks after it */
	int idle_blocks;	/* after `waiting`, without a move in the plane */
	bool moved;	/* this block has moved in the plane, or it is a call, which does not count */
	double loose[3];	/* mm, X Y Z: after G40 without a move, how far aside an axis may still be */
	bool keeps_loose;	/* the dialect resets `loose`; the words of a block do not */
};

/* ",C" and ",R": execute/corner_insert.h. */
struct pending_corner {
	bool on;	/* a block waits */
	bool fresh;	/* it is the current block */
	char letter;	/* 'C', 'L' or 'R' */
	double size;	/* mm */
	struct block block;
	struct line_place at;
	char *text;	/* of the line; owned */
	struct call_chain callers;
	struct canon_move move;	/* only its kind and feed */
	slot_values start;	/* straight position */
	struct comp_way way;
};

/* Splines: execute/spline_move.h. Lengths in mm. */
struct spline_memory {
	bool goes_on;	/* the last motion was a G5, which ended with P and Q */
	double p, q;
	bool open;	/* points of a G5.2 or G6.2 are being collected */
	int order;
	size_t count;
	struct spline_point *points;	/* owned */
	bool nurbs;	/* by G6.2, execute/nurbs_move.h; then: */
	uint32_t axes;	/* letter bits: the axes of its points */
	size_t knot_count;
	double *knots;	/* owned */
};

/* G2.4 and G3.4: execute/space_arc.h. */
struct space_arc {
	bool on;	/* the point is known, and the next block gives the end */
	slot_values through;	/* straight position */
};

struct interp {
	const struct gcode_config *config;
	const struct kinematics *kinematics;
	const struct canon_sink *sink;
	struct diag *diag;
	struct program program;
	void *dialect_state;	/* the data of the dialect's hooks; or NULL */
	struct line_place at;	/* the block that is being carried out */
	struct call_chain callers;	/* of that block */
	struct block block;
	struct state state;
	struct tool_table tools;
	struct cutter_comp comp;
	struct pending_corner corner;
	struct spline_memory spline;
	struct space_arc space_arc;
	struct block_cautions cautions;
	bool cautioned_feed, cautioned_speed, cautioned_order, cautioned_t;
	bool cautioned_retract, cautioned_by_hand, cautioned_probe, cautioned_no_shift, cautioned_line, cautioned_wear,
	     cautioned_common;
	long percent;	/* the line of the '%' that opens the program; 0: none does */
	bool begun;	/* a block has been read */
	bool ended;
	long furthest;	/* the last line of the main program that was carried out */
	bool faulty;	/* a fault was reported, and the program is read on to report further faults */
	uint32_t lost;	/* bits of the axes whose position is not known since that fault (read_on.h) */
	int moves;	/* of the block so far */
};

static inline const struct dialect_traits *traits_of(const struct interp *interp)
{
	return &interp->config->dialect->traits;
}

/* Is this answer of the control known? False: reported at the column, see dialect_answers. */
static inline bool is_answered(const struct interp *interp, int column, int answer, const char *question)
{
	return answer || dialect_answers(interp->config->dialect, &interp->at, column, answer, question);
}

/* The state at the start of a program: the dialect's modes at power-on; the axes at home. */
void state_init(struct state *state, const struct gcode_config *config);

/* The mode of G93 to G95, and the mm per unit of length of G20 and G21. */
enum feed_mode state_feed_mode(int code);
double state_unit(int code);

/* The motion that is active after G80, or CODE_NONE. */
int state_motion_after_g80(const struct state *state, const struct dialect_traits *traits);

/* Recomputes state->offset after a change of any of its parts. */
void state_update_offset(struct state *state);

/* Sets the position of an axis. */
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

/* Degrees (or mm) of a value of the configuration: the short decimal number of its file, if there is one. */
double state_from_canonical(int slot, double value);

#endif
