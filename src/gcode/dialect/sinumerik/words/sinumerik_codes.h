/* sinumerik_codes.h - G-codes, words and addresses of the 840D, and how each is treated. */
#ifndef FIVECHECK_GCODE_DIALECT_SINUMERIK_WORDS_SINUMERIK_CODES_H
#define FIVECHECK_GCODE_DIALECT_SINUMERIK_WORDS_SINUMERIK_CODES_H

#include "gcode/code.h"

/* The G groups of the 840D that matter here. A block may have one code of each group. */
enum sinumerik_group {
	SINUMERIK_MOTION,	/* group 1 */
	SINUMERIK_ONCE,	/* group 2: G4, G74, G75 ... */
	SINUMERIK_PLANE,
	SINUMERIK_CUTTER,
	SINUMERIK_SYSTEM,	/* G500, G54 ... */
	SINUMERIK_SUPPRESSION,	/* G53, G153, SUPA */
	SINUMERIK_PATH,	/* G60, G64, G641 ... */
	SINUMERIK_UNITS,
	SINUMERIK_DISTANCE,
	SINUMERIK_FEED,
	SINUMERIK_TRANSFORM,	/* TRAORI, TRAFOOF */
	SINUMERIK_FRAME,	/* TRANS, ROT ... */
	SINUMERIK_ORI_SYSTEM,	/* ORIWKS, ORIMKS */
	SINUMERIK_ORI_WAY,	/* ORIAXES, ORIVECT */
	SINUMERIK_COMPRESSOR,	/* COMPOF, COMPCAD ... */
	SINUMERIK_CORNER,	/* G450, G451 */
	SINUMERIK_APPROACH,	/* NORM, KONT */
	SINUMERIK_CUT,	/* CUT2D, CUT2DF */
	SINUMERIK_ORI_SMOOTHING,	/* ORISON, ORISOF */
	SINUMERIK_TOOL_FRAME,	/* group 53: TOROT, TOROTOF */
	SINUMERIK_ORI_ANGLES,	/* group 50: ORIEULER, ORIRPY, ORIRPY2 */
	SINUMERIK_SOFT,	/* G147, G148 ... */
	SINUMERIK_SOFT_SIDE,	/* group 43: G140 to G143 */
	SINUMERIK_SOFT_WAY,	/* group 44: G340, G341 */
	SINUMERIK_GROUPS
};

/* Codes of words; G-codes are their numbers in tenths. */
enum {
	SINUMERIK_CIP = 100000,
	SINUMERIK_SUPA,
	SINUMERIK_TRAORI,
	SINUMERIK_TRAFOOF,
	SINUMERIK_ORIWKS,
	SINUMERIK_ORIMKS,
	SINUMERIK_ORIAXES,
	SINUMERIK_ORIVECT,
	SINUMERIK_COMPOF,
	SINUMERIK_COMPON,
	SINUMERIK_ORISON,
	SINUMERIK_ORISOF,
	SINUMERIK_NORM,
	SINUMERIK_KONT,
	SINUMERIK_CUT2D,
	SINUMERIK_CUT2DF,
	SINUMERIK_TOROT,
	SINUMERIK_TOROTOF,
	SINUMERIK_ORIEULER,
	SINUMERIK_ORIRPY,
	SINUMERIK_ORIRPY2,
	SINUMERIK_CT,
	/* Frame codes: SINUMERIK_FRAME_CODES + 2 * enum sinumerik_frame_code + (the A... form). */
	SINUMERIK_FRAME_CODES = 100100
};

#define SINUMERIK_G(number) ((number) * 10)

/* G25 and G26 limit the working area or the spindle speed. */
static inline bool sinumerik_is_limit(int code)
{
	return code == SINUMERIK_G(25) || code == SINUMERIK_G(26);
}

/* Addresses of more than one letter, or of a letter and a number; '=' follows them. */
enum sinumerik_address {
	SINUMERIK_CR, SINUMERIK_AR, SINUMERIK_TURN, SINUMERIK_I1, SINUMERIK_J1, SINUMERIK_K1, SINUMERIK_A3,
	SINUMERIK_B3, SINUMERIK_C3, SINUMERIK_RPL, SINUMERIK_ADIS, SINUMERIK_ADISPOS, SINUMERIK_CTOL, SINUMERIK_OTOL,
	SINUMERIK_STOLF, SINUMERIK_DISC, SINUMERIK_CHF, SINUMERIK_AP, SINUMERIK_RP,
	SINUMERIK_CHR, SINUMERIK_RND, SINUMERIK_FP, SINUMERIK_A2, SINUMERIK_B2, SINUMERIK_C2,
	SINUMERIK_OFFN, SINUMERIK_ANG, SINUMERIK_DISR, SINUMERIK_DISCL, SINUMERIK_DISRP, SINUMERIK_FAD,
	SINUMERIK_ADDRESSES
};

enum sinumerik_word_kind {
	SINUMERIK_WORD_CODE,	/* a code: group and code */
	SINUMERIK_WORD_ADDRESS,	/* '=' and a value: an enum sinumerik_address */
	SINUMERIK_WORD_IGNORED,	/* a word alone */
	SINUMERIK_WORD_IGNORED_VALUE,	/* an optional [axis], '=' and a value, which is read and ignored */
	SINUMERIK_WORD_ZERO,	/* an optional [axis], '=' and 0, which cancels something; other values are refused */
	SINUMERIK_WORD_IGNORED_CALL,	/* optional parentheses; their contents are skipped */
	SINUMERIK_WORD_IGNORED_LINE,	/* the rest of the line is skipped */
	SINUMERIK_WORD_MASTER,	/* SETMS */
	SINUMERIK_WORD_COUPLING,	/* TRAILON */
	SINUMERIK_WORD_MODAL,	/* MCALL */
	SINUMERIK_WORD_STATEMENT,	/* flow and declarations: read before the block */
	SINUMERIK_WORD_STOPS_READING,	/* STOPRE: the following blocks are read when all blocks before are complete */
	SINUMERIK_WORD_POSITION,	/* POS[axis]= */
	SINUMERIK_WORD_SPINDLE_STANDS,	/* SPOS=: the spindle is stopped at an angle */
	SINUMERIK_WORD_REFUSED
};

struct sinumerik_word {
	enum sinumerik_word_kind kind;
	enum sinumerik_group group;
	int code;
	const char *what;
};

/* The word with this upper-case name. False: there is none. */
bool sinumerik_codes_word(const char *name, struct sinumerik_word *word);

/* The rows of the dialect's table: G-codes with an enum sinumerik_group as group, M-codes, and words. */
extern const struct code_set sinumerik_g_codes, sinumerik_offset_codes, sinumerik_m_codes;
extern const struct word_set sinumerik_word_set, sinumerik_cycle_set;

#endif
