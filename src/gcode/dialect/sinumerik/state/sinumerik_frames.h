/* sinumerik_frames.h - frames, and the position of the tool in program coordinates. */
#ifndef FIVECHECK_GCODE_DIALECT_SINUMERIK_STATE_SINUMERIK_FRAMES_H
#define FIVECHECK_GCODE_DIALECT_SINUMERIK_STATE_SINUMERIK_FRAMES_H

#include "gcode/execute/parallel_moves.h"
#include "gcode/state.h"

/*
 * A frame: program coordinates p become matrix p + shift, before the work offset. Rotary axes and U V W are shifted
 * only.
 */
struct sinumerik_frame {
	mat3 matrix;
	slot_values shift;	/* X Y Z: translation after the matrix */
	slot_values fine;	/* the part of the shift from ATRANS and G59, which G58 does not change */
	bool axial;	/* G58 or G59 has set a shift */
};

/* The active frames and what is not certain about them. */
struct sinumerik_frames {
	struct sinumerik_frame programmed;	/* TRANS, ROT, SCALE, MIRROR */
	struct sinumerik_frame swivel;	/* CYCLE800: under the programmable one */
	bool swivelled;
	bool tool_frame;	/* TOROT: `swivel` has the tool as its Z; its X and Y are not known */
	bool tool_upright;	/* while CYCLE800 has swivelled: the tool is parallel to the machine's Z */
	bool even;	/* the frames scale all directions equally */
	bool work_selected;	/* by the program: G500, G54 ... */
	bool unsure;	/* TRAORI or TRAFOOF may have deleted the frames */
	bool programmed_unsure;	/* CYCLE800() may have deleted the programmable frame */
	bool plane_unsure;	/* another work offset was selected while CYCLE800 has swivelled */
};

/* Where the tool is in program coordinates. */
struct sinumerik_place {
	slot_values program;	/* mm and degrees; derived from the position while `known` is false */
	bool known;
	/* An offset has changed since the axis was programmed last: its program coordinate then. */
	bool shifted[SLOT_COUNT];
	slot_values programmed;	/* NAN: not known */
};

/* The direction at the end of the last motion, in its plane; program coordinates. */
struct sinumerik_tangent {
	bool known;	/* false if the motion is too short */
	int plane;
	struct plane_point way;	/* mm: a vector in this direction */
	struct plane_point end;	/* the end of the motion, mm */
};

struct sinumerik_polar {
	struct plane_point pole;	/* program coordinates, mm */
	int plane;	/* that it was given in */
	bool has_radius, has_angle;
	double radius, angle;	/* mm, degrees: given last */
};

struct sinumerik_open_place {
	bool on;	/* after a milling cycle the tool is somewhere above its region */
	struct parallel_box box;	/* then: this box about the position; cutter_comp.loose is its extent */
};

#endif
