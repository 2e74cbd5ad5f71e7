/* offset_tables.h - the rows of a control's tables: work offsets, tools, length offsets. */
#ifndef FIVECHECK_CONTROL_OFFSET_TABLES_H
#define FIVECHECK_CONTROL_OFFSET_TABLES_H

#include "base/axes.h"

/* Lengths in mm, angles in radians. Strings are borrowed from whoever fills a row in. */

struct work_offset {
	const char *name;	/* "G54" ... "G59.3", "G54.1 P7", "G54.4 P1" */
	axis_values value;
	const char *checked;	/* why it is right though it looks wrong; or NULL */
	long line;	/* in the setup file */
};

/* What a tool needs so that its contact with the part is work and not a crash. */
enum tool_kind {
	TOOL_TURNS,	/* a cutter: a programmed feed and a spindle that turns */
	TOOL_STANDS,	/* a nozzle, a laser, a drag knife: a programmed feed alone */
	TOOL_PROBES	/* a probe: a motion that ends where it touches, such as G31 */
};

/* Which way the spindle has to turn so that a cutter cuts: a right-hand one with M3, a left-hand one with M4. */
enum tool_hand { HAND_UNKNOWN, HAND_RIGHT, HAND_LEFT };

struct tool {
	int number;	/* > 0 */
	const char *name;	/* or "" */
	const char *checked;	/* why it is right though it looks wrong; or NULL */
	double length;	/* from the gauge point to the tip */
	double diameter;	/* of the cutter, or with which the control compensates if that differs; 0: unknown */
	bool deltas;	/* length_offset and diameter include DL and DR of a tool table, which are not 0 */
	double point_angle;	/* radians, the full angle of a conical tip; 0: the tip is no cone */
	double length_offset;	/* H of the same number, unless the setup's <offset> says otherwise */
	enum tool_kind kind;
	enum tool_hand hand;	/* of a cutter that turns */
	long line;	/* in the setup file */
};

/* An edge of a tool beside its first, which the tool's own row has. */
struct tool_edge {
	int tool;	/* its number */
	int number;	/* > 1 */
	double length;
	double diameter;	/* 0: the tool's; less: the control has no radius */
};

struct length_offset {
	int number;	/* H */
	double length;
};

struct radius_offset {
	int number;	/* D */
	double radius;	/* by which cutter compensation keeps beside the path; may be negative */
};

#endif
