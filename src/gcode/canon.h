/* canon.h - the canonical moves that an interpreter makes from a program, the same for every dialect. */
#ifndef FIVECHECK_GCODE_CANON_H
#define FIVECHECK_GCODE_CANON_H

#include <stdbool.h>

#include "base/axes.h"
#include "base/call_chain.h"
#include "base/minmax.h"
#include "geom/vec3.h"

/*
 * Positions are those of the controller's axes with every offset applied, in mm and radians. Without TCP they are
 * machine axis positions. Under TCP (tool centre point control) they are the positions that the linear axes would have
 * at rotary zero with no tool; the machine's kinematics then adds the tool's length along the spindle (kinematics.h).
 */

enum canon_kind {
	CANON_RAPID,	/* straight, at the axes' rates */
	CANON_FEED,	/* straight, at the programmed feed */
	CANON_ARC,	/* circular or helical, at the programmed feed */
	CANON_DWELL,	/* no motion for `seconds` */
	CANON_TOOL_CHANGE,	/* `tool` is in the spindle from now on; 0: empty */
	CANON_SPINDLE_STOP	/* the spindle was turning and stops here */
};

/* The direction of the spindle. */
enum canon_turn {
	TURN_UNKNOWN,
	TURN_CLOCKWISE,	/* M3 */
	TURN_COUNTERCLOCKWISE,	/* M4 */
	TURN_OF_TAP	/* as the tap needs it: the cycle switches it */
};

struct canon_feed {
	bool inverse_time;	/* G93: the move takes `seconds` */
	double seconds;
	double linear;	/* mm/s along the path of X Y Z; without X Y Z, along the path of U V W */
	double angular;	/* rad/s, for moves of rotary axes only */
};

/*
 * X Y Z turn about the line through `centre` along `normal` (unit vector). The radius, the rise along the normal and
 * all other axes change linearly from start to end: with r0 and r1 the radii of start and end, the point at s is
 * centre + the start's radius vector turned by s * sweep and scaled to the length (1-s) r0 + s r1, + the rise along the
 * normal times s.
 */
struct canon_arc {
	vec3 centre;	/* at the height of the start */
	vec3 normal;
	double sweep;	/* radians about the normal, right-handed; |sweep| may exceed 2 pi */
};

/* The offsets between the programmed coordinates and the axes when the move was commanded: for reports. */
struct canon_origin {
	const char *work_offset;	/* the active one, such as "G54"; a constant */
	axis_values work;	/* its values, mm and radians */
	axis_values shift;	/* of G52 and G92 */
	double length;	/* mm: the active tool length compensation */
	/* these offsets are not all: coordinates are also turned, mirrored or scaled, or CYCL DEF 7 shifts them */
	bool turned;
};

struct canon_move {
	enum canon_kind kind;
	const char *file;	/* of the block: the program's or a subprogram's; owned by gcode_config.names */
	long line;	/* of the block */
	int number;	/* of this move in its block, from 1 */
	bool tcp;
	bool plane;	/* with tcp: the rotary axes stand still (G53.1), and the linear axes move as without TCP */
	bool blend;	/* G64: the control may leave the path (canon_move.blend_tolerance) */
	double blend_tolerance;	/* mm; 0: G64 without P */
	/* radians: the program's path tolerance of the axes that turn the tool; 0: motion/blend.h has a default */
	double blend_turn;
	/* mm: how far X, Y and Z may be from the path; under TCP in the workpiece coordinates of `end` */
	double spread[3];
	/* of straight moves: the axis stays between places that other moves cover with their spread */
	bool between[3];
	/*
	 * Radians, A B C: how far the rotary axes may be from their linear interpolation. Under TCP the linear axes
	 * compensate, so that the tool tip keeps its place.
	 */
	double turn_spread[3];
	bool may_stop;	/* the move may end anywhere on its path (a probe) */
	bool apart;	/* of RAPID: each axis moves by itself, so it may be anywhere between start and end */
	bool after_probe;	/* the move covers the paths from all places where a probe may have stopped */
	bool spindle_turns;	/* by M3 or M4 without S0, or by the canned cycle itself */
	enum canon_turn turn;
	/* revolutions per minute, negative after M4; 0: the spindle stands, or its speed is not known */
	double spindle_speed;
	axis_values end;	/* RAPID, FEED, ARC */
	struct canon_arc arc;
	struct canon_feed feed;	/* FEED, ARC */
	double seconds;	/* DWELL */
	int tool;	/* TOOL_CHANGE */
	bool machine_coordinates;	/* G53, G28 and the like: no offset applies to the end */
	const struct canon_origin *origin;	/* valid as long as the event */
};

/*
 * Starts a move of this kind. The end and the members that depend on the modes are not initialised, because the sender
 * of the move sets them: a move is large, and the time for each block matters.
 */
static inline void canon_move_begin(struct canon_move *move, enum canon_kind kind)
{
	move->kind = kind;
	for (int i = 0; i < 3; i++) {
		move->spread[i] = move->turn_spread[i] = 0;
		move->between[i] = false;
	}
	move->may_stop = move->apart = move->after_probe = move->spindle_turns = move->machine_coordinates = false;
	move->turn = TURN_UNKNOWN;
	move->spindle_speed = 0;
	move->arc = (struct canon_arc){0};
	move->feed = (struct canon_feed){0};
	move->seconds = 0;
	move->tool = 0;
}

/* Is the move known only as a set of paths, or may it end early? */
static inline bool canon_move_is_bounded(const struct canon_move *move)
{
	double most = 0;

	for (int i = 0; i < 3; i++)
		most = larger(most, larger(move->spread[i], move->turn_spread[i]));
	return most > 0 || move->may_stop || move->after_probe;
}

/* The end of a block. */
struct canon_block {
	const char *file;	/* as in canon_move */
	long line;
	const char *text;	/* the line of the file, unchanged; valid during the call */
	int moves;
	const struct call_chain *callers;	/* valid during the call; NULL: no callers */
	long lines;	/* of the program, read so far */
};

enum canon_event_kind { CANON_MOVE, CANON_BLOCK };

/*
 * The events of an interpreter, in the order of the program: the moves of a block, then its end. An event is valid
 * during the call only: a move is large, and most sinks need it once.
 */
struct canon_event {
	enum canon_event_kind kind;
	union {
		const struct canon_move *move;
		const struct canon_block *block;
	} of;
};

/* The receiver of an interpreter's events. */
struct canon_sink {
	void *context;
	/* False: the interpreter stops; the sink knows why. */
	bool (*event)(void *context, const struct canon_event *event);
};

static inline bool canon_tell_move(const struct canon_sink *sink, const struct canon_move *move)
{
	return sink->event(sink->context, &(struct canon_event){.kind = CANON_MOVE, .of.move = move});
}

static inline bool canon_tell_block(const struct canon_sink *sink, const struct canon_block *block)
{
	return sink->event(sink->context, &(struct canon_event){.kind = CANON_BLOCK, .of.block = block});
}

#endif
