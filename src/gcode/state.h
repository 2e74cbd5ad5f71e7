/* state.h - what the interpreter remembers between blocks: modes, offsets, where the axes are. */
#ifndef FIVECHECK_GCODE_STATE_H
#define FIVECHECK_GCODE_STATE_H

#include <stdbool.h>

#include "gcode/block.h"
#include "gcode/canon.h"
#include "gcode/fault.h"
#include "gcode/interp.h"
#include "gcode/reader.h"

/* G54 to G59.3 */
#define SYSTEM_COUNT 9

/* One value a slot, in mm and degrees: as programs speak, so that no position drifts by being converted. */
typedef struct slot_values {
	double v[SLOT_COUNT];
} slot_values;

enum feed_mode { FEED_PER_MINUTE, FEED_PER_REVOLUTION, FEED_INVERSE_TIME };

enum tcp_source { TCP_OFF, TCP_BY_LENGTH, TCP_BY_MCODE };	/* G43.4, and the machine's own M-code */

struct state {
	slot_values position;	/* of the controller's axes, as canon.h has it */
	axis_values canonical;	/* the same in mm and radians */
	slot_values offset;	/* program coordinates + offset = position; derived */
	int motion;	/* G0 to G3, or CODE_NONE */
	int plane;	/* G17, G18, G19 */
	bool incremental;
	bool arc_absolute;
	double scale;	/* mm per unit of length */
	enum feed_mode feed_mode;
	double feed_linear;	/* mm per minute or revolution; 0: none given */
	double feed_angular;	/* degrees per minute or revolution */
	double speed;	/* revolutions per minute */
	int system;	/* 0 is G54 */
	slot_values work[SYSTEM_COUNT];
	bool work_known[SYSTEM_COUNT];	/* by the setup or by G10; or else it was said that it is 0 */
	slot_values shift;	/* of G52 and G92 */
	slot_values saved_shift;	/* that G92.3 restores */
	int shift_code;	/* G52 or G92, whichever made the shift */
	double length;	/* mm: length compensation in force */
	enum tcp_source tcp;
	axis_values rotary_zero;	/* as the sink was told last */
	slot_values reference[2];	/* machine positions of G28 and G30 */
	int tool;	/* in the spindle */
	int selected;	/* by T, or -1 */
	bool blend;
	double blend_tolerance;
};

struct interp {
	const struct gcode_config *config;
	const struct canon_sink *sink;
	struct diag *diag;
	struct line_reader reader;
	struct line_place at;	/* the block being carried out */
	struct block block;
	struct state state;
	struct block_cautions cautions;
	bool cautioned_length;	/* what G43 and G49 move on some controls */
	bool cautioned_half_turn;
	bool percent;	/* the program is enclosed in '%' lines */
	bool begun;	/* a block has been read */
	bool ended;
	int moves;	/* of the block so far */
};

/* At the start of a program: LinuxCNC's manual, "G-code defaults"; the axes at home, lengths in mm. */
void state_init(struct state *state, const struct gcode_config *config);

/* Recomputes state->offset after a change of anything that it is made of. */
void state_update_offset(struct state *state);

/* Puts the axes elsewhere. */
void state_set_position(struct state *state, int slot, double value);

/* "G54" for 0 ... "G59.3" for 8. */
const char *state_system_name(int system);

/* Degrees (or mm) of a value of the configuration: the short decimal that its file had, where there is one. */
double state_from_canonical(int slot, double value);

#endif
