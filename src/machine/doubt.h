/* doubt.h - likely mistakes in a machine or a setup, as plain data. */
#ifndef FIVECHECK_MACHINE_DOUBT_H
#define FIVECHECK_MACHINE_DOUBT_H

#include <stddef.h>

#include "geom/vec3.h"

/* Lengths in mm, angles in radians. "Relative to the work": the tool's motion as seen from the workholding. */
enum doubt_kind {
	/* About the machine's motions; `axis` and `other` are indices of machine->axes. */
	DOUBT_LEFT_HANDED, /* X Y Z of the tool relative to the work */
	DOUBT_TURNED, /* X Y Z of the tool relative to the work are right-handed, but not those of the drawing */
	DOUBT_PARALLEL, /* axis and other move the tool along one line */
	/* axis moves the tool along, or rotates it about, the direction of another letter: `other` is 0 X, 1 Y, 2 Z */
	DOUBT_LETTER,
	DOUBT_SIGN, /* a positive value of the linear axis moves the tool along -X, -Y, -Z of the drawing */
	DOUBT_ROTARY_SIGN, /* a positive value rotates the tool about -X, -Y, -Z */
	DOUBT_IDLE, /* the axis X, Y or Z moves neither the tool nor the work */
	DOUBT_TURNS_ITSELF, /* the rotary axis next to the tool rotates it about its own line */
	DOUBT_RATE_LOW, /* the axis' rate_max is `value` mm or radians a minute */
	DOUBT_RADIANS, /* the travel of the rotary axis is only `value` */
	DOUBT_TILTED, /* the direction of the axis is `value` degrees off X, Y or Z */
	DOUBT_SPINDLE_TILTED, /* the same for the direction of the spindle */
	DOUBT_ROTARY_MISSES, /* the axis' line is outside all bodies that it carries, by `value` */
	/* no circle has its middle on the axis; the nearest one, of diameter `limit`, is `value` away */
	DOUBT_ROTARY_BESIDE,
	DOUBT_SPINDLE_ACROSS, /* Z does not move the tool along the spindle */
	DOUBT_SPINDLE_TOWARD, /* Z+ moves the tool in the direction of its tip */
	/* the tool points into the body that carries it, which reaches `value` ahead of the gauge point */
	DOUBT_SPINDLE_IN_HEAD,
	DOUBT_SPINDLE_AWAY, /* the workholding is behind the tool at every position, by at least `value` */
	DOUBT_SPINDLE_BESIDE, /* no circle of the head has its middle on the spindle's line; as ROTARY_BESIDE */
	DOUBT_SPINDLE_FAR, /* the gauge point is `value` from the nearest body of its link */
	/* at every position of the linear axes the workholding is at least `value` beside the tool */
	DOUBT_WORKHOLDING_BESIDE,
	DOUBT_WORKHOLDING_FAR, /* the workholding is `value` from the nearest body of its link */
	/* the size of all bodies of the machine together is `value`, the longest travel is `limit` */
	DOUBT_BODIES_SMALL,
	DOUBT_BODIES_LARGE,
	DOUBT_SPINDLE_BARE, /* no body is on the spindle's link */
	DOUBT_WORKHOLDING_BARE, /* no body is on the workholding's link */
	DOUBT_BASE_BARE, /* no body is on the base */
	DOUBT_GAP, /* all bodies on axis are far from those that carry it: `body` and `against` are `value` apart */
	DOUBT_EXCUSED_APART, /* `body` and `against` are excused as neighbours, but `value` apart or more */
	/* excused as neighbours, but with axis at `limit` one of them is `value` deep in the other */
	DOUBT_NEIGHBOURS_MEET,
	DOUBT_TRAVEL_LONG, /* the travel of axis is `value`; all bodies together extend over `limit` along it */
	DOUBT_TRAVEL_ENDLESS, /* the travel of axis has no limits; other axes have limits */
	DOUBT_TWICE, /* `body` and `against` are the same mesh in the same place */
	DOUBT_ROTATION, /* the body is rotated by `value` degrees, which looks like radians */
	DOUBT_WORKHOLDING_ROTATION, /* the same for the workholding */
	/*
	 * About the setup; `body` and `against` are indices of scene->bodies, `item` of setup->tools or setup->offsets.
	 */
	DOUBT_FLOATS, /* the body is `value` away from all bodies that could hold it; `against` is the nearest */
	DOUBT_SINKS, /* the body is `value` deep inside `against` */
	DOUBT_PART_LARGE, /* the size of the body is `value`, the longest travel is `limit` */
	DOUBT_BODY_SMALL, /* the same */
	DOUBT_PART_BELOW_CUTTERS, /* the size of the body is `value`, the diameter of the thinnest cutter is `limit` */
	DOUBT_OUT_OF_STOCK, /* the part's corner is `value` outside the stock, `against` */
	DOUBT_PART_BELOW_STOCK, /* the length of the body is `value`, that of the stock, `against`, is `limit` */
	DOUBT_PART_BESIDE, /* the tool's tip stays at least `value` from the body along `direction` */
	DOUBT_TOOL_SHORT, /* at its lowest position the tool's tip is `value` above the part */
	DOUBT_TOOL_LONG, /* the length of the tool is `value`, the travel of Z is `limit` */
	DOUBT_TOOL_TINY, /* the same */
	DOUBT_TOOL_BELOW, /* at its highest position the tool's tip is `value` below the part and the fixtures */
	DOUBT_TOOL_BARE, /* the tool and `value` others have no holder */
	DOUBT_HOLDER_TURNED, /* the holder's diameter is `value` at the gauge line, and `limit` where it is thickest */
	DOUBT_TOOL_ENDS, /* the tool's bodies end `value` from the gauge line, its length is `limit` */
	DOUBT_TOOL_ASIDE, /* the middle of `body`, of a tool, is `value` beside the spindle's line */
	DOUBT_RADIUS_OFFSET, /* the radius of D is `value`; the diameter of the tool with its number is `limit` */
	DOUBT_TOOL_SHARP, /* the outermost `value` of the cutter has no core, though its depth is only `limit` */
	DOUBT_TOOL_NAME, /* the tool's diameter is `value`; its name gives twice as much, `limit` */
	DOUBT_LENGTH_OFFSET, /* the tool's H is `value`, its length is `limit` */
	DOUBT_OFFSET_OUTSIDE, /* the offset's `value` for `axis` is outside its travel */
	DOUBT_OFFSET_FAR /* program zero is `value` away from the whole setup, the size of which is `limit` */
};

struct doubt {
	enum doubt_kind kind;
	int axis, other;
	int body, against;
	size_t item;
	double value, limit;
	vec3 direction;
};

/* Plain data; owns its items. All zero is an empty list. */
struct doubts {
	struct doubt *items;
	size_t count, capacity;
};

void doubts_add(struct doubts *doubts, const struct doubt *doubt);
/* Appends copies of the others. */
void doubts_add_all(struct doubts *doubts, const struct doubts *others);
void doubts_release(struct doubts *doubts);

#endif
