/* controller.h - what is known of a machine's control: its dialect, its parameters, the places that it goes to. */
#ifndef FIVECHECK_CONTROL_CONTROLLER_H
#define FIVECHECK_CONTROL_CONTROLLER_H

#include <stdbool.h>
#include <stddef.h>

#include "base/axes.h"
#include "base/diag.h"

/* Lengths in mm, angles in radians. */

/* How a rapid moves: on a straight line, each axis at its own rate, or in a way that is not known. */
enum rapid { RAPID_LINEAR, RAPID_DOGLEG, RAPID_ANY };

/*
 * How a rotary axis takes an absolute target: as a plain number; modulo a turn,
 * the shorter way; modulo a turn, in the direction of the target's sign.
 */
enum wrap { WRAP_NONE, WRAP_SHORTEST, WRAP_SIGN };

/* The answer to a question that only the maker of the machine or a parameter of the control can answer. */
enum answer { ANSWER_UNKNOWN, ANSWER_YES, ANSWER_NO };

/* G53 while G91 is in force: its words are absolute all the same, or G53 is ignored and they are increments. */
enum g53_with_g91 { G53_WITH_G91_UNKNOWN, G53_WITH_G91_ABSOLUTE, G53_WITH_G91_INCREMENTAL };

/* What G28, G30, G53 and a place of M6 leave of the length compensation of the axes that they have moved. */
enum length_after_reference {
	LENGTH_AFTER_REFERENCE_UNKNOWN,
	LENGTH_AFTER_REFERENCE_KEPT,
	LENGTH_AFTER_REFERENCE_GONE
};

/* While G68 with I, J and K is in force the tool's length acts along the turned Z, or along Z of the machine. */
enum length_under_g68 { LENGTH_UNDER_G68_UNKNOWN, LENGTH_UNDER_G68_TURNED, LENGTH_UNDER_G68_STRAIGHT };

/* M6 in a block that moves axes: the tool is changed behind the move, or before it. */
enum m6_with_move { M6_WITH_MOVE_UNKNOWN, M6_AFTER_MOVE, M6_BEFORE_MOVE };

/*
 * A block has T and M6, and the T of an earlier block still waits: M6 loads the T of its own block, or the earlier one.
 * The other T is then the one that is selected.
 */
enum m6_with_t { M6_WITH_T_UNKNOWN, M6_LOADS_OWN_T, M6_LOADS_T_BEFORE, M6_LOADS_FIRST_T };

/* What ';' does in a line, and what ':' with a number at its head is. */
enum semicolon { SEMICOLON_UNKNOWN, SEMICOLON_STARTS_COMMENT, SEMICOLON_ENDS_BLOCK };
enum colon { COLON_UNKNOWN, COLON_PROGRAM, COLON_BLOCK };

/*
 * Cutter compensation: how the first and the last block lead to the path and away from it, and how the tool goes
 * round an outside corner. Not known: every way is proved.
 */
enum comp_d { COMP_D_UNKNOWN, COMP_D_RADIUS, COMP_D_DIAMETER };	/* what programs write into D's registers */
enum comp_start { COMP_START_UNKNOWN, COMP_START_A, COMP_START_B };
enum comp_corner_form {
	COMP_CORNER_UNKNOWN,
	COMP_CORNER_LINEAR,
	COMP_CORNER_CIRCULAR,
	COMP_CORNER_CROSSING,	/* both ways are drawn out to where they cross, however sharp it is */
	COMP_CORNER_CROSSING_IF_BLUNT,	/* where they cross; sharper than a right angle, there or on a circle */
	COMP_CORNER_BETWEEN	/* anywhere between where they cross and a circle */
};

/* In which order several angles of one block turn the program's coordinates. */
enum rotation_order { ROTATION_ORDER_UNKNOWN, ROTATION_ORDER_RPY, ROTATION_ORDER_EULER };

/* How guided rotary axes turn the tool where the program leaves it open: evenly, or its direction on a great circle. */
enum orientation_interpolation {
	ORIENTATION_INTERPOLATION_UNKNOWN,
	ORIENTATION_INTERPOLATION_AXES,
	ORIENTATION_INTERPOLATION_VECTOR
};

/* The tool's edge that holds after a tool change: the first, none, or the number of before. */
enum edge_after_tool_change {
	EDGE_AFTER_TOOL_CHANGE_UNKNOWN,
	EDGE_AFTER_TOOL_CHANGE_FIRST,
	EDGE_AFTER_TOOL_CHANGE_NONE,
	EDGE_AFTER_TOOL_CHANGE_KEEPS
};

/* An increment after a change of offsets: it traverses the change, too, or counts from where the axis stands. */
enum increments_after_shift { INCREMENTS_AFTER_SHIFT_UNKNOWN, INCREMENTS_TRAVERSE_SHIFT, INCREMENTS_FROM_POSITION };

/* When MB of PLANE ... TURN retracts the tool: also where no rotary axis has to turn, or only where one has to. */
enum plane_retract { PLANE_RETRACT_UNKNOWN, PLANE_RETRACT_ALWAYS, PLANE_RETRACT_TURNING };

/*
 * What PLANE without COORD ROT and TABLE ROT turns where a rotary axis is free: the coordinates alone (TNC 640, TNC7),
 * or the table, as bit 6 of MP7500 says on iTNC 530.
 */
enum plane_rotation { PLANE_ROTATION_UNKNOWN, PLANE_ROTATION_COORDINATES, PLANE_ROTATION_TABLE };

/*
 * How a rotary axis whose display is reduced to 360 degrees goes without M126: by the difference of the two values, or
 * the shorter way (MP7682 bit 2, shortestDistance).
 */
enum rotary_way { ROTARY_WAY_UNKNOWN, ROTARY_WAY_PLAIN, ROTARY_WAY_SHORTER };

/* What an angle below 0, or of 360 and more, means to an axis that goes the plain way. */
enum rotary_angle { ROTARY_ANGLE_UNKNOWN, ROTARY_ANGLE_AS_WRITTEN, ROTARY_ANGLE_REDUCED };

/* Whether M6 does anything: where TOOL CALL alone changes the tool it does not. */
enum m6_action { M6_UNKNOWN, M6_IGNORED };

/* Whether L and R of TOOL DEF count: with an active tool table they do not. */
enum tool_def { TOOL_DEF_UNKNOWN, TOOL_DEF_IGNORED };

/* Where a swivelled plane (CYCLE800, PLANE) leaves a rotary axis free, it goes to 0 or keeps its position. */
enum swivel_pole { SWIVEL_POLE_UNKNOWN, SWIVEL_POLE_ZERO, SWIVEL_POLE_STAYS };

/* A great circle of the tool that begins at a pole of the rotary axes, or leads near one: these axes turn evenly. */
enum orientation_pole { ORIENTATION_POLE_UNKNOWN, ORIENTATION_POLE_AXES };

/* What the angles of Heidenhain's cycle 19 are: spatial angles, or positions of the rotary axes. */
enum cycle_19_angles { CYCLE_19_ANGLES_UNKNOWN, CYCLE_19_ANGLES_SPATIAL, CYCLE_19_ANGLES_AXES };

/* Which axes Heidenhain's cycle 11 scales: those of the plane, or the tool axis as well. */
enum cycle_11_axes { CYCLE_11_AXES_UNKNOWN, CYCLE_11_AXES_PLANE, CYCLE_11_AXES_ALL };

/* Modes that the control has when it is switched on, if a parameter of the control decides. */
enum power_on_units { POWER_ON_UNITS_UNKNOWN, POWER_ON_MM, POWER_ON_INCH };
enum power_on_distance { POWER_ON_DISTANCE_UNKNOWN, POWER_ON_ABSOLUTE, POWER_ON_INCREMENTAL };
enum power_on_plane { POWER_ON_PLANE_UNKNOWN, POWER_ON_XY, POWER_ON_ZX, POWER_ON_YZ };

enum power_on_motion { POWER_ON_MOTION_UNKNOWN, POWER_ON_RAPID, POWER_ON_FEED };

/* The word that repeats a canned cycle on controls where a parameter decides. */
enum cycle_repeats { CYCLE_REPEATS_UNKNOWN, CYCLE_REPEATS_K, CYCLE_REPEATS_L };

/* What the machine's maker has an M-code do. */
enum mcode_action { MCODE_TCP_ON, MCODE_TCP_OFF, MCODE_IGNORE, MCODE_SPINDLE_ON, MCODE_SPINDLE_OFF };

struct mcode {
	int number;
	enum mcode_action action;
};

/*
 * What a program of the machine's maker does, such as O9810 of a probe: nothing that is followed; a straight move to
 * the X, Y and Z of its call; or moves somewhere around the place where it is called, and back to it.
 */
enum macro_action { MACRO_NONE, MACRO_MOVE, MACRO_AROUND };

#define MACRO_OF_CODE (-1)

struct builder_macro {
	int program;	/* MACRO_OF_CODE: its number is not known, only its name or the code that calls it */
	double code;	/* the G-code that calls it, too; 0: none does */
	enum macro_action action;
	double around[3];	/* mm along X, Y and Z, to both sides: MACRO_AROUND */
	const char *name;	/* upper case, where programs have names; NULL: it has none */
};

/* Of an array. */
#define CONTROL_DIMENSIONS 3

enum control_type { CONTROL_REAL, CONTROL_INT, CONTROL_BOOL, CONTROL_CHAR, CONTROL_STRING, CONTROL_AXIS };

/*
 * A variable that programs read and the control has: a parameter that keeps its value, a variable of the maker or a
 * system variable; and what it holds when a program begins.
 */
struct control_variable {
	const char *name;	/* as control_variable_name_normalise leaves it */
	bool typed;	/* its type is given, and with it the variable is made */
	enum control_type type;
	int dimensions;	/* 0: one value */
	int size[CONTROL_DIMENSIONS];
	const char *text;	/* of each of its elements; NULL: none was given */
	double number;	/* that the text is, or TRUE or FALSE; NAN: it is none */
	struct srcloc at;	/* of its element; borrows the name of the file */
};

/* A place in machine coordinates where the control sends axes by itself. */
struct control_place {
	bool given;
	bool has[SLOT_COUNT];	/* the place says where this axis goes */
	axis_values value;
	int order[SLOT_COUNT];	/* slots that move one after another; the other axes move last, together */
	size_t order_count;
};

/* Reference positions: G28, and G30 P2 to P4. */
#define REFERENCES_MAX 4

/* Plain data; the pointers are borrowed from whoever fills it in. All zero is a control of which nothing was said. */
struct controller {
	int dialect;	/* row of control/dialects.h */
	enum rapid rapid;
	bool tcp_zero_offset;	/* rotary zero under TCP: the work offset's rotary words, else the machine's zero */
	enum answer tcp_zero_given;	/* ANSWER_YES: the machine file says which */
	double path_tolerance;	/* mm, and degrees for rotary axes; 0: none given */
	double unit;	/* mm per unit of length of the control itself, in which parameters hold offsets; 0: mm */
	/* mm or degrees of a word without a decimal point that counts 1; 1: whole units; 0: not known */
	double least_input;
	enum power_on_units power_on_units;
	enum power_on_distance power_on_distance;
	enum power_on_plane power_on_plane;
	enum power_on_motion power_on_motion;
	enum cycle_repeats cycle_repeats;
	enum answer length_moves;	/* do axes move at once where the length compensation changes? */
	enum length_after_reference length_after_reference;
	enum length_under_g68 length_under_g68;
	int polar_axis;	/* the rotary slot that G12.1 takes together with X; 0: not known */
	enum g53_with_g91 g53_with_g91;
	double overrun;	/* mm: how far G60 goes past its end; 0: not known */
	double arc_radius_tolerance;	/* mm: arcs whose radii differ by no more are spirals; 0: not known */
	enum m6_with_move m6_with_move;
	enum m6_with_t m6_with_t;
	enum semicolon semicolon;
	enum colon colon;
	enum comp_d comp_d;
	enum comp_start comp_start;
	enum comp_corner_form comp_corner;
	enum rotation_order rotation_order;
	enum cycle_19_angles cycle_19_angles;
	enum cycle_11_axes cycle_11_axes;
	enum orientation_interpolation orientation_interpolation;
	enum edge_after_tool_change edge_after_tool_change;
	enum answer t_changes_tool;	/* T by itself changes the tool; or M6 does */
	enum answer frames_outlive_cycle800;	/* programmable frames, where CYCLE800() takes its plane back */
	enum answer frames_outlive_traori;	/* and work offsets, where guided motion begins or ends */
	enum answer length_along_z;	/* the tool's length acts along Z whatever the plane */
	enum increments_after_shift increments_after_shift;
	int power_on_work_offset;	/* 1: none (G500), 2: G54, 3: G55 and so on; 0: not known */
	/* the rotary slot whose sign tells the solutions of a swivelled plane apart; 0: not known */
	int swivel_axis;
	enum swivel_pole swivel_pole;
	enum plane_retract plane_retract;
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
	struct control_place tool_change;	/* M6 goes there first */
	struct control_place swivel_retract;	/* a cycle that swivels goes there first if it is told to */
};

#endif
