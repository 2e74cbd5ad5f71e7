/* codes.h - which G and M codes each dialect knows, their modal groups, and what the unsupported ones would do. */
#ifndef FIVECHECK_GCODE_CODES_H
#define FIVECHECK_GCODE_CODES_H

#include "gcode/interp.h"

/* G codes are numbered by tenths: G43.4 is 434. */
enum {
	G0 = 0,
	G1 = 10,
	G2 = 20,
	G3 = 30,
	G4 = 40,
	G10 = 100,
	G17 = 170,
	G18 = 180,
	G19 = 190,
	G20 = 200,
	G21 = 210,
	G28 = 280,
	G28_1 = 281,
	G30 = 300,
	G30_1 = 301,
	G43 = 430,
	G43_4 = 434,
	G49 = 490,
	G52 = 520,
	G53 = 530,
	G54 = 540,
	G59 = 590,
	G61 = 610,
	G61_1 = 611,
	G64 = 640,
	G80 = 800,
	G90 = 900,
	G90_1 = 901,
	G91 = 910,
	G92 = 920,
	G92_1 = 921,
	G92_2 = 922,
	G92_3 = 923,
	G93 = 930,
	G94 = 940,
	G95 = 950
};

/*
 * Modal groups: NIST RS274/NGC interpreter version 3, table 4; LinuxCNC's
 * manual, "G Code Modal Groups". Of each group a block may hold one code.
 */
enum g_group {
	G_NONMODAL,
	G_MOTION,
	G_PLANE,
	G_DISTANCE,
	G_ARC_DISTANCE,
	G_FEED_MODE,
	G_UNITS,
	G_CUTTER,
	G_LENGTH,
	G_RETRACT,
	G_SYSTEM,
	G_PATH,
	G_SPINDLE,
	G_GROUPS
};

enum m_group { M_STOP, M_TOOL, M_SPINDLE, M_COOLANT, M_TCP, M_GROUPS };

#define GROUP_UNSUPPORTED (-1)

struct code {
	short number;	/* tenths for G codes */
	short dialects;	/* bits 1 << enum gcode_dialect */
	short group;	/* enum g_group or m_group, or GROUP_UNSUPPORTED */
	const char *what;	/* what an unsupported code would do; else NULL */
};

/* NULL: the dialect has no such code, or none that is known here. */
const struct code *code_find_g(int number, enum gcode_dialect dialect);
const struct code *code_find_m(int number, enum gcode_dialect dialect);

const char *dialect_name(enum gcode_dialect dialect);

#endif
