/* controller.h - the properties of a machine's control: its dialect, its parameters, the positions that it moves to. */
#ifndef FIVECHECK_CONTROL_CONTROLLER_H
#define FIVECHECK_CONTROL_CONTROLLER_H

#include <stdbool.h>
#include <stddef.h>

#include "base/axes.h"
#include "base/diag.h"

/* Lengths in mm, angles in radians. */

/* The path of a rapid: a straight line, each axis at its own rate, or unknown. */
enum rapid { RAPID_LINEAR, RAPID_DOGLEG, RAPID_ANY };

/*
 * How a rotary axis moves to an absolute position: as a plain number; modulo a turn, the shorter way; modulo a turn, in
 * the direction of the target's sign.
 */
enum wrap { WRAP_NONE, WRAP_SHORTEST, WRAP_SIGN };

/* The answer to a question that only the machine builder or a parameter of the control can answer. */
enum answer { ANSWER_UNKNOWN, ANSWER_YES, ANSWER_NO };

/* G53 while G91 is active: its words are absolute, or G53 is ignored and they are increments. */
enum g53_with_g91 { G53_WITH_G91_UNKNOWN, G53_WITH_G91_ABSOLUTE, G53_WITH_G91_INCREMENTAL };

/* What G28, G30, G53 and the tool change position do to the length compensation of the axes that they have moved. */
enum length_after_reference {
	LENGTH_AFTER_REFERENCE_UNKNOWN,
	LENGTH_AFTER_REFERENCE_KEPT,
	LENGTH_AFTER_REFERENCE_GONE
};

/* While G68 with I, J and K is active the tool length acts along the rotated Z, or along Z of the machine. */
enum length_under_g68 { LENGTH_UNDER_G68_UNKNOWN, LENGTH_UNDER_G68_TURNED, LENGTH_UNDER_G68_STRAIGHT };

/* M6 in a block that moves axes: the tool is changed after the move, or before it. */
enum m6_with_move { M6_WITH_MOVE_UNKNOWN, M6_AFTER_MOVE, M6_BEFORE_MOVE };

/*
 * A block has T and M6, and the T of an earlier block still waits: M6 loads the T of its own block, or the earlier one.
 * The other T is then selected.
 */
enum m6_with_t { M6_WITH_T_UNKNOWN, M6_LOADS_OWN_T, M6_LOADS_T_BEFORE, M6_LOADS_FIRST_T };

/* The meaning of ';' in a line, and of ':' with a number at its start. */
enum semicolon { SEMICOLON_UNKNOWN, SEMICOLON_STARTS_COMMENT, SEMICOLON_ENDS_BLOCK };
enum colon { COLON_UNKNOWN, COLON_PROGRAM, COLON_BLOCK };

/*
 * Cutter compensation: the paths of the first and the last block, and the path round an outside corner. Not known:
 * every possible path is proved.
 */
enum comp_d { COMP_D_UNKNOWN, COMP_D_RADIUS, COMP_D_DIAMETER };	/* the contents of D registers */
enum comp_start { COMP_START_UNKNOWN, COMP_START_A, COMP_START_B };
enum comp_corner_form {
	COMP_CORNER_UNKNOWN,
	COMP_CORNER_LINEAR,
	COMP_CORNER_CIRCULAR,
	COMP_CORNER_CROSSING,	/* both paths are extended to their crossing, however sharp the corner is */
	COMP_CORNER_CROSSING_IF_BLUNT,	/* at the crossing; if sharper than a right angle, there or on a circle */
	COMP_CORNER_BETWEEN	/* anywhere between the crossing and a circle */
};

/* The order in which several angles of one block rotate the coordinates. */
enum rotation_order { ROTATION_ORDER_UNKNOWN, ROTATION_ORDER_RPY, ROTATION_ORDER_EULER };

/*
 * How guided rotary axes turn the tool if the program does not say it: evenly, or its direction on a great circle. Or
 * the coordinates of the orientation alone decide: on a great circle in the workpiece (ORIWKS), evenly in the machine.
 */
enum orientation_interpolation {
	ORIENTATION_INTERPOLATION_UNKNOWN,
	ORIENTATION_INTERPOLATION_AXES,
	ORIENTATION_INTERPOLATION_VECTOR,
	ORIENTATION_INTERPOLATION_ORIWKS
};

/* The edge of the tool after a tool change: the first, none, or the same number as before. */
enum edge_after_tool_change {
	EDGE_AFTER_TOOL_CHANGE_UNKNOWN,
	EDGE_AFTER_TOOL_CHANGE_FIRST,
	EDGE_AFTER_TOOL_CHANGE_NONE,
	EDGE_AFTER_TOOL_CHANGE_KEEPS
};

/* An increment after a change of offsets: it also traverses the change, or counts from the position of the axis. */
enum increments_after_shift { INCREMENTS_AFTER_SHIFT_UNKNOWN, INCREMENTS_TRAVERSE_SHIFT, INCREMENTS_FROM_POSITION };

/* A datum shift from before a tilted plane, after a shift of the same axis in the plane and the end of the plane. */
enum shift_behind_plane { SHIFT_BEHIND_PLANE_UNKNOWN, SHIFT_BEHIND_PLANE_KEEPS, SHIFT_BEHIND_PLANE_CANCELLED };

/* When MB of PLANE ... TURN retracts the tool: always, or only if a rotary axis has to turn. */
enum plane_retract { PLANE_RETRACT_UNKNOWN, PLANE_RETRACT_ALWAYS, PLANE_RETRACT_TURNING };

/*
 * What PLANE without COORD ROT and TABLE ROT rotates if a rotary axis is free: only the coordinates (TNC 640, TNC7), or
 * the table, as bit 6 of MP7500 says on iTNC 530.
 */
enum plane_rotation { PLANE_ROTATION_UNKNOWN, PLANE_ROTATION_COORDINATES, PLANE_ROTATION_TABLE };

/*
 * How a rotary axis whose display is reduced to 360 degrees moves without M126: by the difference of the two values, or
 * the shorter way (MP7682 bit 2, shortestDistance).
 */
enum rotary_way { ROTARY_WAY_UNKNOWN, ROTARY_WAY_PLAIN, ROTARY_WAY_SHORTER };

/* The meaning of an angle below 0, or of 360 and more, for an axis that moves the plain way. */
enum rotary_angle { ROTARY_ANGLE_UNKNOWN, ROTARY_ANGLE_AS_WRITTEN, ROTARY_ANGLE_REDUCED };

/* Whether M6 does anything: not if TOOL CALL alone changes the tool. */
enum m6_action { M6_UNKNOWN, M6_IGNORED };

/* Whether L and R of TOOL DEF count: not if a tool table is active. */
enum tool_def { TOOL_DEF_UNKNOWN, TOOL_DEF_IGNORED };

/* If a swivelled plane (CYCLE800, PLANE) leaves a rotary axis free, it moves to 0 or keeps its position. */
enum swivel_pole { SWIVEL_POLE_UNKNOWN, SWIVEL_POLE_ZERO, SWIVEL_POLE_STAYS };

/* A great circle of the tool that begins at a pole of the rotary axes, or passes near one: these axes turn evenly. */
enum orientation_pole { ORIENTATION_POLE_UNKNOWN, ORIENTATION_POLE_AXES };

/* The meaning of the angles of Heidenhain's cycle 19: spatial angles, or positions of the rotary axes. */
enum cycle_19_angles { CYCLE_19_ANGLES_UNKNOWN, CYCLE_19_ANGLES_SPATIAL, CYCLE_19_ANGLES_AXES };

/* The axes that Heidenhain's cycle 11 scales: those of the plane, or also the tool axis. */
enum cycle_11_axes { CYCLE_11_AXES_UNKNOWN, CYCLE_11_AXES_PLANE, CYCLE_11_AXES_ALL };

/* Modes of the control at power-on, if a parameter of the control decides them. */
enum power_on_units { POWER_ON_UNITS_UNKNOWN, POWER_ON_MM, POWER_ON_INCH };
enum power_on_distance { POWER_ON_DISTANCE_UNKNOWN, POWER_ON_ABSOLUTE, POWER_ON_INCREMENTAL };
enum power_on_plane { POWER_ON_PLANE_UNKNOWN, POWER_ON_XY, POWER_ON_ZX, POWER_ON_YZ };

enum power_on_motion { POWER_ON_MOTION_UNKNOWN, POWER_ON_RAPID, POWER_ON_FEED };

/* The axis that drills in planes other than that of G17: the one across the plane, or Z. */
enum cycle_axis { CYCLE_AXIS_UNKNOWN, CYCLE_AXIS_ACROSS, CYCLE_AXIS_Z };

/* The word that repeats a canned cycle on controls with a parameter for it. */
enum cycle_repeats { CYCLE_REPEATS_UNKNOWN, CYCLE_REPEATS_K, CYCLE_REPEATS_L };

/* The action of an M-code of the machine builder. */
enum mcode_action { MCODE_TCP_ON, MCODE_TCP_OFF, MCODE_IGNORE, MCODE_SPINDLE_ON, MCODE_SPINDLE_OFF };

struct mcode {
	int number;
	enum mcode_action action;
};

/*
 * The action of a program of the machine builder, such as O9810 of a probe: nothing; a straight move to the X, Y and Z
 * of its call; or moves around the place of its call, and back to it.
 */
enum macro_action { MACRO_NONE, MACRO_MOVE, MACRO_AROUND };

#define MACRO_OF_CODE (-1)

struct builder_macro {
	int program;	/* MACRO_OF_CODE: only its name or its code is known */
	double code;	/* the G-code that calls it; 0: none */
	enum macro_action action;
	double around[3];	/* mm along X, Y and Z, to both sides: MACRO_AROUND */
	const char *name;	/* upper case; NULL: it has none */
};

/* The sizes of an array. */
#define CONTROL_DIMENSIONS 3

enum control_type { CONTROL_REAL, CONTROL_INT, CONTROL_BOOL, CONTROL_CHAR, CONTROL_STRING, CONTROL_AXIS };

/*
 * A variable of the control that programs read: a parameter that keeps its value, a variable of the builder or a system
 * variable; with its value at the start of a program.
 */
struct control_variable {
	const char *name;	/* as control_variable_name_normalise leaves it */
	bool typed;	/* its type is given, which defines the variable */
	enum control_type type;
	int dimensions;	/* 0: one value */
	int size[CONTROL_DIMENSIONS];
	const char *text;	/* the value of each of its elements; NULL: not given */
	double number;	/* the value as a number, also of TRUE or FALSE; NAN: it is no number */
	struct srcloc at;	/* the place of its element; borrows the name of the file */
};

/* A position in machine coordinates to which the control moves axes by itself. */
struct control_place {
	bool given;
	bool has[SLOT_COUNT];	/* the position has a value for this axis */
	axis_values value;
	int order[SLOT_COUNT];	/* slots that move one after another; the other axes move last, together */
	size_t order_count;
};

/* Reference positions: G28, and G30 P2 to P4. */
#define REFERENCES_MAX 4

/* Plain data; the pointers are borrowed. All zero is a control about which nothing is known. */
struct controller {
	int dialect;	/* row of control/dialects.h */
	enum rapid rapid;
	bool tcp_zero_offset;	/* rotary zero under TCP: the work offset's rotary words, else the machine's zero */
	enum answer rapid_given;	/* ANSWER_YES: the machine file says how rapids move */
	enum answer tcp_zero_given;	/* ANSWER_YES: the machine file says which */
	double path_tolerance;	/* mm, and degrees for rotary axes; 0: none given */
	double unit;	/* mm per unit of length of the control itself, for parameters with offsets; 0: mm */
	/* mm or degrees of the value 1 without a decimal point; 1: whole units; 0: not known */
	double least_input;
	enum power_on_units power_on_units;
	enum power_on_distance power_on_distance;
	enum power_on_plane power_on_plane;
	enum power_on_motion power_on_motion;
	enum cycle_repeats cycle_repeats;
	enum cycle_axis cycle_axis;
	enum answer length_moves;	/* do axes move at once when the length compensation changes? */
	enum length_after_reference length_after_reference;
	enum length_under_g68 length_under_g68;
	int polar_axis;	/* the rotary slot that G12.1 uses with X; 0: not known */
	enum g53_with_g91 g53_with_g91;
	double overrun;	/* mm: how far G60 moves past its end; 0: not known */
	double arc_radius_tolerance;	/* mm: arcs with a smaller difference of radii are spirals; 0: not known */
	enum m6_with_move m6_with_move;
	enum m6_with_t m6_with_t;
	enum semicolon semicolon;
	enum colon colon;
	enum comp_d comp_d;
	enum comp_start comp_start;
	enum comp_corner_form comp_corner;
	int comp_idle_blocks;	/* blocks without a move that cutter compensation looks past; 0: not known */
	enum rotation_order rotation_order;
	enum cycle_19_angles cycle_19_angles;
	enum cycle_11_axes cycle_11_axes;
	enum orientation_interpolation orientation_interpolation;
	enum edge_after_tool_change edge_after_tool_change;
	enum answer t_changes_tool;	/* T by itself changes the tool; or M6 does */
	enum answer frames_outlive_cycle800;	/* programmable frames, when CYCLE800() cancels its plane */
	enum answer mirror_toggle;	/* MIRROR ignores the values of its axes; or 0 means no mirroring */
	enum answer frames_outlive_traori;	/* frames and work offsets, when TRAORI begins or ends */
	enum answer length_along_z;	/* the tool length acts along Z in every plane */
	enum increments_after_shift increments_after_shift;
	int power_on_work_offset;	/* 1: none (G500), 2: G54, 3: G55 and so on; 0: not known */
	/* the rotary slot whose sign distinguishes the solutions of a swivelled plane; 0: not known */
	int swivel_axis;
	enum swivel_pole swivel_pole;
	enum plane_retract plane_retract;
	enum shift_behind_plane shift_behind_plane;
	enum plane_rotation plane_rotation;
	enum rotary_way rotary_way;
	enum rotary_angle rotary_angle;
	enum m6_action m6;
	enum tool_def tool_def;
	enum orientation_pole orientation_pole;
	const struct mcode *mcodes;
	size_t mcode_count;
	const struct builder_macro *macros;
	size_t macro_count;
	const struct control_variable *variables;
	size_t variable_count;
	struct control_place references[REFERENCES_MAX];
	struct control_place tool_change;	/* M6 moves there first */
	struct control_place swivel_retract;	/* a swivelling cycle moves there first if the program says so */
};

#endif
