/* canon.h - the canonical moves that an interpreter makes of a program, whatever its dialect. */
#ifndef FIVECHECK_GCODE_CANON_H
#define FIVECHECK_GCODE_CANON_H

#include <stdbool.h>

#include "base/axes.h"
#include "base/call_chain.h"
#include "base/minmax.h"
#include "geom/vec3.h"

/*
 * Positions are of the controller's axes with every offset applied, in mm and
 * radians. Without TCP they are machine axis positions. Under TCP (tool centre
 * point control) they are the positions that the linear axes would have at
 * rotary zero with no tool; the tool's length then acts along the spindle and
 * is the machine's business (kinematics.h).
 */

enum canon_kind {
	CANON_RAPID,	/* straight, at the axes' rates */
	CANON_FEED,	/* straight, at the programmed feed */
	CANON_ARC,	/* circular or helical, at the programmed feed */
	CANON_DWELL,	/* stands still for `seconds` */
	CANON_TOOL_CHANGE,	/* `tool` is in the spindle from here on; 0: empty */
	CANON_SPINDLE_STOP	/* the spindle has turned and stands here */
};

/* Which way the spindle turns. */
enum canon_turn {
	TURN_UNKNOWN,
	TURN_CLOCKWISE,	/* M3 */
	TURN_COUNTERCLOCKWISE,	/* M4 */
	TURN_OF_TAP	/* as the tap needs it: the cycle sees to that */
};

struct canon_feed {
	bool inverse_time;	/* G93: the move takes `seconds` */
	double seconds;
	double linear;	/* mm/s along the path of X Y Z, or else U V W */
	double angular;	/* rad/s, for moves of rotary axes alone */
};

/*
 * X Y Z turn about the line through `centre` along `normal` (unit) while every
 * axis, X Y Z included, goes linearly from start to end in what is left of it:
 * with r0 and r1 the radii of start and end, the point at s is centre + the
 * start's radius vector turned by s * sweep and brought to length
 * (1-s) r0 + s r1, + the rise along the normal times s.
 */
struct canon_arc {
	vec3 centre;	/* at the height of the start */
	vec3 normal;
	double sweep;	/* radians about the normal, right-handed; |sweep| may exceed 2 pi */
};

/* What stood between the programmed coordinates and the axes when the move was commanded: for reports. */
struct canon_origin {
	const char *work_offset;	/* in force: "G54"; a constant */
	axis_values work;	/* its values, mm and radians */
	axis_values shift;	/* of G52 and G92 */
	double length;	/* mm: of the tool, in force */
	/* more than offsets lies between: coordinates are turned, mirrored or scaled, or CYCL DEF 7 moves them */
	bool turned;
};

struct canon_move {
	enum canon_kind kind;
	const char *file;	/* of the block: the program's or a subprogram's; kept in gcode_config.names */
	long line;	/* of the block */
	int number;	/* of this move in its block, from 1 */
	bool tcp;
	bool plane;	/* with tcp: rotary axes stand still (G53.1), and the axes go as without it */
	bool blend;	/* G64: the control may leave the path (canon_move.blend_tolerance) */
	double blend_tolerance;	/* mm; 0: G64 without P */
	/* radians: of the axes that turn the tool; 0: as blend.h takes it */
	double blend_turn;
	/* mm: how far X, Y and Z may be beside the path; under TCP X, Y and Z of the workpiece, as `end` means them */
	double spread[3];
	/* the axis stays between places that other moves cover, spread and all: of straight moves */
	bool between[3];
	/*
	 * Radians, A B C: how far the rotary axes may be beside their straight way. Under TCP the linear axes follow
	 * them, so that the tip keeps its place.
	 */
	double turn_spread[3];
	bool may_stop;	/* it may end anywhere on its way (a probe) */
	bool after_probe;	/* it covers the ways from all places where a probe may have stopped */
	bool spindle_turns;	/* by M3 or M4 without S0, or by the canned cycle itself */
	enum canon_turn turn;
	/* revolutions per minute, by M4 below 0; 0: it stands, or nothing said how fast it turns */
	double spindle_speed;
	axis_values end;	/* RAPID, FEED, ARC */
	struct canon_arc arc;
	struct canon_feed feed;	/* FEED, ARC */
	double seconds;	/* DWELL */
	int tool;	/* TOOL_CHANGE */
	bool machine_coordinates;	/* G53, G28 and the like: no offset led to its end */
	const struct canon_origin *origin;	/* valid as long as the event */
};

/*
 * A move that nothing was said of but its kind. Its end and what the modes say of it are left open, because whoever
 * sends the move fills them in: a block's cost counts, and a move is large.
 */
static inline void canon_move_begin(struct canon_move *move, enum canon_kind kind)
{
	move->kind = kind;
	for (int i = 0; i < 3; i++) {
		move->spread[i] = move->turn_spread[i] = 0;
		move->between[i] = false;
	}
	move->may_stop = move->after_probe = move->spindle_turns = move->machine_coordinates = false;
	move->turn = TURN_UNKNOWN;
	move->spindle_speed = 0;
	move->arc = (struct canon_arc){0};
	move->feed = (struct canon_feed){0};
	move->seconds = 0;
	move->tool = 0;
}

/* Is it known only as a set of paths, or as one that may end early? */
static inline bool canon_move_is_bounded(const struct canon_move *move)
{
	double most = 0;

	for (int i = 0; i < 3; i++)
		most = larger(most, larger(move->spread[i], move->turn_spread[i]));
	return most > 0 || move->may_stop || move->after_probe;
}

/* A block has been carried out. */
struct canon_block {
	const char *file;	/* as in canon_move */
	long line;
	const char *text;	/* the line as it stands in the file; valid during the call */
	int moves;
	const struct call_chain *callers;	/* valid during the call; NULL: as an empty one */
	long lines;	/* of the program, read so far */
};

enum canon_event_kind { CANON_MOVE, CANON_BLOCK };

/*
 * What an interpreter tells, in the order of the program: the moves of a block, then its end. Valid during the call: a
 * move is large, and most sinks need it once.
 */
struct canon_event {
	enum canon_event_kind kind;
	union {
		const struct canon_move *move;
		const struct canon_block *block;
	} of;
};

/* Where an interpreter sends its events. */
struct canon_sink {
	void *context;
	/* False: stop interpreting; the sink knows why. */
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
