/* interp.h - reads a g-code program block by block and carries it out as canonical moves. */
#ifndef FIVECHECK_GCODE_INTERP_H
#define FIVECHECK_GCODE_INTERP_H

#include <stdbool.h>
#include <stddef.h>
#include <stdio.h>

#include "base/axes.h"
#include "base/diag.h"
#include "gcode/canon.h"
#include "gcode/dialect.h"
#include "gcode/read_options.h"

enum gcode_wrap { GCODE_WRAP_NONE, GCODE_WRAP_SHORTEST, GCODE_WRAP_SIGN };
enum gcode_answer { GCODE_UNKNOWN, GCODE_YES, GCODE_NO };
enum gcode_mcode { GCODE_TCP_ON, GCODE_TCP_OFF, GCODE_IGNORE };

/* A place of the machine where the control sends axes by itself, in machine coordinates. */
struct gcode_place {
	bool given;
	bool has[SLOT_COUNT];	/* the place says where this axis goes */
	axis_values value;
	int order[SLOT_COUNT];	/* slots that move one after another; what is not here moves last, together */
	size_t order_count;
};

/* G28, and G30 P2 to P4. */
#define REFERENCE_COUNT 4

/* Borrowed, and constant while a program runs. Lengths in mm, angles in radians. */
struct gcode_config {
	const struct dialect *dialect;
	bool has_axis[SLOT_COUNT];	/* a word for an axis that the machine lacks is an error */
	enum gcode_wrap wrap[SLOT_COUNT];
	int half_turn[SLOT_COUNT];	/* with GCODE_WRAP_SHORTEST: 1 or -1, the way of half a turn; 0: not known */
	axis_values home;	/* where the program starts; the first two reference positions in want of others */
	struct gcode_place references[REFERENCE_COUNT];
	struct gcode_place tool_change;	/* M6 goes there first; not given: LinuxCNC moves nothing */
	enum gcode_answer length_moves;	/* not of LinuxCNC: do axes move at once where the length changes? */
	bool tcp_zero_offset;	/* rotary zero under TCP is the work offset's, else the machine's */
	double unit;	/* mm per unit of length of the control itself, in which parameters hold offsets; 0: mm */
	double least_input;	/* mm or degrees; what a 1 without a decimal point means; 0: a whole unit */
	bool has_setup;	/* tools, lengths and offsets are known; else any T is accepted, and an H is an error */
	int initial_tool;
	const struct gcode_mcode_meaning {
		int number;
		enum gcode_mcode action;
	} *mcodes;
	size_t mcode_count;
	const struct gcode_work_offset {
		const char *name;	/* "G54" ... "G59.3" */
		axis_values value;
	} *work_offsets;
	size_t work_offset_count;
	vec3 work_change;	/* mm: added to every work offset that the program starts with, named or not */
	const struct gcode_tool {
		int number;
		double length_offset;
		double diameter;
	} *tools;
	size_t tool_count;
	const struct gcode_length {
		int number;	/* H */
		double length;
	} *lengths;
	size_t length_count;
	struct read_options read;
};

struct interp;

/* config, sink and diag are borrowed until interp_free. */
struct interp *interp_new(const struct gcode_config *config, const struct canon_sink *sink, struct diag *diag);
void interp_free(struct interp *interp);

/*
 * Carries out the program that `in` holds, to its end; `name` stands in the
 * messages, and its folder is where subprograms in files of their own are
 * looked for, unless it is "<stdin>". Memory does not grow with the length of
 * the program, but with its labels and named parameters, up to a limit. False:
 * a fault was reported, at its place and with the calls that led there, or the
 * sink said stop.
 */
bool interp_run(struct interp *interp, FILE *in, const char *name);

/* Lines of the program itself that have been read so far. */
long interp_lines(const struct interp *interp);

#endif
