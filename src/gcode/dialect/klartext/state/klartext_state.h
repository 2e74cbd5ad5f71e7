/* klartext_state.h - the state of a Heidenhain control for a program, besides the modes of every control. */
#ifndef FIVECHECK_GCODE_DIALECT_KLARTEXT_STATE_KLARTEXT_STATE_H
#define FIVECHECK_GCODE_DIALECT_KLARTEXT_STATE_KLARTEXT_STATE_H

#include <stdbool.h>

#include "base/strbuf.h"
#include "gcode/dialect/klartext/state/klartext_calls.h"
#include "gcode/dialect/klartext/state/klartext_cycles.h"
#include "gcode/dialect/klartext/state/klartext_frames.h"
#include "gcode/dialect/klartext/state/klartext_paths.h"
#include "gcode/dialect/klartext/state/klartext_values.h"
#include "gcode/state.h"

/* How the lines of the program are read. */
struct klartext_lines {
	bool begun; /* BEGIN PGM has been read */
	bool behind_end; /* M2 or M30 has been carried out: only END PGM may follow */
	bool numbered; /* the current line has a block number */
	bool comment_goes_on; /* '~' at the end of a comment */
	bool tail_goes_on; /* the block before ends with a comment that ends with '~' */
	bool skips, skips_next; /* a definition with '/' is skipped: also its parameters; the next line in any case */
	bool cautioned_cycle; /* the caution about CYCLE was given */
	bool cautioned_teeth; /* the caution about FZ was given */
	struct strbuf joined; /* a block or a formula of several lines */
};

/* What TOOL DEF and TOOL CALL have said. */
struct klartext_tool {
	bool called; /* the program has called a tool */
	bool change_pending; /* TOOL CALL was the last block: M6 belongs to it */
	bool moved; /* axes have moved since TOOL CALL */
	bool oversize; /* TOOL CALL has given DL, DR or DR2 */
	double delta_radius, delta_length; /* mm: DR and DL of TOOL CALL */
	int defined; /* TOOL DEF has given this tool a radius; 0: none */
	double defined_radius; /* mm */
	double feed, feed_bare; /* of TOOL CALL, for F AUTO: mm/min, and without conversion; 0: none */
};

struct klartext {
	bool inch;
	struct klartext_lines lines;
	struct klartext_values values;
	struct klartext_strings strings;
	struct klartext_sync sync;
	struct klartext_calls calls;
	struct klartext_tool tool;
	bool per_revolution; /* M136 */
	struct klartext_preset preset;
	struct klartext_frame frame;
	struct klartext_shift shift;
	struct klartext_stay stay;
	struct klartext_cycle_19 cycle_19;
	struct klartext_rotary rotary;
	struct klartext_tcpm tcpm;
	vec3 programmed; /* the end of the last move in the coordinates of that time, mm: the start of increments */
	struct klartext_path last; /* the move before, for CT and corners */
	struct klartext_pole pole;
	struct klartext_free free;
	struct klartext_corner corner;
	struct klartext_approach approach;
	struct klartext_crossing crossing;
	struct klartext_open open;
	struct klartext_cycles cycles;
	struct klartext_globals globals;
	struct klartext_contour contour;
	struct klartext_points points;
};

static inline struct klartext *klartext_of(const struct interp *interp)
{
	return interp->dialect_state;
}

void *klartext_state_new(void);
void klartext_state_free(void *state);

#endif
