/* interp.h - reads a g-code program block by block and carries it out as canonical moves. */
#ifndef FIVECHECK_GCODE_INTERP_H
#define FIVECHECK_GCODE_INTERP_H

#include <stdbool.h>
#include <stddef.h>
#include <stdio.h>

#include "base/axes.h"
#include "base/diag.h"
#include "gcode/canon.h"

enum gcode_dialect { GCODE_LINUXCNC, GCODE_FANUC, GCODE_HAAS };
enum gcode_wrap { GCODE_WRAP_NONE, GCODE_WRAP_SHORTEST, GCODE_WRAP_SIGN };
enum gcode_mcode { GCODE_TCP_ON, GCODE_TCP_OFF, GCODE_IGNORE };

/* Borrowed, and constant while a program runs. Lengths in mm, angles in radians. */
struct gcode_config {
	enum gcode_dialect dialect;
	bool has_axis[SLOT_COUNT];	/* a word for an axis that the machine lacks is an error */
	enum gcode_wrap wrap[SLOT_COUNT];
	axis_values home;	/* where the program starts; G28's and G30's reference position */
	bool tcp_zero_offset;	/* rotary zero under TCP is the work offset's, else the machine's */
	bool block_delete;	/* skip blocks that start with '/' */
	bool last_duplicate_wins;	/* of a word that stands twice in a block; else it is an error */
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
};

struct interp;

/* config, sink and diag are borrowed until interp_free. */
struct interp *interp_new(const struct gcode_config *config, const struct canon_sink *sink, struct diag *diag);
void interp_free(struct interp *interp);

/*
 * Carries out the program that `in` holds, to its end; `name` stands in the
 * messages. Memory does not grow with the length of the program. False: a
 * fault was reported, at its place, or the sink said stop.
 */
bool interp_run(struct interp *interp, FILE *in, const char *name);

/* Lines read so far. */
long interp_lines(const struct interp *interp);

#endif
