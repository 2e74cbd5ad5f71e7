/* code.h - G and M codes, their modal groups, and sets of the codes that a dialect knows. */
#ifndef FIVECHECK_GCODE_CODE_H
#define FIVECHECK_GCODE_CODE_H

#include <stdbool.h>
#include <stddef.h>

/* G codes are numbered by tenths: G43.4 is 434. */
enum {
	G0 = 0,
	G1 = 10,
	G2 = 20,
	G2_4 = 24,	/* arcs in space of Fanuc */
	G3 = 30,
	G3_4 = 34,
	G4 = 40,
	G5 = 50,
	G5_1 = 51,
	G5_2 = 52,
	G5_3 = 53,
	G6_2 = 62,
	G7_1 = 71,
	G8 = 80,
	G9 = 90,
	G10 = 100,
	G12 = 120,	/* circular pocket milling of Haas */
	G12_1 = 121,
	G13 = 130,
	G13_1 = 131,
	G15 = 150,
	G16 = 160,
	G17 = 170,
	G18 = 180,
	G19 = 190,
	G20 = 200,
	G21 = 210,
	G22 = 220,	/* stored stroke check of Fanuc */
	G28 = 280,
	G28_1 = 281,
	G30 = 300,
	G30_1 = 301,
	G31 = 310,	/* skip function: stops at a signal */
	G31_3 = 313,
	G33 = 330,
	G33_1 = 331,
	G38_2 = 382,
	G38_3 = 383,
	G38_4 = 384,
	G38_5 = 385,
	G40 = 400,
	G41 = 410,
	G41_1 = 411,
	G42 = 420,
	G42_1 = 421,
	G43 = 430,
	G43_1 = 431,	/* dynamic tool length offset of LinuxCNC */
	G43_2 = 432,
	G43_4 = 434,
	G43_5 = 435,
	G49 = 490,
	G50 = 500,
	G50_1 = 501,
	G51 = 510,
	G51_1 = 511,
	G52 = 520,
	G53 = 530,
	G53_1 = 531,
	G53_6 = 536,
	G54 = 540,
	G54_1 = 541,
	G54_2 = 542,
	G54_4 = 544,
	G59 = 590,
	G60 = 600,
	G61 = 610,
	G61_1 = 611,
	G62 = 620,	/* automatic corner override */
	G63 = 630,	/* tapping mode */
	G64 = 640,
	G68 = 680,
	G68_2 = 682,
	G68_4 = 684,
	G69 = 690,
	G70 = 700,	/* bolt hole circle and arc of Haas */
	G71 = 710,
	G73 = 730,
	G74 = 740,
	G76 = 760,
	G77 = 770,
	G80 = 800,
	G81 = 810,
	G82 = 820,
	G83 = 830,
	G84 = 840,
	G85 = 850,
	G86 = 860,
	G87 = 870,
	G88 = 880,
	G89 = 890,
	G90 = 900,
	G90_1 = 901,
	G91 = 910,
	G92 = 920,
	G92_1 = 921,
	G92_2 = 922,
	G92_3 = 923,
	G93 = 930,
	G94 = 940,
	G95 = 950,
	G96 = 960,
	G98 = 980,
	G99 = 990,
	G100 = 1000,
	G101 = 1010,
	G103 = 1030,
	G110 = 1100,
	G129 = 1290,
	G150 = 1500,
	G154 = 1540,
	G187 = 1870,
	G234 = 2340,
	G254 = 2540,
	G255 = 2550
};

/*
 * Modal groups: NIST RS274/NGC interpreter version 3, table 4; LinuxCNC's manual, "G Code Modal Groups". A block may
 * contain one code of each group.
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
	G_CONTOUR,	/* path accuracy: G5.1, G8, G187 */
	G_SPINDLE,
	G_ROTATION,
	G_DYNAMIC,	/* G254, G255 */
	G_MIRROR,	/* G50.1, G51.1; G100, G101 */
	G_POLAR,	/* G15, G16 */
	G_SCALING,	/* G50, G51 */
	G_APPROACH,	/* G60, valid for its block */
	G_EXACT,	/* G9, an exact stop like G61, valid for its block */
	G_GROUPS
};

enum m_group { M_STOP, M_TOOL, M_SPINDLE, M_COOLANT, M_OVERRIDE, M_OUTPUT, M_MODES, M_TCP, M_GROUPS };

/* A code that is refused, or that has no effect on the check: it may be combined with any other code. */
#define GROUP_NONE (-1)
/* A separate statement, which is read before the words of the block, such as a macro call. */
#define GROUP_STATEMENT (-2)
/* An M-code without a group that takes words such as P and Q, like the machine builder's M-codes. */
#define GROUP_OUTPUT (-3)

/* How the program treats a code or a word of a language: fivecheck-gcode(5) and --explain show it. */
enum code_state {
	CODE_READ,	/* followed exactly */
	CODE_IGNORED,	/* moves no axis and has no effect on the check */
	CODE_BOUNDED,	/* its motion is known only as a set of paths, and the whole set is proved */
	CODE_REFUSED	/* an error at the place of the code */
};

struct code {
	short number;	/* tenths for G codes */
	short group;	/* enum g_group or m_group, or one of the GROUP_... above */
	enum code_state state;
	const char *what;	/* a few words, with the manual's term: "fine boring cycle" */
};

/* Rows sorted by number. */
struct code_set {
	const struct code *rows;
	size_t count;
	short last;	/* not 0: there is one row, for its G code and the whole ones up to this, in tenths */
	const char *manual;	/* where the codes come from; NULL: the manual of the dialect */
};

#define CODE_SET_OF(array, manual) {(array), sizeof(array) / sizeof((array)[0]), 0, (manual)}
#define CODE_SET(array) CODE_SET_OF(array, NULL)
#define CODE_RUN(row, last) {&(row), 1, (last), NULL}

/* A word or a statement of a language besides its numbered codes, as programs write it: "TRAORI", "CYCL DEF 200". */
struct code_word {
	const char *word;
	enum code_state state;
	const char *what;
};

/* Rows in the order of the manuals. */
struct word_set {
	const struct code_word *rows;
	size_t count;
};

/* The most sets of one kind that a dialect can have. */
#define CODE_SETS_MAX 4

/* Looks the number up in sets[0] to the last set that is not NULL. NULL: no set has the number. */
const struct code *code_find(const struct code_set *const sets[CODE_SETS_MAX], int number);

/* Is the code a canned cycle? It drills, taps or bores at the position of the block's axis words. */
bool code_is_cycle(int number);

/* Does the code tilt the working plane (G68.2, or G68.4, which tilts the plane in force further)? */
bool code_tilts(int number);

#endif
